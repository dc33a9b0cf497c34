// What holds of every method that keeps a mip chain or the texture itself; summed-area tables have their own
// tests (summed_area_test.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "tests/support/footprints.h"
#include "texture/catalogue.h"
#include "texture/mip_chain.h"

namespace zproof::texture {
namespace {

constexpr double unit_roundoff = 0x1p-53;

std::vector<std::string> methods_of_texels() {
    std::vector<std::string> names;
    for (const Method& method : methods())
        if (!method.name.starts_with("sat-")) names.push_back(method.name);
    return names;
}

Sampler prepared(const std::string& name, const LinearImage& image, const FilterOptions& options = {}) {
    return find_method(name)->prepare(image, options);
}

double distance(const glm::dvec4& a, const glm::dvec4& b) {
    double most = 0;
    for (int i = 0; i < 4; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

class EveryMethod : public testing::TestWithParam<std::string> {
  protected:
    static const Method& method() { return *find_method(GetParam()); }
    static constexpr std::uint32_t footprints = 200;
};

/// Each weight carries the roundings of a few products and quotients, each sum one more a tap.
double roundings(std::size_t taps) { return (double(taps) + 16) * unit_roundoff; }

TEST_P(EveryMethod, HasWeightsOfSumOne) {
    const Sampler sampler = method().prepare(random_image(48, 33, 1), {});
    for (std::uint32_t seed = 0; seed < footprints; ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<Tap> taps = sampler.taps(random_footprint(seed));
        double sum = 0, absolute = 0;
        for (const Tap& tap : taps) {
            sum += tap.weight;
            absolute += std::abs(tap.weight);
        }
        EXPECT_LE(std::abs(sum - 1), roundings(taps.size()) * absolute);
    }
}

TEST_P(EveryMethod, ReadsStoredTexelsOnly) {
    const Sampler sampler = method().prepare(random_image(48, 33, 1), {});
    for (std::uint32_t seed = 0; seed < footprints; ++seed)
        for (const Tap& tap : sampler.taps(random_footprint(seed))) {
            ASSERT_LT(std::size_t(tap.image), sampler.stored.size()) << seed;
            const StoredImage& image = sampler.stored[std::size_t(tap.image)];
            ASSERT_TRUE(tap.column >= 0 && tap.column < image.width && tap.row >= 0 &&
                        tap.row < image.height);
        }
}

/// The shares of what is stored sum to 1, so that they need no tolerance but that of their sum.
TEST_P(EveryMethod, StoresMeansOfTheTexture) {
    for (const MipKernel kernel : {MipKernel::box, MipKernel::polyphase, MipKernel::lanczos3}) {
        const Sampler sampler = method().prepare(random_image(20, 9, 1), {.mip_kernel = kernel});
        for (const StoredImage& image : sampler.stored) {
            double sum = 0;
            for (const Share& share : image.made_of(image.width / 2, image.height / 2))
                sum += share.weight * share.columns * share.rows;
            EXPECT_NEAR(sum, 1, 0x1p-48);
        }
    }
}

/// Absolute weights of bicubic and of Lanczos chains sum to less than 2 an axis.
TEST_P(EveryMethod, KeepsAConstant) {
    const glm::vec4 value{0.25f, 0.5f, 1, 0.75f};
    for (const MipKernel kernel : {MipKernel::box, MipKernel::polyphase, MipKernel::lanczos3}) {
        const Sampler sampler = method().prepare(constant_image(37, 64, value), {.mip_kernel = kernel});
        for (std::uint32_t seed = 0; seed < footprints; ++seed) {
            const Footprint f = random_footprint(seed);
            const double chain = kernel == MipKernel::lanczos3 ? 6 * 4 * 0x1p-24 : 6 * 0x1p-24;
            EXPECT_LE(distance(sampler.colour(f), glm::dvec4{value}),
                      4 * roundings(sampler.taps(f).size()) + chain)
                << seed;
        }
    }
}

TEST_P(EveryMethod, StaysWithinTheTexelsRangeUnlessItsCardSaysOtherwise) {
    if (method().card.taps.find("may leave the texels' range") != std::string::npos) return;
    const LinearImage image = random_image(48, 33, 1);
    glm::vec4 low{1}, high{0};
    for (const glm::vec4& texel : image.texels) low = glm::min(low, texel), high = glm::max(high, texel);
    const Sampler sampler = method().prepare(image, {});
    for (std::uint32_t seed = 0; seed < footprints; ++seed) {
        const Footprint f = random_footprint(seed);
        const glm::dvec4 colour = sampler.colour(f), slack{roundings(sampler.taps(f).size())};
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(colour, glm::dvec4{low} - slack))) << seed;
        EXPECT_TRUE(glm::all(glm::lessThanEqual(colour, glm::dvec4{high} + slack))) << seed;
    }
}

/// Repetition by whole sizes and reflection change nothing; centres stay multiples of 2^-20 texels, so that
/// moving them is exact.
TEST_P(EveryMethod, WrapsAsItIsTold) {
    const LinearImage image = random_image(16, 16, 4);
    for (std::uint32_t seed = 0; seed < footprints; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice{seed};
        const auto grid = [&](double most) {
            return std::floor(dice.between(-most, most) * 0x1p10) * 0x1p-10;
        };
        const glm::dvec2 centre{grid(16), grid(16)}, x{grid(8), grid(8)}, y{grid(8), grid(8)};
        const auto colour = [&](Wrap wrap, const glm::dvec2& moved) {
            return method()
                .prepare(image, {.addressing = {wrap, wrap}, .mip_kernel = MipKernel::box})
                .colour(flat_footprint(centre + moved, x, y));
        };
        const double slack = 1000 * unit_roundoff;
        EXPECT_LE(distance(colour(Wrap::repeat, {0, 0}), colour(Wrap::repeat, {-32, 16})), slack);
        EXPECT_LE(distance(colour(Wrap::mirrored_repeat, {0, 0}), colour(Wrap::mirrored_repeat, {32, -64})),
                  slack);
        EXPECT_LE(distance(colour(Wrap::clamp_to_edge, {4096, 4096}), glm::dvec4{image.at(15, 15)}), 1)
            << "beyond the edge only the edge is seen";
    }
}

TEST_P(EveryMethod, TakesAnyFootprint) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Sampler sampler = method().prepare(random_image(16, 24, 4), {.max_anisotropy = 64});
    for (const double strange : {0.0, std::nan(""), infinity, -infinity, 1e300, -1e300, 1e-300, 1e9})
        for (int place = 0; place < 12; ++place) {
            Footprint f = flat_footprint({3, 5}, {2, 1}, {-1, 3});
            double* const places[] = {&f.per_x.x,
                                      &f.per_x.y,
                                      &f.per_y.x,
                                      &f.per_y.y,
                                      &f.centre.x,
                                      &f.centre.y,
                                      &f.texels_from_raster.u.a,
                                      &f.texels_from_raster.u.c,
                                      &f.texels_from_raster.v.b,
                                      &f.texels_from_raster.w.a,
                                      &f.texels_from_raster.w.c,
                                      &f.centre_raster.x};
            *places[place] = strange;
            std::size_t taps = 0;
            for (const Tap& tap : sampler.taps(f)) {
                ASSERT_TRUE(tap.column >= 0 && tap.row >= 0);
                ++taps;
            }
            EXPECT_GE(taps, 1u);
            EXPECT_LE(taps, 2u * 259 * 259) << strange << " at " << place;
        }
}

TEST_P(EveryMethod, ReadsTheLastLevelForAHugeFootprint) {
    const LinearImage image = random_image(16, 16, 4);
    const Sampler sampler = method().prepare(image, {.mip_kernel = MipKernel::polyphase});
    if (sampler.stored.size() == 1) return;  // level 0 alone
    const glm::dvec4 mean{mip_chain(image, MipKernel::polyphase).back().texels[0]};
    const Footprint huge = flat_footprint({3, 5}, {1e7, 2e6}, {-2e6, 1e7});
    // A ripmap halves in another order: 4 halvings across and 4 down, each rounded to float32.
    EXPECT_LE(distance(sampler.colour(huge), mean), roundings(sampler.taps(huge).size()) + 8 * 0x1p-24);
}

TEST_P(EveryMethod, HasADefinitionCard) {
    const DefinitionCard& card = method().card;
    for (const std::string& part : {card.footprint, card.lod, card.taps, card.source})
        EXPECT_FALSE(part.empty());
}

INSTANTIATE_TEST_SUITE_P(Texels, EveryMethod, testing::ValuesIn(methods_of_texels()), [](const auto& test) {
    std::string name = test.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST(Catalogue, NamesAreUniqueAndFound) {
    std::set<std::string> names;
    for (const Method& method : methods()) {
        EXPECT_TRUE(names.insert(method.name).second) << method.name;
        EXPECT_EQ(find_method(method.name), &method);
    }
    EXPECT_EQ(find_method("no-such-method"), nullptr);
}

TEST(Trilinear, AtAWholeLodIsBilinearOfThatLevel) {
    const LinearImage image = random_image(64, 64, 8);
    const auto levels = mip_chain(image, MipKernel::box);
    for (int level = 0; level < int(levels.size()); ++level) {
        const double texels = std::exp2(level);
        const Footprint f = flat_footprint({37.25, 11.5}, {texels, 0}, {0, texels});
        const Footprint there = flat_footprint(f.centre / texels, {1, 0}, {0, 1});
        const glm::dvec4 bilinear = prepared("bilinear", levels[std::size_t(level)]).colour(there);
        for (const char* name : {"trilinear-gl", "trilinear-ellipse", "trilinear-rms", "trilinear-area",
                                 "trilinear-oiio", "mip-nearest-bilinear"})
            EXPECT_LE(distance(prepared(name, image).colour(f), bilinear), roundings(8)) << name << level;
        const Footprint half = flat_footprint(f.centre, f.per_x / 2.0, f.per_y / 2.0);
        EXPECT_LE(distance(prepared("trilinear-pbrt", image).colour(half), bilinear), roundings(8)) << level;
    }
}

/// Half an octave on: OpenGL blends half and half, OpenImageIO by sqrt(2) - 1.
TEST(Trilinear, BlendsByTheLogarithmAndOpenImageIoByTheWidth) {
    const LinearImage image = random_image(64, 64, 8);
    const double texels = std::sqrt(2.0) * 2;
    const Footprint f = flat_footprint({37.25, 11.5}, {texels, 0}, {0, texels});
    const auto coarser_share = [&](const char* name) {
        double sum = 0;
        for (const Tap& tap : prepared(name, image).taps(f))
            if (tap.image == 2) sum += tap.weight;
        return sum;
    };
    EXPECT_NEAR(coarser_share("trilinear-gl"), 0.5, 1e-14);
    EXPECT_NEAR(coarser_share("trilinear-oiio"), std::sqrt(2.0) - 1, 1e-14);
}

TEST(Anisotropic, OfOneTapIsTrilinear) {
    const LinearImage image = random_image(64, 32, 8);
    const FilterOptions one{.max_anisotropy = 1};
    const auto differ = [&](const char* name, const char* trilinear, const Footprint& f) {
        return distance(prepared(name, image, one).colour(f), prepared(trilinear, image).colour(f));
    };
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        const Footprint f = random_footprint(seed);
        EXPECT_EQ(differ("aniso-ext", "trilinear-gl", f), 0);
        EXPECT_EQ(differ("aniso-midpoint", "trilinear-gl", f), 0);
        EXPECT_LE(differ("aniso-d3d11", "trilinear-ellipse", f), roundings(8));
        EXPECT_LE(differ("aniso-feline", "trilinear-ellipse", f), roundings(8));
    }
    const Footprint square = flat_footprint({3.3, 7.9}, {0, 5}, {-5, 0});
    EXPECT_LE(distance(prepared("aniso-oiio", random_image(64, 64, 8)).colour(square),
                       prepared("trilinear-oiio", random_image(64, 64, 8)).colour(square)),
              roundings(8));
}

/// Where the trilinear taps stand: the centroids of the reads of one level.
std::vector<glm::dvec2> tap_places(const char* name, const Footprint& f, const FilterOptions& options) {
    std::vector<glm::dvec2> places;
    const std::vector<Tap> taps = prepared(name, constant_image(256, 256, glm::vec4{1}), options).taps(f);
    for (std::size_t i = 0; i + 4 <= taps.size(); i += 4) {
        if (taps[i].image != 0) continue;
        glm::dvec2 sum{0};
        double weight = 0;
        for (std::size_t j = i; j < i + 4; ++j) {
            sum += taps[j].weight * glm::dvec2{taps[j].column + 0.5, taps[j].row + 0.5};
            weight += taps[j].weight;
        }
        places.push_back(sum / weight);
    }
    return places;
}

TEST(Anisotropic, TapsStandWhereTheirCardsSay) {
    const Footprint f = flat_footprint({100.5, 100.5}, {4, 0}, {0, 1});
    const auto expect = [&](const char* name, const std::vector<double>& offsets, int anisotropy) {
        const auto places = tap_places(name, f, {.max_anisotropy = anisotropy});
        ASSERT_EQ(places.size(), offsets.size()) << name;
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            EXPECT_NEAR(places[i].x, 100.5 + offsets[i], 1e-12) << name;
            EXPECT_NEAR(places[i].y, 100.5, 1e-12) << name;
        }
    };
    expect("aniso-ext", {-1.2, -0.4, 0.4, 1.2}, 16);
    expect("aniso-midpoint", {-1.5, -0.5, 0.5, 1.5}, 16);
    expect("aniso-d3d11", {-1.5, -0.5, 0.5, 1.5}, 16);
    expect("aniso-oiio", {-18 / 7.0, -12 / 7.0, -6 / 7.0, 0, 6 / 7.0, 12 / 7.0, 18 / 7.0}, 16);
    expect("aniso-feline", {-3, -2, -1, 0, 1, 2, 3}, 16);
}

TEST(Anisotropic, TakesAtMostTheAllowedTaps) {
    const LinearImage image = random_image(64, 64, 3);
    for (const int most : {1, 2, 8, 64})
        for (std::uint32_t seed = 0; seed < 50; ++seed) {
            const Footprint f = random_footprint(seed);
            const FilterOptions options{.max_anisotropy = most};
            for (const char* name : {"aniso-ext", "aniso-midpoint", "aniso-d3d11"})
                EXPECT_LE(prepared(name, image, options).taps(f).size(), 8u * unsigned(most)) << name << seed;
            for (const char* name : {"aniso-oiio", "aniso-feline"})
                EXPECT_LE(prepared(name, image, options).taps(f).size(), 8u * unsigned(2 * most - 1))
                    << name << seed;
        }
}

TEST(Ripmap, OfABoxOnTheGridIsItsMean) {
    const LinearImage image = random_image(64, 64, 9);
    const Footprint f = flat_footprint({24, 34}, {16, 0}, {0, 4});  // texels 16 to 31 by 32 to 35
    glm::dvec4 sum{0};
    for (int row = 32; row < 36; ++row)
        for (int column = 16; column < 32; ++column) sum += glm::dvec4{image.at(column, row)};
    // Four halvings across and two down, each rounded to float32.
    EXPECT_LE(distance(prepared("ripmap", image).colour(f), sum / 64.0), 6 * 0x1p-24);
}

/// By the definition alone: every texel of the level, far and wide.
glm::dvec4 brute_ewa(const LinearImage& image, const Footprint& f) {
    const double a = f.per_x.y * f.per_x.y + f.per_y.y * f.per_y.y + 1,
                 b = -2 * (f.per_x.x * f.per_x.y + f.per_y.x * f.per_y.y),
                 c = f.per_x.x * f.per_x.x + f.per_y.x * f.per_y.x + 1, size = a * c - b * b / 4;
    glm::dvec4 sum{0};
    double weights = 0;
    for (int row = -60; row < 120; ++row)
        for (int column = -60; column < 120; ++column) {
            const glm::dvec2 d = glm::dvec2{column + 0.5, row + 0.5} - f.centre;
            const double r2 = (a * d.x * d.x + b * d.x * d.y + c * d.y * d.y) / size;
            if (r2 >= 1) continue;
            const double weight = std::exp(-2 * r2) - std::exp(-2.0);
            sum += weight *
                   glm::dvec4{image.at(wrapped(Wrap::repeat, column, 32), wrapped(Wrap::repeat, row, 32))};
            weights += weight;
        }
    return sum / weights;
}

TEST(Ewa, IsTheWeightedSumOverItsEllipse) {
    const LinearImage image = random_image(32, 32, 10);
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        Dice dice{seed};
        const double turn = dice.between(0, 7), length = dice.between(1, 12);
        const glm::dvec2 along{std::cos(turn), std::sin(turn)}, across{-along.y, along.x};
        // The shorter radius is 1, so that level 0 alone is read.
        const Footprint f =
            flat_footprint({dice.between(0, 32), dice.between(0, 32)}, length * along, across);
        const glm::dvec4 brute = brute_ewa(image, f);
        EXPECT_LE(distance(prepared("ewa-pbrt", image).colour(f), brute), 1e-12) << seed;
        EXPECT_LE(distance(prepared("ewa-true", image).colour(f), brute), 1e-12) << seed;
        EXPECT_LE(distance(prepared("ewa-pbrt-table", image).colour(f), brute), 0.05) << seed;
    }
}

