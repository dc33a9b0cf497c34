#include "filters/study/regions.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>

namespace zproof::study {

namespace {

using oracle::TruthKind;

struct PixelFacts {
    const Patch& patch;
    TruthKind around, truth;
};

struct Rule {
    RegionCard card;
    std::function<bool(const PixelFacts&)> holds;
};

/// A class of its own for round footprints, which rounding would else spread over two: up to an eighth of an
/// octave, 2^(1/8).
constexpr double isotropic = 1.0905;

bool is_interior(const PixelFacts& p) { return p.around == TruthKind::interior && p.patch.is_textured(); }

double anisotropy(const Patch& patch) { return patch.major / patch.minor; }

void add_anisotropies(std::vector<Rule>& rules) {
    constexpr std::array<double, 7> starts{1, isotropic, 2, 4, 8, 16, 32};
    constexpr std::array names{"1", "1-2", "2-4", "4-8", "8-16", "16-32", "32+"};
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const double low = starts[i], high = i + 1 < starts.size() ? starts[i + 1] : 1e300;
        rules.push_back(
            {{std::string{"anisotropy "} + names[i],
              i == 0 ? "interior, major axis below 1.09 minor axes" : "interior, major / minor axis"},
             [=](const PixelFacts& p) {
                 return is_interior(p) && anisotropy(p.patch) >= low && anisotropy(p.patch) < high;
             }});
    }
}

std::string degrees(double value) {
    const int tenths = int(value * 10);
    return std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10));
}

void add_angles(std::vector<Rule>& rules) {
    constexpr double step = 7.5;
    for (double low = 0; low < 90; low += step)
        rules.push_back(
            {{"angle " + degrees(low) + "-" + degrees(low + step),
              "interior, anisotropy 2 and more, degrees of the major axis to the texture's u axis"},
             [=](const PixelFacts& p) {
                 const double angle = std::min(p.patch.angle_degrees, 90 - 1e-9);
                 return is_interior(p) && anisotropy(p.patch) >= 2 && angle >= low && angle < low + step;
             }});
}

std::vector<Rule> all_rules() {
    std::vector<Rule> rules{
        {{"all", "every pixel of the image"}, [](const PixelFacts&) { return true; }},
        {{"interior", "one continuous textured surface within 2 px of the centre"}, is_interior},
        {{"silhouette", "several surfaces, or an edge, within 2 px of the centre"},
         [](const PixelFacts& p) { return p.around == TruthKind::silhouette; }},
        {{"sampled", "the truth is an estimate from samples"},
         [](const PixelFacts& p) { return p.truth == TruthKind::sampled; }},
        {{"magnified", "interior, minor axis below 1 texel"},
         [](const PixelFacts& p) { return is_interior(p) && p.patch.minor < 1; }},
        {{"horizon", "textured, major axis longer than the texture's longer side"},
         [](const PixelFacts& p) { return p.patch.is_textured() && p.patch.major > p.patch.longest_side; }}};
    add_anisotropies(rules);
    add_angles(rules);
    return rules;
}

Region region_of(const Rule& rule, const Plane<Patch>& patches, const Plane<TruthKind>& around,
                 const Plane<TruthKind>& truth) {
    Region region{rule.card.name, Plane<std::uint8_t>(patches.size()), 0};
    for (std::size_t i = 0; i < patches.pixels().size(); ++i) {
        const bool holds = rule.holds({patches.pixels()[i], around.pixels()[i], truth.pixels()[i]});
        region.mask.pixels()[i] = holds ? 1 : 0;
        region.pixels += holds ? 1 : 0;
    }
    return region;
}

}  // namespace

std::vector<RegionCard> region_cards() {
    std::vector<RegionCard> cards;
    for (const Rule& rule : all_rules()) cards.push_back(rule.card);
    return cards;
}

std::vector<Region> regions(const Plane<Patch>& patches, const Plane<TruthKind>& around,
                            const Plane<TruthKind>& truth) {
    assert(patches.size() == around.size() && patches.size() == truth.size());
    std::vector<Region> all;
    for (const Rule& rule : all_rules()) all.push_back(region_of(rule, patches, around, truth));
    return all;
}

Plane<std::uint32_t> region_bits(std::span<const Region> regions) {
    assert(!regions.empty() && regions.size() <= 32);
    Plane<std::uint32_t> bits(regions.front().mask.size());
    for (std::size_t r = 0; r < regions.size(); ++r)
        for (std::size_t i = 0; i < bits.pixels().size(); ++i)
            bits.pixels()[i] |= std::uint32_t{regions[r].mask.pixels()[i]} << r;
    return bits;
}

}  // namespace zproof::study
