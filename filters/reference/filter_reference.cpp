#include "filters/reference/filter_reference.h"

#include <algorithm>

#include "filters/reference/colour_range_sums.h"
#include "filters/reference/shared_images.h"
#include "math/rounding.h"
#include "math/srgb.h"

namespace zproof::oracle {

namespace {

using namespace filter_reference;

glm::dvec3 decoded(const glm::dvec3& codes) {
    return {decoded_srgb(codes.x), decoded_srgb(codes.y), decoded_srgb(codes.z)};
}

/// The curve rises, so that the ends hold the extremes. Theirs and ours round eight times each; the power
/// makes 2.4 of each.
ColourRange decoded(const ColourRange& codes, const FilterPrecision& precision) {
    const glm::dvec3 low = decoded(codes.low), high = decoded(codes.high);
    const double rounding = 2.4 * (gamma(8, std::exp2(-precision.sum_bits)) + gamma(8, 0x1p-53));
    return {low - rounding * glm::abs(low), high + rounding * glm::abs(high)};
}

/// What the sums over texels may cost, theirs and ours, in the largest texel. No definition's number of
/// terms times the sum of their absolute weights is more than this; cardinality-8's is 8 times 4.1 at most.
constexpr int most_terms = 4096;

/// The factor may be read as the file's number or as the float32 nearest to it, or be anything between.
ColourRange factor_of(const Material& material) {
    const glm::dvec3 rounded{glm::vec3{material.base_color_factor}},
        exact = rounded + glm::dvec3{material.base_color_factor_rounding};
    return {glm::min(rounded, exact), glm::max(rounded, exact)};
}

/// Every product of a factor and a colour.
ColourRange product(const ColourRange& factor, const ColourRange& colour) {
    return hull(hull({factor.low * colour.low, factor.low * colour.low},
                     {factor.low * colour.high, factor.low * colour.high}),
                hull({factor.high * colour.low, factor.high * colour.low},
                     {factor.high * colour.high, factor.high * colour.high}));
}

/// What the sum itself may cost.
ColourRange summed(const ColourRange& filtered, double largest, const FilterPrecision& precision) {
    const double sums =
        2 * largest *
        (gamma(precision.sum_roundings, std::exp2(-precision.sum_bits)) + gamma(most_terms, 0x1p-53));
    return {filtered.low - sums, filtered.high + sums};
}

/// Every light whose code, 0 to 255, lies so near to that of the range. The curve rises. Light read from a
/// file of codes is rounded once to float32; our curve's roundings are far below a code's.
ColourRange as_codes(const ColourRange& light, double error) {
    const auto moved = [](const glm::dvec3& colour, double codes) {
        const auto one = [codes](double c) { return decoded_srgb(encoded_srgb(c) + codes / 255); };
        return glm::dvec3{one(colour.x), one(colour.y), one(colour.z)};
    };
    const glm::dvec3 low = moved(light.low, -error), high = moved(light.high, error);
    return {low - 0x1p-23 * glm::abs(low), high + 0x1p-23 * glm::abs(high)};
}

/// Factor and the picture's format.
ColourRange as_shown(const ColourRange& light, const ColourRange& factor, const FilterPrecision& precision) {
    const auto [low, high] = product(factor, light);
    // The factor's product in double, and one rounding to the picture's numbers.
    const double rounding = std::exp2(-precision.colour_bits) * (1 + 0x1p-50);
    const ColourRange shown{low - rounding * glm::abs(low) - 0x1p-149,
                            high + rounding * glm::abs(high) + 0x1p-149};
    return precision.code_error > 0 ? as_codes(shown, precision.code_error) : shown;
}

PermittedColours anything() {
    const double inf = std::numeric_limits<double>::infinity();
    return {{glm::dvec3{-inf}, glm::dvec3{inf}}};
}

}  // namespace

std::span<const Definition> filter_definitions() {
    static const std::vector<Definition> all = [] {
        std::vector<Definition> list;
        for (const auto& family :
             {point_definitions, separable_definitions, mip_definitions, cardinality_definitions,
              bilinear_reads_definitions, ripmap_definitions, anisotropic_definitions,
              openimageio_definitions, ewa_definitions, sat_definitions, repeated_sat_definitions,
              supersample_definitions, stochastic_definitions})
            for (Definition& definition : family()) list.push_back(std::move(definition));
        return list;
    }();
    return all;
}

const Definition* find_filter_definition(std::string_view name) {
    const auto found = std::ranges::find(filter_definitions(), name, &Definition::name);
    return found == filter_definitions().end() ? nullptr : &*found;
}

FilterReference::FilterReference(const Scene& scene, const View& view, const Definition& definition,
                                 const FilterSettings& settings, StepRule steps)
    : scene_(scene), view_(view), steps_(steps), decoding_(settings.decoding) {
    for (const Material& material : scene.materials) {
        const Texture& texture = material.base_color;
        FilterSettings own = settings;
        own.wrap.u = texture.sampler.wrap_u, own.wrap.v = texture.sampler.wrap_v;
        own.scene = &scene;
        own.image = texture.image;
        OfMaterial& one = by_material_.emplace_back();
        if (!is_textured(scene, material)) continue;
        const auto decoded = decoded_image(scene.images[std::size_t(texture.image)], settings);
        one = {definition.prepare(decoded->image, own), {}, decoded->largest};
        if (definition.draws) one.draws = definition.draws(decoded->image, own);
    }
}

const FilterReference::OfMaterial& FilterReference::of(const Material& material) const {
    return by_material_[std::size_t(&material - scene_.materials.data())];
}

ColourRange FilterReference::light_of(const ColourRange& filtered, double largest,
                                      const FilterPrecision& precision) const {
    const ColourRange sum = summed(filtered, largest, precision);
    return decoding_ == Decoding::after_filtering ? decoded(sum, precision) : sum;
}

PermittedColours FilterReference::at(int x, int y, std::span<const PrimitiveId> seen,
                                     const FilterPrecision& precision) const {
    PermittedColours all;
    for (const PrimitiveId surface : seen)
        std::ranges::copy(of_surface(x, y, surface, precision), std::back_inserter(all));
    return all;
}

SeenTexture FilterReference::texture_of(PrimitiveId seen, const FilterPrecision& precision) const {
    std::optional<Asked>& last = last_asked_.local();
    if (!last || last->triangle != seen || last->precision != precision)
        last.emplace(
            Asked{seen, precision, {view_, textured_triangle(scene_, std::uint32_t(seen)), precision}});
    return last->texture;
}

PermittedColours FilterReference::of_surface(int x, int y, PrimitiveId seen,
                                             const FilterPrecision& precision) const {
    if (seen == PrimitiveId::none) return {ColourRange{}};
    const Material& material = material_of(scene_, std::uint32_t(seen));
    const auto& [reference, draws, largest] = of(material);
    const ColourRange factor = factor_of(material);
    if (!reference) return {as_shown({glm::dvec3{1}, glm::dvec3{1}}, factor, precision)};
    try {
        const SeenTexture texture = texture_of(seen, precision);
        PermittedColours permitted = reference({texture, x, y, steps_, precision});
        for (ColourRange& range : permitted)
            range = as_shown(light_of(range, largest, precision), factor, precision);
        return permitted;
    } catch (const UndecidedSign&) {
        return anything();
    }
}

std::optional<ColourDraws> FilterReference::draws_at(int x, int y, PrimitiveId seen,
                                                     const FilterPrecision& precision) const {
    if (seen == PrimitiveId::none) return std::nullopt;
    const Material& material = material_of(scene_, std::uint32_t(seen));
    const auto& [method, reference, largest] = of(material);
    if (!reference) return std::nullopt;
    const ColourRange factor = factor_of(material);
    try {
        const SeenTexture texture = texture_of(seen, precision);
        ColourDraws all = reference({texture, x, y, steps_, precision});
        // The mean of codes is not that of the light that each draw stands for.
        if (decoding_ == Decoding::after_filtering && all.samples > 1) return std::nullopt;
        for (ColourDraw& draw : all.draws)
            draw.colour = as_shown(light_of(draw.colour, largest, precision), factor, precision);
        return all;
    } catch (const UndecidedSign&) {
        return std::nullopt;
    }
}

}  // namespace zproof::oracle
