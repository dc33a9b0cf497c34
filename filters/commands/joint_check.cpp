#include "filters/commands/joint_check.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <memory>
#include <sstream>

#include "filters/selftest/changed_definition.h"

namespace zproof {

namespace {

using oracle::FilterSettings;
using selftest::ChangedDefinitions;
using selftest::DefinitionChange;
using selftest::FilterClaim;
using selftest::FilterFixture;

/// Every value times so much.
PixelReference with_gain(const PixelReference& definition, double gain) {
    return [definition, gain](int x, int y, const FilterPrecision& precision) {
        PermittedColours permitted = definition(x, y, precision);
        for (ColourRange& range : permitted) range.low *= gain, range.high *= gain;
        return permitted;
    };
}

/// Weights that are multiples of 2^-bits.
PixelReference with_weights_on(const PixelReference& definition, const WeightLattice& lattice) {
    return [definition, lattice](int x, int y, FilterPrecision precision) {
        precision.weights_on = lattice;
        return definition(x, y, precision);
    };
}

/// Bits of what may err by 2^-a and by 2^-b.
double both(double a, double b) { return -std::log2(std::exp2(-a) + std::exp2(-b)); }

/// What is promised of all that leads to a place on the texture, and of codes: colours that are alike are
/// rounded alike, so that their roundings are no chance.
FilterPrecision place_alone(const FilterPrecision& promise) {
    return {.arithmetic_bits = promise.arithmetic_bits,
            .coordinate_bits = promise.coordinate_bits,
            .displacement_px = promise.displacement_px,
            .code_error = promise.code_error};
}

/// A weight of the blend of two levels that is off by e is an LOD that is off by e. Where weights are a
/// function of the distance, as an ellipse's, an error that all have alike makes the footprint wider or
/// narrower: LOD again.
FilterPrecision lod_alone(const FilterClaim& claim) {
    const FilterPrecision& promise = claim.precision;
    FilterPrecision own = place_alone(promise);
    own.step_bits = promise.step_bits;
    own.lod_bits = both(promise.lod_bits, promise.weight_bits);
    own.lod_below = promise.lod_below;
    own.lod_above = promise.lod_above;
    if (claim.method.starts_with("ewa-")) own.weight_bits = promise.weight_bits;
    return own;
}

/// A weight of a bilinear read that is off by e is a place in that level that is off by e. Splits that are
/// all off to one side move a place as well.
FilterPrecision offset_alone(const FilterPrecision& promise) {
    FilterPrecision own = place_alone(promise);
    own.split_bits = promise.split_bits;
    own.place_bits = both(promise.place_bits, promise.weight_bits);
    return own;
}

/// Whatever flattens a texture's contrast looks like a gain below 1, so that all of the promise counts there.
std::vector<OffsetReference> offsets_of(const FilterClaim& claim) {
    const FilterPrecision& promise = claim.precision;
    return {{"LOD", "levels", lod_alone(claim)},
            {"u", "texels", offset_alone(promise)},
            {"v", "texels", offset_alone(promise)},
            {"gain", "", promise}};
}

/// By offsets_of.
PixelReference shifted(const ChangedDefinitions& changed, const std::vector<double>& offsets) {
    DefinitionChange change = selftest::moved_place("", {offsets[1], offsets[2]});
    change.of_claim = selftest::biased_lod("", offsets[0]).of_claim;
    const PixelReference definition = changed.under(change);
    return offsets[3] == 0 ? definition : with_gain(definition, 1 + offsets[3]);
}

/// Lattices that a renderer of so many promised bits cannot be on, four of each rounding: to the nearest errs
/// by half a step, downwards by a whole one. Above 10 bits every coarser one is within reach of the pixels'
/// own ranges.
std::vector<AlternativeReference> coarser_weights(const ChangedDefinitions& changed,
                                                  const FilterPrecision& promise) {
    using Rounding = WeightLattice::Rounding;
    const int promised = int(std::floor(std::min(promise.weight_bits, 10.0)));
    std::vector<AlternativeReference> all;
    const auto add = [&](int bits, Rounding rounding, const char* how) {
        if (bits < 1) return;
        all.push_back({"weights of " + std::to_string(bits) + " bits, rounded " + how,
                       with_weights_on(changed.as_it_is(), {double(bits), rounding})});
    };
    for (int fewer = 1; fewer <= 4; ++fewer) {
        add(promised - fewer, Rounding::down, "down");
        add(promised - fewer - 1, Rounding::nearest, "to the nearest");
    }
    return all;
}

/// Formats of 11 bits, which a promise of more rules out. Levels that a user gives are what they are.
std::vector<AlternativeReference> coarser_levels(const ChangedDefinitions& changed,
                                                 const FilterClaim& claim) {
    using oracle::filter_reference::LevelFormat;
    if (claim.precision.texel_bits <= 11 || claim.options.given_levels) return {};
    const auto under = [&](void (*change)(FilterSettings&)) {
        return changed.under({.name = {}, .of_reference = change});
    };
    return {
        {"levels above 0 of float16", under([](FilterSettings& s) { s.format = LevelFormat::float16; })},
        {"levels of float16", under([](FilterSettings& s) { s.format = LevelFormat::float16_throughout; })}};
}

JointReferences references_of(const FilterFixture& fixture, const FilterClaim& claim) {
    const auto changed = std::make_shared<const ChangedDefinitions>(fixture, claim);
    const auto with_limit = [&](const char* name, double times) -> AlternativeReference {
        return {name, changed->under({.name = {}, .of_reference = [times](FilterSettings& s) {
                                          s.max_anisotropy = int(s.max_anisotropy * times);
                                      }})};
    };
    std::vector<AlternativeReference> alternatives = coarser_weights(*changed, claim.precision);
    std::ranges::move(coarser_levels(*changed, claim), std::back_inserter(alternatives));
    alternatives.push_back(with_limit("four times the limit of anisotropy", 4));
    if (claim.options.max_anisotropy > 1)
        alternatives.push_back(with_limit("half the limit of anisotropy", 0.5));
    return {offsets_of(claim),
            [changed](const std::vector<double>& offsets) { return shifted(*changed, offsets); },
            std::move(alternatives)};
}

/// "LOD +0.0100 +- 0.0002 levels, promised within 0.0078: leaves the promise (chance below 2^-63)"
std::string in_words(const OffsetEstimate& offset, const JointConformance& all) {
    std::ostringstream line;
    line << offset.name;
    if (!offset.is_told) return offset.name + " not told";
    if (all.are_offsets_known())
        line << std::showpos << std::setprecision(3) << " " << offset.value << std::noshowpos
             << std::setprecision(1) << " +- " << offset.standard_error
             << (offset.unit.empty() ? "" : " " + offset.unit);
    else
        line << " not told: large, or no offset";
    line << std::setprecision(2) << ", promised within " << offset.promised;
    const bool is_beyond = std::abs(offset.value) - 3 * offset.standard_error > offset.promised;
    if (offset.leaves_promise)
        line << (all.are_offsets_known() ? ": leaves" : ": the picture, along it, leaves")
             << " the promise (chance below 2^" << int(std::ceil(offset.log2_chance)) << ")";
    else if (is_beyond && all.are_offsets_known())
        line << " on the average; roundings of other promises may make it (chance up to 2^"
             << int(std::ceil(offset.log2_chance)) << ", refused from 2^"
             << int(std::floor(all.log2_least_chance)) << ")";
    return line.str();
}

/// "weights of 6 bits, rounded down: nearer than the definition (share 1.00 +- 0.02, chance below 2^-63)"
std::string in_words(const AlternativeFit& other) {
    std::ostringstream line;
    line << other.name << ": nearer than the definition (share " << std::setprecision(3) << other.share
         << " +- " << std::setprecision(1) << other.standard_error << ", chance below 2^"
         << int(std::ceil(other.log2_chance)) << ")";
    return line.str();
}

}  // namespace

JointCheck joint_check_of(const FilterFixture& fixture, const FilterClaim& claim) {
    return {{fixture.view.width, fixture.view.height}, references_of(fixture, claim), claim.precision};
}

JointConformance joint_conformance_of(const Picture& picture, const FilterFixture& fixture,
                                      const FilterClaim& claim) {
    return joint_check_of(fixture, claim).judge(picture);
}

std::string promised_in_words(const JointConformance& found) {
    std::ostringstream line;
    line << "offsets promised within:" << std::setprecision(2);
    const char* before = " ";
    for (const OffsetEstimate& offset : found.offsets) {
        if (!offset.is_told) continue;
        line << before << offset.name << " " << offset.promised
             << (offset.unit.empty() ? "" : " " + offset.unit);
        before = ", ";
    }
    return line.str();
}

std::vector<std::string> in_words(const JointConformance& found) {
    std::vector<std::string> lines;
    for (const OffsetEstimate& offset : found.offsets) lines.push_back(in_words(offset, found));
    for (const AlternativeFit& other : found.alternatives)
        if (other.is_nearer) lines.push_back(in_words(other));
    return lines;
}

}  // namespace zproof
