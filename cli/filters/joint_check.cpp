#include "cli/filters/joint_check.h"

#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "oracle/admissible_surfaces.h"

namespace zproof {

namespace {

using oracle::FilterReference;
using oracle::FilterSettings;
using selftest::FilterClaim;
using selftest::FilterFixture;

/// Of the differences by which the picture's change is found: small beside a texel and a level, large beside
/// what the reference leaves open (2^-24).
constexpr double step = 0x1p-10;

/// A definition on a scene of its own.
struct OwnedReference {
    Scene scene;
    FilterReference reference;

    OwnedReference(Scene of, const FilterFixture& fixture, const FilterClaim& claim,
                   const FilterSettings& settings)
        : scene(std::move(of)),
          reference(scene, fixture.view, *oracle::find_filter_definition(claim.method), settings,
                    selftest::step_rule(claim.derivatives)) {}
    OwnedReference(const OwnedReference&) = delete;
    OwnedReference& operator=(const OwnedReference&) = delete;
};

/// Makes definitions with one quantity changed.
class ChangedDefinitions {
  public:
    ChangedDefinitions(const FilterFixture& fixture, const FilterClaim& claim)
        : fixture_(fixture),
          claim_(claim),
          surfaces_(std::make_shared<const oracle::AdmissibleSurfaces>(fixture.scene, fixture.view,
                                                                       claim.precision)) {}

    PixelReference as_it_is() const { return made(fixture_.scene, settings()); }

    PixelReference with_lod(double offset) const {
        FilterSettings changed = settings();
        changed.lod_bias += offset;
        return made(fixture_.scene, changed);
    }

    /// Every place so many texels of level 0 on.
    PixelReference with_place(const glm::dvec2& texels) const {
        Scene changed = fixture_.scene;
        for (Material& material : changed.materials) {
            Texture& texture = material.base_color;
            if (texture.image == Texture::none) continue;
            const Image& image = changed.images[std::size_t(texture.image)];
            texture.transform.translation += texels / glm::dvec2{image.width, image.height};
        }
        return made(std::move(changed), settings());
    }

    PixelReference with_gain(double gain) const {
        return [as_is = as_it_is(), gain](int x, int y, const FilterPrecision& precision) {
            PermittedColours permitted = as_is(x, y, precision);
            for (ColourRange& range : permitted) range.low *= gain, range.high *= gain;
            return permitted;
        };
    }

  private:
    FilterSettings settings() const { return selftest::reference_settings(claim_.options); }

    PixelReference made(Scene scene, const FilterSettings& settings) const {
        const auto owned =
            std::make_shared<const OwnedReference>(std::move(scene), fixture_, claim_, settings);
        return [owned, surfaces = surfaces_](int x, int y, const FilterPrecision& precision) {
            return owned->reference.at(x, y, surfaces->at(x, y), precision);
        };
    }

    const FilterFixture& fixture_;
    const FilterClaim& claim_;
    std::shared_ptr<const oracle::AdmissibleSurfaces> surfaces_;
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
    if (claim.method.starts_with("ewa-")) own.weight_bits = promise.weight_bits;
    return own;
}

/// A weight of a bilinear read that is off by e is a place in that level that is off by e.
FilterPrecision offset_alone(const FilterPrecision& promise) {
    FilterPrecision own = place_alone(promise);
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

}  // namespace

JointConformance joint_conformance_of(const Picture& picture, const FilterFixture& fixture,
                                      const FilterClaim& claim) {
    if (oracle::find_filter_definition(claim.method) == nullptr)
        throw std::logic_error("no reference for the method '" + claim.method + "'");
    const ChangedDefinitions changed{fixture, claim};
    return joint_conformance(picture, changed.as_it_is(), offsets_of(changed, claim), claim.precision);
}

std::vector<std::string> in_words(const JointConformance& found) {
    std::vector<std::string> lines;
    for (const OffsetEstimate& offset : found.offsets) {
        std::ostringstream line;
        line << offset.name;
        if (!offset.is_told) {
            line << " not told";
        } else {
            line << std::showpos << std::setprecision(3) << " " << offset.value << std::noshowpos
                 << std::setprecision(1) << " +- " << offset.standard_error
                 << (offset.unit.empty() ? "" : " " + offset.unit) << std::setprecision(2)
                 << ", promised within " << offset.promised;
        }
        if (offset.leaves_promise)
            line << ": leaves the promise (chance below 2^" << int(std::ceil(offset.log2_chance)) << ")";
        lines.push_back(line.str());
    }
    return lines;
}

}  // namespace zproof
