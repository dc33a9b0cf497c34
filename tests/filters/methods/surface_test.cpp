// Texels weighed by the surface that they cover, and chains made of them.
#include "texture/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "filters/methods/catalogue.h"
#include "filters/stored/mip_chain.h"
#include "filters/stored/weighted_chain.h"
#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

constexpr Addressing repeated{}, mirrored{Wrap::mirrored_repeat, Wrap::mirrored_repeat},
    clamped{Wrap::clamp_to_edge, Wrap::clamp_to_edge};

/// A triangle of so much area in the world for each texel.
SurfaceTriangle triangle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, double density = 1,
                         const Addressing& addressing = repeated) {
    const glm::dvec2 p = b - a, q = c - a;
    return {{a, b, c}, density * std::abs(p.x * q.y - p.y * q.x) / 2, addressing};
}

/// Two triangles, cut from the first corner to the third.
std::vector<SurfaceTriangle> quad(const std::array<glm::dvec2, 4>& p, double density = 1) {
    return {triangle(p[0], p[1], p[2], density), triangle(p[0], p[2], p[3], density)};
}
std::vector<SurfaceTriangle> rectangle(double left, double top, double right, double bottom,
                                       double density = 1) {
    return quad({{{left, top}, {left, bottom}, {right, bottom}, {right, top}}}, density);
}

std::vector<SurfaceTriangle> operator+(std::vector<SurfaceTriangle> a,
                                       const std::vector<SurfaceTriangle>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Half of the square of 2 x 2 texels: one texel whole, two by half.
TEST(TexelWeights, AreTheAreasThatATriangleCovers) {
    EXPECT_EQ(texel_weights({triangle({0, 0}, {2, 0}, {0, 2})}, 2, 2), (std::vector{1.0, 0.5, 0.5, 0.0}));
    // Below the line v = u / 4: an eighth of a texel, three, five, seven; the next texel is whole.
    EXPECT_EQ(texel_weights({triangle({0, 0}, {4, 0}, {4, 1}), triangle({4, 0}, {5, 0}, {4, 1}),
                             triangle({5, 0}, {5, 1}, {4, 1})},
                            5, 1),
              (std::vector{0.125, 0.375, 0.625, 0.875, 1.0}));
}

TEST(TexelWeights, GrowWithTheAreaInTheWorld) {
    EXPECT_EQ(texel_weights(rectangle(0, 0, 1, 2, 0.3) + rectangle(1, 0, 3, 2, 1.2), 4, 2),
              (std::vector{0.25, 1.0, 1.0, 0.0, 0.25, 1.0, 1.0, 0.0}));
}

TEST(TexelWeights, WrapAsTheMaterialSays) {
    const auto line = [](double left, double right, const Addressing& addressing) {
        std::vector<SurfaceTriangle> all = rectangle(left, 0, right, 1);
        for (SurfaceTriangle& triangle : all) triangle.addressing = addressing;
        return texel_weights(all, 4, 1);
    };
    const double two_thirds = std::round(0x1p25 / 3) * 0x1p-24;
    EXPECT_EQ(line(-1, 2, repeated), (std::vector{1.0, 1.0, 0.0, 1.0}));
    EXPECT_EQ(line(3, 13, repeated), (std::vector{1.0, two_thirds, two_thirds, 1.0}));
    EXPECT_EQ(line(3, 6, mirrored), (std::vector{0.0, 0.0, 0.5, 1.0}));
    EXPECT_EQ(line(-3, 2, clamped), (std::vector{1.0, 0.25, 0.0, 0.0}));
}

/// Cut up, or moved by whole textures, a surface stays the same.
TEST(TexelWeights, DoNotDependOnHowASurfaceIsCut) {
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng{seed};
        const auto place = [&] { return glm::dvec2{rng.between(-20, 50), rng.between(-20, 50)}; };
        const glm::dvec2 a = place(), b = place(), c = place(), far{7 * 13, -4 * 9};
        const glm::dvec2 within = 0.2 * a + 0.5 * b + 0.3 * c;
        const auto whole = texel_weights({triangle(a, b, c)}, 13, 9),
                   cut = texel_weights({triangle(a, b, within), triangle(within, b, c),
                                        triangle(a + far, within + far, c + far)},
                                       13, 9);
        for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(whole[i], cut[i], 0x1p-23);
    }
}

