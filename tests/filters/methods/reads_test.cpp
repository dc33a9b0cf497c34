// Reads of many lookups side by side give the bits of reading tap by tap, with every kernel that this machine
// can run.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "filters/methods/catalogue.h"
#include "filters/methods/tap_rule.h"
#include "filters/reads/kernel.h"
#include "filters/reads/tiles.h"
#include "filters/stored/mip_chain.h"
#include "math/processor.h"
#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

constexpr Wrap every_wrap[] = {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat};

std::array<std::uint64_t, 4> bits(const glm::dvec4& c) {
    return {std::bit_cast<std::uint64_t>(c.x), std::bit_cast<std::uint64_t>(c.y),
            std::bit_cast<std::uint64_t>(c.z), std::bit_cast<std::uint64_t>(c.w)};
}

std::vector<LinearImage> images_of_any_size() {
    std::vector<LinearImage> images;
    for (const glm::ivec2 size : {glm::ivec2{300, 40}, {64, 128}, {37, 21}, {1, 16}, {17, 1}, {1, 1}})
        images.push_back(random_image(size.x, size.y, std::uint32_t(size.x)));
    images.push_back(constant_image(5, 5, glm::vec4{std::numeric_limits<float>::quiet_NaN()}));
    return images;
}

/// All but the last, whose texels are no numbers: that one is there to be left alone.
int read_images(const std::vector<LinearImage>& images) { return int(images.size()) - 1; }

/// Images as they are and as the kernels know them.
struct Images {
    std::vector<LinearImage> images = images_of_any_size();
    reads::TiledImages tiles{images};
};

/// One bilinear read.
struct Read {
    int level = 0;
    glm::dvec2 place{0};
    double weight = 0;
};

/// Edges of texels and of the image, many periods away, the ends of the line and beyond them.
double place(Rng& rng, int size) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double odd[] = {0.0,
                              -0.0,
                              0.5,
                              -0.5,
                              0x1p51,
                              -0x1p51,
                              0x1p51 + 0.5,
                              -0x1p52,
                              0x1p52 - 1,
                              1 - 0x1p52,
                              0x1p52,
                              infinity,
                              -infinity,
                              1e300,
                              1e-300,
                              0x1p51 - 0.25,
                              -0x1p51 - 1.5,
                              0x1p-1074,
                              std::numeric_limits<double>::quiet_NaN()};
    switch (int(rng.between(0, 6))) {
        case 0:
            return rng.between(0, size);
        case 1:
            return std::floor(rng.between(-3 * size, 3 * size)) / 2;
        case 2:
            return size * std::floor(rng.between(-5, 5)) + rng.between(-1, 1);
        case 3:
            return rng.between(-1e6, 1e6);
        case 4:
            return std::floor(rng.between(-0x1p52, 0x1p52));
        default:
            return odd[std::size_t(rng.between(0, double(std::size(odd))))];
    }
}

std::vector<Read> random_reads(const Images& chain, int count, Rng& rng) {
    std::vector<Read> some;
    for (int i = 0; i < count; ++i) {
        const int level = int(rng.between(0, read_images(chain.images)));
        const LinearImage& image = chain.images[std::size_t(level)];
        some.push_back({level, {place(rng, image.width), place(rng, image.height)}, rng.between(-1, 1)});
    }
    return some;
}

glm::dvec4 tap_by_tap(const Images& chain, const Addressing& wrap, const std::vector<Read>& all) {
    glm::dvec4 sum{0};
    for (const Read& read : all) {
        const LinearImage& image = chain.images[std::size_t(read.level)];
        read_bilinear(image, wrap, read.place, {.image = read.level, .weight = read.weight},
                      [&](const Tap& tap) { sum += tap.weight * glm::dvec4{image.at(tap.column, tap.row)}; });
    }
    return sum;
}

class EveryReadKernel : public testing::TestWithParam<reads::Kernel> {};

