#include "filters/stored/mip_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "filters/methods/catalogue.h"
#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

constexpr MipKernel kernels[] = {MipKernel::box, MipKernel::polyphase, MipKernel::lanczos3,
                                 MipKernel::kaiser3};
constexpr Wrap wraps[] = {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat};
constexpr double float_roundoff = 0x1p-24;

glm::dvec4 mean(const LinearImage& image) {
    glm::dvec4 sum{0};
    for (const glm::vec4& texel : image.texels) sum += glm::dvec4{texel};
    return sum / double(image.texels.size());
}

/// The largest of the channels' differences.
double largest_difference(const glm::dvec4& a, const glm::dvec4& b) {
    double most = 0;
    for (int i = 0; i < 4; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

TEST(MipChain, HalvesDownToOneTexel) {
    const std::vector<LinearImage> levels = mip_chain(random_image(13, 4, 1), MipKernel::polyphase);
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_EQ(levels[1].width, 6);
    EXPECT_EQ(levels[1].height, 2);
    EXPECT_EQ(levels[2].width, 3);
    EXPECT_EQ(levels[2].height, 1);
    EXPECT_EQ(levels[3].width, 1);
    EXPECT_EQ(levels[3].height, 1);
}

TEST(MipChain, BoxIsTheMeanOfFour) {
    const LinearImage image = random_image(8, 8, 2);
    const LinearImage half = mip_chain(image, MipKernel::box)[1];
    const glm::dvec4 four = (glm::dvec4{image.at(4, 2)} + glm::dvec4{image.at(5, 2)} +
                             glm::dvec4{image.at(4, 3)} + glm::dvec4{image.at(5, 3)}) /
                            4.0;
    EXPECT_EQ(half.at(2, 1), glm::vec4{four});
}

TEST(MipChain, PolyphaseOfPowersOfTwoIsTheBox) {
    const LinearImage image = random_image(32, 8, 3);
    const auto box = mip_chain(image, MipKernel::box), polyphase = mip_chain(image, MipKernel::polyphase);
    for (std::size_t level = 0; level < box.size(); ++level)
        EXPECT_EQ(box[level].texels, polyphase[level].texels) << level;
}

/// Guthe and Heckbert's example of five texels to two.
TEST(MipChain, PolyphaseOfFiveWeighsByTheShareOfEachTexel) {
    const AxisWeights weights = halving(5, MipKernel::polyphase, Wrap::repeat);
    ASSERT_EQ(weights.size(), 2u);
    const double expected[2][3] = {{0.4, 0.4, 0.2}, {0.2, 0.4, 0.4}};
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_EQ(weights[i][j].index, int(2 * i + j));
            EXPECT_DOUBLE_EQ(weights[i][j].weight, expected[i][j]);
        }
}

/// Each level rounds once to float32: at most one roundoff of values below 1 a level.
TEST(MipChain, PolyphaseKeepsTheMeanOfEverySize) {
    for (int width = 1; width <= 40; ++width) {
        const LinearImage image = random_image(width, 41 - width, std::uint32_t(width));
        const auto levels = mip_chain(image, MipKernel::polyphase);
        for (std::size_t level = 0; level < levels.size(); ++level)
            EXPECT_LE(largest_difference(mean(levels[level]), mean(image)), double(level) * float_roundoff)
                << width;
    }
}

TEST(MipChain, BoxKeepsTheMeanOfPowersOfTwoOnly) {
    const LinearImage even = random_image(16, 64, 5), odd = random_image(15, 15, 5);
    EXPECT_LE(largest_difference(mean(mip_chain(even, MipKernel::box).back()), mean(even)),
              6 * float_roundoff);
    EXPECT_GT(largest_difference(mean(mip_chain(odd, MipKernel::box).back()), mean(odd)), 1e-3);
}

TEST(MipChain, WeightsOfEveryKernelSumToOneAndStayWithinTheLine) {
    for (const MipKernel kernel : kernels)
        for (const Wrap wrap : wraps)
            for (int size = 1; size <= 65; ++size)
                for (const auto& line : halving(size, kernel, wrap)) {
                    double sum = 0;
                    for (const AxisShare& share : line) {
                        EXPECT_TRUE(share.index >= 0 && share.index < size);
                        sum += share.weight;
                    }
                    EXPECT_NEAR(sum, 1, 0x1p-50) << size;
                }
}

TEST(MipChain, LanczosIsTheWindowedSincOfTwelveTexels) {
    const auto line = halving(64, MipKernel::lanczos3, Wrap::repeat)[10];
    ASSERT_EQ(line.size(), 12u);
    const double pi = std::acos(-1.0), x = 0.25,
                 nearest = std::sin(pi * x) / (pi * x) * std::sin(pi * x / 3) / (pi * x / 3);
    double sum = 0;
    for (int k = 0; k < 6; ++k) {
        const double at = (k + 0.5) / 2,
                     here = std::sin(pi * at) / (pi * at) * std::sin(pi * at / 3) / (pi * at / 3);
        sum += 2 * here;
    }
    const auto weight = [&](int index) { return std::ranges::find(line, index, &AxisShare::index)->weight; };
    EXPECT_NEAR(weight(20), nearest / sum, 1e-15);
    EXPECT_NEAR(weight(21), nearest / sum, 1e-15);
    EXPECT_LT(weight(18), 0);
    EXPECT_LT(weight(23), 0);
}

/// At x = 1/4, 3/4, 5/4, ... the sine is +-sin(pi / 4), so that weights relate as 1, 1/3, -1/5, -1/7, 1/9,
/// 1/11 times I0(4 sqrt(1 - x^2 / 9)), here by its series: sum (4 - 4 x^2 / 9)^k / k!^2.
TEST(MipChain, KaiserIsTheWindowedSincOfTwelveTexels) {
    const auto line = halving(64, MipKernel::kaiser3, Wrap::repeat)[10];
    ASSERT_EQ(line.size(), 12u);
    const auto weight = [&](int index) { return std::ranges::find(line, index, &AxisShare::index)->weight; };
    constexpr double windows[] = {11.166991761128937, 10.131090089183191, 8.277911448778578,
                                  5.984046494687793,  3.681976589705809,  1.7484743382405645};
    constexpr double sines[] = {1, 1.0 / 3, -1.0 / 5, -1.0 / 7, 1.0 / 9, 1.0 / 11};
    for (int k = 0; k < 6; ++k) {
        EXPECT_NEAR(weight(21 + k) / weight(21), sines[k] * windows[k] / windows[0], 1e-14) << k;
        EXPECT_NEAR(weight(20 - k), weight(21 + k), 1e-15) << k;
    }
    EXPECT_NEAR(weight(21), 0.4430770485828463, 1e-14);
}

TEST(MipChain, LanczosReachesOverTheEdgeAsItIsTold) {
    LinearImage image = constant_image(32, 32, glm::vec4{0});
    for (int row = 0; row < 32; ++row) image.at(31, row) = glm::vec4{1};
    const auto left = [&](Wrap u) { return mip_chain(image, MipKernel::lanczos3, {.u = u})[1].at(0, 5).r; };
    EXPECT_NE(left(Wrap::repeat), 0);
    EXPECT_EQ(left(Wrap::clamp_to_edge), 0);
    EXPECT_EQ(left(Wrap::mirrored_repeat), 0);
}

TEST(MipChain, OfAConstantIsConstant) {
    const glm::vec4 value{0.3f, 0.7f, 1, 0.1f};
    for (const MipKernel kernel : kernels)
        for (const LinearImage& level : mip_chain(constant_image(37, 20, value), kernel))
            for (const glm::vec4& texel : level.texels)
                EXPECT_LE(largest_difference(glm::dvec4{texel}, glm::dvec4{value}), 6 * float_roundoff);
}

TEST(MipChain, BoxesAreToldAsOneRectangle) {
    const auto made_of = stored_mip_chain(random_image(32, 16, 6), MipKernel::box)[3].made_of(1, 1);
    ASSERT_EQ(made_of.size(), 1u);
    EXPECT_EQ(made_of[0].column, 8);
    EXPECT_EQ(made_of[0].columns, 8);
    EXPECT_EQ(made_of[0].rows, 8);
    EXPECT_EQ(made_of[0].weight, 1 / 64.0);
}

/// Level 0 weighted by what a stored value says it is made of gives that value, but for one rounding a level
/// (Lanczos: of values up to 2, by absolute weights that sum to less than 2 an axis a level).
TEST(MipChain, StoredImagesTellWhatTheyAreMadeOf) {
    const LinearImage image = random_image(45, 18, 6);
    for (const MipKernel kernel : kernels) {
        const auto levels = mip_chain(image, kernel, {Wrap::mirrored_repeat, Wrap::repeat});
        const auto stored = stored_mip_chain(image, kernel, {Wrap::mirrored_repeat, Wrap::repeat});
        ASSERT_EQ(levels.size(), stored.size());
        for (std::size_t k = 0; k < levels.size(); ++k) {
            ASSERT_EQ(levels[k].width, stored[k].width);
            ASSERT_EQ(levels[k].height, stored[k].height);
            for (int row = 0; row < levels[k].height; ++row)
                for (int column = 0; column < levels[k].width; ++column) {
                    glm::dvec4 sum{0};
                    for (const Share& share : stored[k].made_of(column, row))
                        for (int y = 0; y < share.rows; ++y)
                            for (int x = 0; x < share.columns; ++x)
                                sum += share.weight * glm::dvec4{image.at(share.column + x, share.row + y)};
                    EXPECT_LE(largest_difference(sum, glm::dvec4{levels[k].at(column, row)}),
                              double(2 * k) * 4 * float_roundoff);
                }
        }
    }
}

std::shared_ptr<const std::vector<LinearImage>> given(std::vector<LinearImage> levels) {
    return std::make_shared<const std::vector<LinearImage>>(std::move(levels));
}

/// Steps of two texels read level 1 alone, whatever it is made of.
TEST(GivenLevels, AreReadInsteadOfTheKernels) {
    const LinearImage image = constant_image(6, 4, glm::vec4{1});
    const auto levels =
        given({constant_image(3, 2, glm::vec4{0.25f}), constant_image(1, 1, glm::vec4{0.5f})});
    const Footprint two = flat_footprint({2, 3}, {2, 0}, {0, 2}),
                    four = flat_footprint({2, 3}, {4, 0}, {0, 4}),
                    far = flat_footprint({2, 3}, {400, 0}, {0, 400});
    for (const char* name : {"mip-nearest-point", "trilinear-gl", "ewa-pbrt", "stochastic-trilinear"}) {
        const Sampler sampler = find_method(name)->prepare(image, {.given_levels = levels});
        EXPECT_NEAR(sampler.colour(two).r, 0.25, 1e-15) << name;
        EXPECT_NEAR(sampler.colour(four).r, 0.5, 1e-15) << name;
        EXPECT_NEAR(sampler.colour(far).r, 0.5, 1e-15) << name;
    }
}

TEST(GivenLevels, MustHaveTheirSizes) {
    const LinearImage image = constant_image(6, 4, glm::vec4{1});
    const auto refused = [&](std::vector<LinearImage> levels) {
        try {
            mip_chain(image, {.given_levels = given(std::move(levels))});
        } catch (const MipChainError& e) {
            return std::string{e.what()};
        }
        return std::string{};
    };
    const LinearImage right = constant_image(3, 2, glm::vec4{1}), last = constant_image(1, 1, glm::vec4{1});
    EXPECT_EQ(refused({right, last}), "");
    EXPECT_EQ(refused({right}), "");  // it may end early
    EXPECT_EQ(refused({last}), "mip level 1 that is given has 1 x 1 texels: expected 3 x 2");
    EXPECT_EQ(refused({right, last, last}), "mip level 3 is given, behind a level of 1 x 1 texels");
}

}  // namespace
}  // namespace zproof::texture
