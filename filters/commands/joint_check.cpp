#include "filters/commands/joint_check.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "filters/reference/admissible_surfaces.h"

namespace zproof {

namespace {

using oracle::FilterReference;
using oracle::FilterSettings;
using selftest::FilterClaim;
using selftest::FilterFixture;

/// The differences by which the picture's change is found: small beside a texel and a level, large beside
/// what the reference leaves open (2^-24).
constexpr double step = 0x1p-10;

/// Makes definitions with one quantity changed.
class ChangedDefinitions {
  public:
    ChangedDefinitions(const FilterFixture& fixture, const FilterClaim& claim)
        : fixture_(fixture),
          claim_(claim),
          surfaces_(std::make_shared<const oracle::AdmissibleSurfaces>(fixture.scene, fixture.view,
                                                                       claim.precision)),
          as_it_is_(made({}, settings())) {}

    const PixelReference& as_it_is() const { return as_it_is_; }

    PixelReference with_lod(double offset) const {
        FilterSettings changed = settings();
        changed.lod_bias += offset;
        return made({}, changed);
    }

    /// Every place so many texels of level 0 on.
    PixelReference with_place(const glm::dvec2& texels) const {
        const auto changed = std::make_shared<Scene>(fixture_.scene);
        for (Material& material : changed->materials) {
            Texture& texture = material.base_color;
            if (texture.image == Texture::none) continue;
            const Image& image = changed->images[std::size_t(texture.image)];
            texture.transform.translation += texels / glm::dvec2{image.width, image.height};
        }
        return made(changed, settings());
    }

    /// Another setting of the method.
    PixelReference with(const std::function<void(FilterSettings&)>& change) const {
        FilterSettings changed = settings();
        change(changed);
        return made({}, changed);
    }

    /// Weights that are multiples of 2^-bits.
    PixelReference with_weights_on(const WeightLattice& lattice) const {
        return [as_is = as_it_is_, lattice](int x, int y, FilterPrecision precision) {
            precision.weights_on = lattice;
            return as_is(x, y, precision);
        };
    }

    PixelReference with_gain(double gain) const {
        return [as_is = as_it_is_, gain](int x, int y, const FilterPrecision& precision) {
            PermittedColours permitted = as_is(x, y, precision);
            for (ColourRange& range : permitted) range.low *= gain, range.high *= gain;
            return permitted;
        };
    }

  private:
    FilterSettings settings() const { return selftest::reference_settings(claim_.options, claim_.precision); }

    /// The reference of a scene that it keeps; of the fixture's where there is none.
    PixelReference made(std::shared_ptr<const Scene> scene, const FilterSettings& settings) const {
        const auto reference = std::make_shared<const FilterReference>(
            scene ? *scene : fixture_.scene, fixture_.view, *oracle::find_filter_definition(claim_.method),
            settings, selftest::step_rule(claim_.derivatives));
        return [scene, reference, surfaces = surfaces_](int x, int y, const FilterPrecision& precision) {
            return reference->at(x, y, surfaces->at(x, y), precision);
        };
    }

    const FilterFixture& fixture_;
    const FilterClaim& claim_;
    std::shared_ptr<const oracle::AdmissibleSurfaces> surfaces_;
    PixelReference as_it_is_;
};

/// Bits of what may err by 2^-a and by 2^-b.
double both(double a, double b) { return -std::log2(std::exp2(-a) + std::exp2(-b)); }

/// What is promised of all that leads to a place on the texture, and nothing else.
FilterPrecision place_alone(const FilterPrecision& promise) {
    return {.arithmetic_bits = promise.arithmetic_bits,
            .coordinate_bits = promise.coordinate_bits,
            .displacement_px = promise.displacement_px};
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
std::vector<OffsetReference> offsets_of(const ChangedDefinitions& changed, const FilterClaim& claim) {
    const FilterPrecision& promise = claim.precision;
    const glm::dvec2 right{step, 0}, down{0, step};
    return {
        {"LOD", "levels", step, changed.with_lod(-step), changed.with_lod(step), lod_alone(claim)},
        {"u", "texels", step, changed.with_place(-right), changed.with_place(right), offset_alone(promise)},
        {"v", "texels", step, changed.with_place(-down), changed.with_place(down), offset_alone(promise)},
        {"gain", "", step, changed.with_gain(1 - step), changed.with_gain(1 + step), promise}};
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
                       changed.with_weights_on({double(bits), rounding})});
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
    return {{"levels above 0 of float16",
             changed.with([](FilterSettings& s) { s.format = LevelFormat::float16; })},
            {"levels of float16",
             changed.with([](FilterSettings& s) { s.format = LevelFormat::float16_throughout; })}};
}

JointReferences references_of(const ChangedDefinitions& changed, const FilterClaim& claim) {
    std::vector<AlternativeReference> alternatives = coarser_weights(changed, claim.precision);
    std::ranges::move(coarser_levels(changed, claim), std::back_inserter(alternatives));
    alternatives.push_back({"four times the limit of anisotropy",
                            changed.with([](FilterSettings& s) { s.max_anisotropy *= 4; })});
    if (claim.options.max_anisotropy > 1)
        alternatives.push_back(
            {"half the limit of anisotropy", changed.with([](FilterSettings& s) { s.max_anisotropy /= 2; })});
    return {changed.as_it_is(), offsets_of(changed, claim), std::move(alternatives)};
}

/// "LOD +0.0100 +- 0.0002 levels, promised within 0.0078: leaves the promise (chance below 2^-63)"
std::string in_words(const OffsetEstimate& offset) {
    std::ostringstream line;
    line << offset.name;
    if (!offset.is_told) return offset.name + " not told";
    line << std::showpos << std::setprecision(3) << " " << offset.value << std::noshowpos
         << std::setprecision(1) << " +- " << offset.standard_error
         << (offset.unit.empty() ? "" : " " + offset.unit) << std::setprecision(2) << ", promised within "
         << offset.promised;
    if (offset.leaves_promise)
        line << ": leaves the promise (chance below 2^" << int(std::ceil(offset.log2_chance)) << ")";
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

JointConformance joint_conformance_of(const Picture& picture, const FilterFixture& fixture,
                                      const FilterClaim& claim) {
    if (oracle::find_filter_definition(claim.method) == nullptr)
        throw std::logic_error("no reference for the method '" + claim.method + "'");
    const ChangedDefinitions changed{fixture, claim};
    return joint_conformance(picture, references_of(changed, claim), claim.precision);
}

std::vector<std::string> in_words(const JointConformance& found) {
    std::vector<std::string> lines;
    for (const OffsetEstimate& offset : found.offsets) lines.push_back(in_words(offset));
    for (const AlternativeFit& other : found.alternatives)
        if (other.is_nearer) lines.push_back(in_words(other));
    return lines;
}

}  // namespace zproof