/// 0 to 12 reads a lookup, until the block is full.
TEST_P(EveryReadKernel, SumsTheReadsOfEachLookupTapByTap) {
    const Images chain;
    for (std::uint32_t seed = 0; seed < 360; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng{seed};
        const Addressing wrap{every_wrap[seed % 3], every_wrap[seed / 3 % 3]};
        std::vector<std::vector<Read>> lookups;
        std::vector<glm::dvec4> sums(reads::Block::most, glm::dvec4{0});
        reads::Block block;
        block.begin[0] = 0;
        for (int count = int(rng.between(0, 13)); block.count + count <= reads::Block::most - int(seed % 9);
             count = int(rng.between(0, 13))) {
            lookups.push_back(random_reads(chain, count, rng));
            if (block.lookups == reads::Block::most) break;
            for (const Read& read : lookups.back()) {
                block.x[block.count] = read.place.x, block.y[block.count] = read.place.y;
                block.weight[block.count] = read.weight, block.level[block.count++] = read.level;
            }
            block.sum[block.lookups] = &sums[std::size_t(block.lookups)].x;
            block.begin[++block.lookups] = block.count;
        }
        const reads::Chain where = chain.tiles.chain(wrap);
        GetParam().find_taps(where, block);
        GetParam().add_up(where, block);
        for (std::size_t i = 0; i < lookups.size(); ++i)
            ASSERT_EQ(bits(sums[i]), bits(tap_by_tap(chain, wrap, lookups[i]))) << "lookup " << i;
    }
}

/// A lookup of Lines.
struct Line {
    glm::dvec2 middle{0}, whole{0};
    int taps = 1, finer = 0, coarser = 0;
    double share = 0;
};

/// Of neighbours, three in four read the same levels, as they mostly do.
std::vector<Line> random_lines(const Images& chain, int count, Rng& rng) {
    const int images = read_images(chain.images);
    std::vector<Line> some;
    Line line;
    for (int i = 0; i < count; ++i) {
        if (i % 8 == 0 || rng.uniform() < 0.25) line.finer = int(rng.between(0, images));
        const LinearImage& image = chain.images[0];
        line.middle = {place(rng, image.width), place(rng, image.height)};
        line.whole = {rng.between(-50, 50), rng.uniform() < 0.1 ? place(rng, 10) : rng.between(-50, 50)};
        line.taps = int(rng.between(1, rng.uniform() < 0.5 ? 4 : 64));
        line.share = rng.uniform() < 0.3 ? 0 : rng.uniform();
        line.coarser = line.share > 0 ? (line.finer + 1) % images : images;
        some.push_back(line);
    }
    return some;
}

glm::dvec4 tap_by_tap(const Images& chain, const Addressing& wrap, const reads::TapSpacing& spacing,
                      const Line& line) {
    const auto size = [&](int i) {
        return glm::dvec2{chain.images[std::size_t(i)].width, chain.images[std::size_t(i)].height};
    };
    std::vector<Read> all;
    for (int i = 0; i < line.taps; ++i) {
        const double along = (i + spacing.first) / (line.taps + spacing.more) - 0.5, weight = 1.0 / line.taps;
        const glm::dvec2 at = line.middle + along * line.whole;
        all.push_back({line.finer, at * (size(line.finer) / size(0)), weight * (1 - line.share)});
        if (line.share > 0)
            all.push_back({line.coarser, at * (size(line.coarser) / size(0)), weight * line.share});
    }
    return tap_by_tap(chain, wrap, all);
}

