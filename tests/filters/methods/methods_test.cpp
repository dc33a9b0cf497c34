// What holds of every method that keeps a mip chain or the texture itself; summed-area tables have their own
// tests (summed_area_test.cpp, repeated_sums_test.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "filters/methods/catalogue.h"
#include "filters/stored/mip_chain.h"
#include "math/rounding.h"
#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

std::vector<std::string> methods_of_texels() {
    std::vector<std::string> names;
    for (const Method& method : methods())
        if (method.name.find("sat") == std::string::npos) names.push_back(method.name);
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
double roundings(std::size_t taps) { return (double(taps) + 16) * unit_roundoff_float64; }

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
    for (const MipKernel kernel :
         {MipKernel::box, MipKernel::polyphase, MipKernel::lanczos3, MipKernel::kaiser3}) {
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
    for (const MipKernel kernel :
         {MipKernel::box, MipKernel::polyphase, MipKernel::lanczos3, MipKernel::kaiser3}) {
        const Sampler sampler = method().prepare(constant_image(37, 64, value), {.mip_kernel = kernel});
        for (std::uint32_t seed = 0; seed < footprints; ++seed) {
            const Footprint f = random_footprint(seed);
            const double chain =
                kernel == MipKernel::lanczos3 || kernel == MipKernel::kaiser3 ? 6 * 4 * 0x1p-24 : 6 * 0x1p-24;
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

/// Repetition by whole sizes and reflection change nothing; coordinates are multiples of 2^-10 texels, so
/// that moving them is exact.
TEST_P(EveryMethod, WrapsAsItIsTold) {
    const LinearImage image = random_image(16, 16, 4);
    const auto sampler = [&](Wrap wrap) {
        return method().prepare(image, {.addressing = {wrap, wrap}, .mip_kernel = MipKernel::box});
    };
    const Sampler repeat = sampler(Wrap::repeat), mirror = sampler(Wrap::mirrored_repeat),
                  clamp = sampler(Wrap::clamp_to_edge);
    const double slack = 1000 * unit_roundoff_float64;
    for (std::uint32_t seed = 0; seed < footprints; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng{seed};
        const auto grid = [&](double most) {
            return std::floor(rng.between(-most, most) * 0x1p10) * 0x1p-10;
        };
        const glm::dvec2 centre{grid(16), grid(16)}, x{grid(8), grid(8)}, y{grid(8), grid(8)};
        const auto seen = [&](const glm::dvec2& moved) { return flat_footprint(centre + moved, x, y); };
        EXPECT_LE(distance(repeat.colour(seen({0, 0})), repeat.colour(seen({-32, 16}))), slack);
        EXPECT_LE(distance(mirror.colour(seen({0, 0})), mirror.colour(seen({32, -64}))), slack);
        const Footprint corner = flat_footprint({4096, -4096}, {0.5, 0}, {0, 0.5});
        EXPECT_LE(distance(clamp.colour(corner), glm::dvec4{image.at(15, 0)}), slack);
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
                ASSERT_TRUE(std::isfinite(tap.weight)) << strange << " at " << place;
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

/// 50 x 21, 25 x 10, 12 x 5 texels: a place keeps its share of either axis, by itself.
TEST(Trilinear, FindsItsPlaceInLevelsOfOddSizes) {
    const LinearImage image = random_image(50, 21, 8);
    const LinearImage level = mip_chain(image, MipKernel::polyphase)[2];
    const Footprint f = flat_footprint({37.25, 11.5}, {4, 0}, {0, 4}),
                    there = flat_footprint({37.25 / 50 * 12, 11.5 / 21 * 5}, {1, 0}, {0, 1});
    // A place of some ten texels, each rounded once or twice on its way.
    EXPECT_LE(distance(prepared("trilinear-gl", image).colour(f), prepared("bilinear", level).colour(there)),
              64 * unit_roundoff_float64);
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

/// LOD 1 + f: level 1 alone up to f = 1/4, level 2 alone from 3/4 on, and 2 f - 1/2 of it between.
TEST(Brilinear, BlendsInTheMiddleHalfOfAnOctaveOnly) {
    const Sampler sampler = prepared("brilinear", random_image(64, 64, 8));
    const auto coarser_share = [&](double fraction) {
        const double texels = std::exp2(1 + fraction);
        double sum = 0;
        for (const Tap& tap : sampler.taps(flat_footprint({37.25, 11.5}, {texels, 0}, {0, texels})))
            sum += tap.image == 2 ? tap.weight : 0;
        return sum;
    };
    EXPECT_EQ(coarser_share(0), 0);
    EXPECT_EQ(coarser_share(0.2499), 0);
    EXPECT_NEAR(coarser_share(0.375), 0.25, 1e-14);
    EXPECT_NEAR(coarser_share(0.5), 0.5, 1e-14);
    EXPECT_NEAR(coarser_share(0.7), 0.9, 1e-14);
    EXPECT_EQ(coarser_share(0.7501), 1);
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
        for (const char* name : {"aniso-ext", "aniso-ext-linear", "aniso-vulkan", "aniso-vulkan-linear"})
            EXPECT_EQ(differ(name, "trilinear-gl", f), 0) << name;
        EXPECT_EQ(differ("aniso-midpoint", "trilinear-gl", f), 0);
        EXPECT_LE(differ("aniso-d3d11", "trilinear-ellipse", f), roundings(8));
        EXPECT_LE(differ("aniso-feline", "trilinear-ellipse", f), roundings(8));
    }
    const Footprint square = flat_footprint({3.3, 7.9}, {0, 5}, {-5, 0});
    EXPECT_LE(distance(prepared("aniso-oiio", random_image(64, 64, 8)).colour(square),
                       prepared("trilinear-oiio", random_image(64, 64, 8)).colour(square)),
              roundings(8));
}

/// Where the bilinear reads of one level stand, and what they weigh.
struct Probe {
    glm::dvec2 place{0};
    double weight = 0;
};

std::vector<Probe> probes(const Sampler& sampler, const Footprint& f, int level) {
    std::vector<Probe> found;
    const std::vector<Tap> taps = sampler.taps(f);
    for (std::size_t i = 0; i + 4 <= taps.size(); i += 4) {
        if (taps[i].image != level) continue;
        Probe& probe = found.emplace_back();
        for (std::size_t j = i; j < i + 4; ++j) {
            probe.place += taps[j].weight * glm::dvec2{taps[j].column + 0.5, taps[j].row + 0.5};
            probe.weight += taps[j].weight;
        }
        probe.place /= probe.weight;
    }
    return found;
}

std::vector<Probe> probes_of_level_0(const char* name, const Footprint& f) {
    return probes(prepared(name, constant_image(256, 256, glm::vec4{1})), f, 0);
}

TEST(Anisotropic, TapsStandWhereTheirCardsSay) {
    const Footprint f = flat_footprint({100.5, 100.5}, {4, 0}, {0, 1});
    const auto expect = [&](const char* name, const std::vector<double>& offsets) {
        const std::vector<Probe> found = probes_of_level_0(name, f);
        ASSERT_EQ(found.size(), offsets.size()) << name;
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            EXPECT_NEAR(found[i].place.x, 100.5 + offsets[i], 1e-12) << name;
            EXPECT_NEAR(found[i].place.y, 100.5, 1e-12) << name;
        }
    };
    for (const char* name : {"aniso-ext", "aniso-ext-linear", "aniso-vulkan", "aniso-vulkan-linear"})
        expect(name, {-1.2, -0.4, 0.4, 1.2});
    expect("aniso-midpoint", {-1.5, -0.5, 0.5, 1.5});
    expect("aniso-d3d11", {-1.5, -0.5, 0.5, 1.5});
    expect("aniso-oiio", {-18 / 7.0, -12 / 7.0, -6 / 7.0, 0, 6 / 7.0, 12 / 7.0, 18 / 7.0});
    expect("aniso-feline", {-3, -2, -1, 0, 1, 2, 3});
}

/// In perspective, seen o pixels beside the centre: u = (40.5 + 3 o) / (1 + o / 64) and v = 20.5 / (1 + o /
/// 64). The steps are 2.39 and 1 texels: three taps, at o = -1/4, 0 and 1/4.
TEST(Anisotropic, TapsToTheLetterAreSeenThroughThePicture) {
    const double turn = 1 / 64.0, w_at_0 = 1 - turn / 2;
    const auto footprint_of = [&](bool is_across) {
        const Affine<double> slow{is_across ? 0.0 : 1.0, is_across ? 1.0 : 0.0, 20};
        const Affine<double> quick{is_across ? 3.0 : 0.0, is_across ? 0.0 : 3.0, 39},
            w{is_across ? turn : 0.0, is_across ? 0.0 : turn, w_at_0};
        return footprint({quick, slow, w}, 0, 0, Derivatives::analytic);
    };
    for (const char* name : {"aniso-ext", "aniso-vulkan"})
        for (const bool is_across : {true, false}) {
            const std::vector<Probe> found = probes_of_level_0(name, footprint_of(is_across));
            ASSERT_EQ(found.size(), 3u) << name;
            const double u[] = {39.75 * 256 / 255, 40.5, 41.25 * 256 / 257},
                         v[] = {20.5 * 256 / 255, 20.5, 20.5 * 256 / 257};
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_NEAR(found[i].place.x, u[i], 1e-12) << name;
                EXPECT_NEAR(found[i].place.y, v[i], 1e-12) << name;
            }
        }
    const std::vector<Probe> linear = probes_of_level_0("aniso-ext-linear", footprint_of(true));
    EXPECT_NEAR(linear[0].place.x, 40.5 - (3 - 40.5 / 64) / 4, 1e-12);
}

/// Steps of 10 and 4 texels: three taps. The ratio 2.5 leaves 4 texels a tap, level 2; rounded up it leaves
/// 10 / 3. A ratio beyond the limit is the limit for both.
TEST(Anisotropic, VulkanDoesNotRoundTheRatioInItsLod) {
    const LinearImage image = constant_image(256, 256, glm::vec4{1});
    const auto mean_level = [&](const char* name, const Footprint& f) {
        double level = 0;
        for (const Tap& tap : prepared(name, image).taps(f)) level += tap.image * tap.weight;
        return level;
    };
    const Footprint f = flat_footprint({100.5, 100.5}, {10, 0}, {0, 4}),
                    narrow = flat_footprint({100.5, 100.5}, {64, 0}, {0, 1});
    for (const char* name : {"aniso-vulkan", "aniso-vulkan-linear"}) {
        EXPECT_EQ(prepared(name, image).taps(f).size(), 3u * 4) << name;
        EXPECT_NEAR(mean_level(name, f), 2, 1e-14) << name;
        EXPECT_NEAR(mean_level(name, narrow), 2, 1e-14) << name;
    }
    EXPECT_NEAR(mean_level("aniso-ext", f), std::log2(10 / 3.0), 1e-14);
    EXPECT_NEAR(mean_level("aniso-ext", narrow), 2, 1e-14);
}

/// R = 64 and r = 2 texels, at most 16: L = 2 (64 - 16) = 96, so lookups stand 19.2 apart. Each has 16 taps,
/// 64 / 16 = 4 apart, of width 4: level 2, in texels of which everything is a quarter.
TEST(Anisotropic, EllipticalLookupsStandAndWeighWhatTheirCardSays) {
    const Footprint f = flat_footprint({200, 128}, {64, 0}, {0, 2});
    const std::vector<Probe> found =
        probes(prepared("aniso-elliptical", constant_image(512, 256, glm::vec4{1})), f, 2);
    ASSERT_EQ(found.size(), 5u * 16);
    const double near = 0.8187307530779818, far = 0.6703200460356393;  // exp(-1/5), exp(-2/5)
    const double weights[] = {far, near, 1, near, far}, sum = 1 + 2 * near + 2 * far;
    for (int lookup = 0; lookup < 5; ++lookup)
        for (int tap = 0; tap < 16; ++tap) {
            const Probe& probe = found[std::size_t(16 * lookup + tap)];
            EXPECT_NEAR(probe.place.x, (200 + 19.2 * (lookup - 2) - 30 + 4 * tap) / 4, 1e-12);
            EXPECT_NEAR(probe.place.y, 32, 1e-12);
            EXPECT_NEAR(probe.weight, weights[lookup] / sum / 16, 1e-15);
        }
}

/// R = 16 and r = 2: one lookup of 16 texels reaches as far as the line would.
TEST(Anisotropic, EllipticalIsOneLookupWhereThatReachesFarEnough) {
    const LinearImage image = random_image(64, 64, 8);
    const Footprint f = flat_footprint({31.3, 17.9}, {16, 0}, {0, 2});
    EXPECT_EQ(prepared("aniso-elliptical", image).colour(f), prepared("aniso-d3d11", image).colour(f));
}

TEST(Anisotropic, GaussianProbesWeighWhatTheirCardsSay) {
    const Footprint f = flat_footprint({100.5, 100.5}, {4, 0}, {0, 1});
    const auto ratio = [&](const char* name) {
        const std::vector<Probe> found = probes_of_level_0(name, f);
        return found.front().weight / found[3].weight;
    };
    const double d = 3 / 4.0, x = 6 / 7.0 * 4 / (2 * 3);
    EXPECT_NEAR(ratio("aniso-feline"), std::exp(-2 * d * d), 1e-14);
    EXPECT_NEAR(ratio("aniso-oiio"), std::exp(-2 * x * x), 1e-14);
}

TEST(Anisotropic, FelineRoundsItsProbesAndWidensThemWhereTheyAreFewer) {
    const auto expect = [](double minor, std::size_t count, double width) {
        const Footprint f = flat_footprint({100.5, 100.5}, {9.6, 0}, {0, minor});
        const std::vector<Tap> taps = prepared("aniso-feline", random_image(256, 256, 1)).taps(f);
        double lod = 0;
        for (const Tap& tap : taps) lod += tap.weight * tap.image;
        EXPECT_EQ(taps.size(), count * 8);
        EXPECT_NEAR(lod, std::log2(width), 1e-14);
    };
    expect(3, 5, 3.2);    // 2 R / r - 1 = 5.4: fewer probes, so wider ones, 2 * 9.6 / 6
    expect(2.8, 6, 2.8);  // 5.86: more probes, of their own width
}

TEST(Anisotropic, Direct3dSparesTapsWhereTheWidthIsBelowATexel) {
    const Footprint f = flat_footprint({100.5, 100.5}, {4, 0}, {0, 0.5});
    EXPECT_EQ(probes_of_level_0("aniso-d3d11", f).size(), 4u);
    EXPECT_EQ(probes_of_level_0("aniso-midpoint", f).size(), 8u);
}

/// 64 x 32 texels: s = u / 64, t = v / 32. Aspect 24 exceeds 16: s1 = (0.75 + 16 / 32) / 2 = 0.625, s2 =
/// 0.625 / 16; 31 probes; 1.25 texels of level 0, 0.625 of level 1, which so weighs 1/4.
TEST(OpenImageIo, LimitsAnisotropyByTheMeanOfBothMajors) {
    const Sampler sampler = prepared("aniso-oiio", constant_image(64, 32, glm::vec4{1}));
    const Footprint f = flat_footprint({31.5, 15.5}, {48, 0}, {0, 1});
    const std::vector<Tap> taps = sampler.taps(f);
    ASSERT_EQ(taps.size(), 31u * 8);
    double coarser = 0;
    for (const Tap& tap : taps) coarser += tap.image == 1 ? tap.weight : 0;
    EXPECT_NEAR(coarser, 0.25, 1e-14);
}

/// Steps that are equal in texels are not in the unit square: across it is half as long as down.
TEST(OpenImageIo, MeasuresInTheUnitSquare) {
    const Sampler sampler = prepared("aniso-oiio", constant_image(64, 32, glm::vec4{1}));
    const std::vector<Probe> found = probes(sampler, flat_footprint({31.5, 15.5}, {1, 0}, {0, 1.5}), 0);
    ASSERT_EQ(found.size(), 5u);  // aspect 3; the width is 1 / 64, half a texel of the shorter side
    const double reach = (1.5 / 32 - 1 / 64.0) * 32;
    EXPECT_NEAR(found[0].place.y, 15.5 - 0.8 * reach, 1e-12);
    EXPECT_NEAR(found[0].place.x, 31.5, 1e-12);
    EXPECT_EQ(prepared("trilinear-oiio", constant_image(64, 32, glm::vec4{1}))
                  .taps(flat_footprint({31.5, 15.5}, {2, 0}, {0, 0}))
                  .size(),
              4u);  // 2 / 64 of 32 texels is one: level 0 alone
}

/// s1 = 4 texels and s2 = 0.1 become 2.8 and 0.175; s2 counts as half a texel: aspect 5.6, ten probes.
TEST(OpenImageIo, SparesProbesOfAWidthBelowHalfATexel) {
    const Sampler sampler = prepared("aniso-oiio", constant_image(64, 64, glm::vec4{1}));
    EXPECT_EQ(probes(sampler, flat_footprint({31.5, 15.5}, {4, 0}, {0, 0.1}), 0).size(), 10u);
}

TEST(Anisotropic, TakesAtMostTheAllowedTaps) {
    const LinearImage image = random_image(64, 64, 3);
    for (const int most : {1, 2, 8, 64})
        for (std::uint32_t seed = 0; seed < 50; ++seed) {
            const Footprint f = random_footprint(seed);
            const FilterOptions options{.max_anisotropy = most};
            for (const char* name : {"aniso-ext", "aniso-ext-linear", "aniso-midpoint", "aniso-vulkan",
                                     "aniso-vulkan-linear", "aniso-d3d11"})
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

TEST(Ripmap, TakesTheLongerShareOfEitherStep) {
    const LinearImage image = random_image(64, 64, 9);
    const auto colour = [&](const glm::dvec2& x, const glm::dvec2& y) {
        return prepared("ripmap", image).colour(flat_footprint({24.3, 34.9}, x, y));
    };
    EXPECT_EQ(colour({16, 3}, {-5, 6}), colour({5, 6}, {16, -1}));
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
        Rng rng{seed};
        const double turn = rng.between(0, 7), length = rng.between(1, 12);
        const glm::dvec2 along{std::cos(turn), std::sin(turn)}, across{-along.y, along.x};
        // The shorter radius is 1, so that level 0 alone is read.
        const Footprint f = flat_footprint({rng.between(0, 32), rng.between(0, 32)}, length * along, across);
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

TEST(Ewa, ClampScalesTheEllipseDownAndNeverUp) {
    const LinearImage image = random_image(32, 32, 10);
    const Footprint f = flat_footprint({7.3, 9.1}, {0, 6}, {-4, 0}),
                    quarter = flat_footprint(f.centre, f.per_x / 4.0, f.per_y / 4.0);
    for (const char* name : {"ewa-pbrt", "ewa-pbrt-table", "ewa-true"}) {
        EXPECT_LE(
            distance(prepared(name, image, {.lod_max = 0}).colour(f), prepared(name, image).colour(quarter)),
            1e-12)
            << name;
        for (const Tap& tap : prepared(name, image, {.lod_min = 2}).taps(quarter))
            EXPECT_EQ(tap.image, 2) << name;
    }
}

TEST(Ewa, LimitsAnisotropyByWideningTheEllipse) {
    const LinearImage image = random_image(32, 32, 10);
    const Footprint narrow = flat_footprint({7.3, 9.1}, {12, 0}, {0, 1}),
                    wide = flat_footprint(narrow.centre, {12, 0}, {0, 3});
    for (const char* name : {"ewa-pbrt", "ewa-pbrt-table", "ewa-true"})
        EXPECT_LE(distance(prepared(name, image, {.max_anisotropy = 4}).colour(narrow),
                           prepared(name, image, {.max_anisotropy = 4}).colour(wide)),
                  1e-12)
            << name;
}

/// Of a step of no length pbrt reads a point; true axes keep a width of 1 / anisotropy.
TEST(Ewa, OfALineIsAPointForPbrt) {
    const LinearImage image = random_image(32, 32, 10);
    const Footprint f = flat_footprint({7.3, 9.1}, {12, 0}, {0, 0});
    EXPECT_EQ(prepared("ewa-pbrt", image).taps(f).size(), 4u);
    EXPECT_LE(distance(prepared("ewa-true", image, {.max_anisotropy = 6}).colour(f),
                       prepared("ewa-true", image).colour(flat_footprint(f.centre, {12, 0}, {0, 2}))),
              1e-12);
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
    EXPECT_LE(distance(nine.colour(f), sum / 9.0), 4096 * unit_roundoff_float64);
}

}  // namespace
}  // namespace zproof::texture