TEST(TexelWeights, OfHugeTrianglesAreEven) {
    const std::vector<double> even(12, 1.0);
    EXPECT_EQ(texel_weights({triangle({0, 0}, {2e6, 0}, {0, 1})}, 4, 3), even);
    EXPECT_EQ(texel_weights({triangle({1e15, 0}, {1e15 + 1, 0}, {1e15, 1})}, 4, 3), even);
    EXPECT_EQ(texel_weights({triangle({0, 0}, {1e300, 0}, {0, 1e300})}, 4, 3), std::vector<double>{});
    EXPECT_EQ(texel_weights({triangle({0, 0}, {1, 1}, {2, 2})}, 4, 3), std::vector<double>{});
    EXPECT_EQ(texel_weights({}, 4, 3), std::vector<double>{});
}

/// Weights 1, 1/2, 1/2, 0 of texels 0.5, 0.25, 0.125, 1: (0.5 + 0.125 + 0.0625) / 2. Beside them texels of no
/// weight.
TEST(WeightedChain, TakesMeansByWeight) {
    LinearImage image = constant_image(4, 2, glm::vec4{1});
    image.at(0, 0) = glm::vec4{0.5f}, image.at(1, 0) = glm::vec4{0.25f}, image.at(0, 1) = glm::vec4{0.125f};
    image.at(2, 0) = image.at(3, 1) = glm::vec4{0};
    const WeightedChain chain{image, {1, 0.5, 0, 0, 0.5, 0, 0, 0}, MipKernel::box};
    const auto& smaller = chain.smaller();
    ASSERT_EQ(smaller.size(), 2u);
    EXPECT_EQ(smaller[0].at(0, 0).r, 0.34375f);
    EXPECT_EQ(smaller[0].at(1, 0).r, 0.5f);  // the plain mean
    EXPECT_EQ(smaller[1].at(0, 0).r, 0.34375f);
}

/// By box on sizes of powers of two the last level is the surface's mean colour: 8 roundings to float32.
TEST(WeightedChain, EndsWithTheMeanOverTheSurface) {
    const LinearImage image = random_image(64, 32, 7);
    const std::vector<double> weights =
        texel_weights(rectangle(0, 0, 40, 32, 3) + rectangle(40, 0, 60, 20, 0.4), 64, 32);
    const WeightedChain chain{image, weights, MipKernel::box};
    glm::dvec4 sum{0};
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * glm::dvec4{image.texels[i]};
    const glm::dvec4 mean = sum / std::accumulate(weights.begin(), weights.end(), 0.0),
                     last{chain.smaller().back().texels[0]};
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(last[i], mean[i], 8 * 0x1p-25);
}

/// The same density everywhere, whatever the cuts: every bit of the plain chain.
TEST(WeightedChain, IsThePlainOneWhereTexelsCoverTheSame) {
    const auto cut_across = quad({{{0, 0}, {0, 61}, {31.3, 61}, {11.7, 0}}}, 0.7) +
                            quad({{{11.7, 0}, {31.3, 61}, {107, 61}, {107, 0}}}, 0.7);
    const LinearImage image = random_image(107, 61, 3);
    for (const MipKernel kernel : {MipKernel::box, MipKernel::polyphase}) {
        const WeightedChain chain{image, texel_weights(cut_across, 107, 61), kernel};
        const auto& smaller = chain.smaller();
        const std::vector<LinearImage> plain = mip_chain(image, kernel);
        ASSERT_EQ(smaller.size() + 1, plain.size());
        for (std::size_t i = 0; i < smaller.size(); ++i) EXPECT_EQ(smaller[i].texels, plain[i + 1].texels);
    }
}

/// What each level is said to be made of gives its texels.
TEST(WeightedChain, TellsWhatItsLevelsAreMadeOf) {
    const LinearImage image = random_image(11, 6, 5);
    const WeightedChain chain{image, texel_weights(rectangle(0, 0, 5, 4, 3) + rectangle(5, 1, 9, 6), 11, 6),
                              MipKernel::polyphase};
    const std::vector<StoredImage> stored = chain.stored();
    for (std::size_t level = 1; level < stored.size(); ++level)
        for (int row = 0; row < stored[level].height; ++row)
            for (int column = 0; column < stored[level].width; ++column) {
                glm::dvec4 sum{0};
                for (const Share& share : stored[level].made_of(column, row))
                    sum += share.weight * glm::dvec4{image.at(share.column, share.row)};
                const glm::dvec4 texel{chain.smaller()[level - 1].at(column, row)};
                for (int i = 0; i < 4; ++i) EXPECT_NEAR(sum[i], texel[i], 4 * 0x1p-25);
            }
}

}  // namespace
}  // namespace zproof::texture