TEST_P(EveryReadKernel, SumsTheLinesOfEachLookupTapByTap) {
    const Images chain;
    for (std::uint32_t seed = 0; seed < 180; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng{seed};
        const Addressing wrap{every_wrap[seed % 3], every_wrap[seed / 3 % 3]};
        const std::vector<Line> some = random_lines(chain, int(rng.between(0, reads::Lines::most + 1)), rng);
        std::vector<glm::dvec4> sums(some.size(), glm::dvec4{0});
        reads::Lines lines;
        lines.spacing = seed % 2 == 0 ? reads::TapSpacing{} : reads::TapSpacing{1, 1};
        for (const Line& line : some) {
            const int i = lines.count++;
            lines.x[i] = line.middle.x, lines.y[i] = line.middle.y;
            lines.across[i] = line.whole.x, lines.down[i] = line.whole.y;
            lines.taps[i] = line.taps, lines.share[i] = line.share;
            lines.finer[i] = line.finer, lines.coarser[i] = line.coarser;
            lines.sum[i] = &sums[std::size_t(i)].x;
        }
        GetParam().add_lines(chain.tiles.chain(wrap), lines);
        for (std::size_t i = 0; i < some.size(); ++i)
            ASSERT_EQ(bits(sums[i]), bits(tap_by_tap(chain, wrap, lines.spacing, some[i]))) << "lookup " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Isa, EveryReadKernel, testing::ValuesIn(available_of(reads::kernels)),
                         [](const auto& test) {
                             std::string name = test.param.name;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

/// Footprints of one tap and of very many, and such as are not finite: their reads fill many blocks.
std::vector<Footprint> footprints() {
    std::vector<Footprint> seen;
    for (std::uint32_t seed = 0; seed < 300; ++seed) seen.push_back(random_footprint(seed));
    for (const double strange : {0.0, std::nan(""), 1e300, -1e9, 1e-300}) {
        seen.push_back(flat_footprint({3, strange}, {2, 1}, {-1, 3}));
        seen.push_back(flat_footprint({3, 5}, {2, strange}, {-1, 3}));
    }
    return seen;
}

class EveryMethodOfMany : public testing::TestWithParam<std::string> {};

TEST_P(EveryMethodOfMany, GivesEachLookupTheBitsItHasAlone) {
    const Sampler sampler = find_method(GetParam())->prepare(random_image(48, 33, 1), {.max_anisotropy = 64});
    const std::vector<Footprint> seen = footprints();
    std::vector<glm::dvec4> colours(seen.size());
    look_up(sampler, seen, colours);
    for (std::size_t i = 0; i < seen.size(); ++i)
        ASSERT_EQ(bits(colours[i]), bits(sampler.colour(seen[i]))) << i;
}

/// The sum of its taps in their order, where they read a mip chain.
TEST_P(EveryMethodOfMany, SumsItsTapsInTheirOrder) {
    const LinearImage image = random_image(48, 33, 1);
    for (const Wrap wrap : every_wrap) {
        const FilterOptions options{.addressing = {wrap, Wrap::repeat}};
        const Sampler sampler = find_method(GetParam())->prepare(image, options);
        if (!sampler.colours) return;
        const std::vector<LinearImage> chain = mip_chain(image, options.mip_kernel, options.addressing);
        const std::vector<Footprint> seen = footprints();
        std::vector<glm::dvec4> colours(seen.size());
        look_up(sampler, seen, colours);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            glm::dvec4 sum{0};
            for (const Tap& tap : sampler.taps(seen[i]))
                sum += tap.weight * glm::dvec4{chain[std::size_t(tap.image)].at(tap.column, tap.row)};
            ASSERT_EQ(bits(colours[i]), bits(sum)) << i;
        }
    }
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const Method& method : methods()) all.push_back(method.name);
    return all;
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethodOfMany, testing::ValuesIn(names()), [](const auto& test) {
    std::string name = test.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST(ManyAtATime, MethodsThatReadAMipChainBilinearlyHaveTheirOwnWay) {
    for (const char* name :
         {"trilinear-gl", "aniso-d3d11", "aniso-feline", "aniso-oiio", "mip-nearest-bilinear"})
        EXPECT_TRUE(find_method(name)->prepare(random_image(4, 4, 1), {}).colours) << name;
}

}  // namespace
}  // namespace zproof::texture
