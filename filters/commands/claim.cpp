#include "filters/commands/claim.h"

#include "program/usage_error.h"

namespace zproof {

selftest::FilterClaim claim_of(const FilterChoice& choice, const std::optional<FilterPrecision>& promise) {
    const rasterizer::Texturing& texturing = choice.texturing;
    if (oracle::find_filter_definition(texturing.method.name) == nullptr)
        throw UsageError{"filter '" + texturing.method.name + "': it has no reference to be held against"};
    return {texturing.method.name, texturing.options, texturing.derivatives,
            promise.value_or(selftest::filter_precision(texturing.options))};
}

PermittedFloats permitted_at(const selftest::FilterClaim& claim, const FilterPixel& pixel,
                             const LinearRgb& colour, const Scene& scene, const View& view) {
    const selftest::ClaimedReference reference{scene, view, claim};
    return permitted_floats(colour, reference.at(pixel.x, pixel.y, claim.precision));
}

PermittedInterval permitted_by(const selftest::FilterClaim& claim, const Picture& picture, const Scene& scene,
                               const View& view) {
    const selftest::ClaimedReference reference{scene, view, claim};
    return permitted_interval(
        picture,
        [&](int x, int y, const FilterPrecision& precision) { return reference.at(x, y, precision); },
        claim.precision);
}

}  // namespace zproof