TEST(Ewa, BiasScalesTheEllipse) {
    const LinearImage image = random_image(32, 32, 10);
    const Footprint f = flat_footprint({7.3, 9.1}, {4, 3}, {-1, 2}),
                    twice = flat_footprint(f.centre, 2.0 * f.per_x, 2.0 * f.per_y);
    for (const char* name : {"ewa-pbrt", "ewa-pbrt-table", "ewa-true"})
        EXPECT_LE(
            distance(prepared(name, image, {.lod_bias = 1}).colour(f), prepared(name, image).colour(twice)),
            1e-12)
            << name;
}

TEST(Bicubic, HitsTexelsAndKeepsALine) {
    LinearImage image = random_image(16, 16, 2);
    const Sampler noise = prepared("bicubic", image);
    EXPECT_LE(distance(noise.colour(flat_footprint({5.5, 7.5}, {1, 0}, {0, 1})), glm::dvec4{image.at(5, 7)}),
              roundings(16));
    for (int row = 0; row < 16; ++row)
        for (int column = 0; column < 16; ++column)
            image.at(column, row) = glm::vec4{float(column), float(row), float(column + row), 1};
    const glm::dvec4 colour = prepared("bicubic", image).colour(flat_footprint({6.8, 9.1}, {1, 0}, {0, 1}));
    EXPECT_LE(distance(colour, {6.3, 8.6, 14.9, 1}), 1e-13);
}

TEST(Supersample, IsTheMeanOfThePlacesSeen) {
    const LinearImage image = random_image(16, 16, 2);
    const Footprint f = random_footprint(5);
    glm::dvec4 sum{0};
    const Sampler bilinear = prepared("bilinear", image);
    for (const double y : {1 / 6.0, 0.5, 5 / 6.0})
        for (const double x : {1 / 6.0, 0.5, 5 / 6.0}) sum += bilinear.colour({.centre = f.at({x, y})});
    const Sampler nine = prepared("supersample-bilinear", image, {.subdivisions = 3});
    // A place some hundred texels out carries that many roundoffs, and values differ by at most 1 a texel.
    EXPECT_LE(distance(nine.colour(f), sum / 9.0), 4096 * unit_roundoff);
}

}  // namespace
}  // namespace zproof::texture
