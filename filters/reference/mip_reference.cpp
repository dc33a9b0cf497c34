#include "filters/reference/levels.h"

namespace zproof::oracle::filter_reference {

namespace {

Interval level_at(LodRule rule, const Levels& levels, const FilterQuery& q, const PixelFootprint& footprint) {
    return level_of(lod(rule, footprint), levels.settings(), levels.count(), q.precision);
}

Definition trilinear_definition(const std::string& name, LodRule rule) {
    return {"trilinear-" + name,
            over_levels([rule](const Levels& levels, const FilterQuery& q) -> PermittedColours {
                const PixelFootprint f = q.footprint();
                return {levels.trilinear(level_at(rule, levels, q, f), f.centre, q.precision)};
            })};
}

/// OpenGL 4.6, 8.14.3: ceil(lod + 1/2) - 1, preferred; floor(lod + 1/2) is allowed. They differ at halves
/// only.
PermittedColours nearest_levels(const Levels& levels, const FilterQuery& q, auto&& read) {
    const PixelFootprint f = q.footprint();
    const Interval level = level_at(LodRule::gl_maximum, levels, q, f);
    const int last = int(levels.count()) - 1;
    PermittedColours all;
    for (int k = int(std::ceil(level.low() + 0.5)) - 1; k <= int(std::floor(level.high() + 0.5)); ++k)
        for (const ColourRange& range : read(std::clamp(k, 0, last), f.centre)) all.push_back(range);
    return all;
}

PermittedColours mip_nearest_point(const Levels& levels, const FilterQuery& q) {
    return nearest_levels(levels, q, [&](int level, const TexelInterval& place) {
        return levels.nearest_in(level, place, q.precision);
    });
}

PermittedColours mip_nearest_bilinear(const Levels& levels, const FilterQuery& q) {
    return nearest_levels(levels, q, [&](int level, const TexelInterval& place) -> PermittedColours {
        return {levels.bilinear_in(level, place, q.precision)};
    });
}

PermittedColours trilinear_by_cone(const Levels& levels, const FilterQuery& q) {
    const Interval level =
        level_of(log2(q.seen.cone(q.x, q.y).width), levels.settings(), levels.count(), q.precision);
    return {levels.trilinear(level, q.footprint().centre, q.precision)};
}

/// Mesa, lp_build_brilinear_lod of factor 2: with l = lod + 1/4, the level floor(l), blended with the next by
/// 2 fract(l) - 1, at least 0. It rises with the LOD, so that an interval's ends hold its extremes.
Interval brilinear_level(const Interval& lod, std::size_t count) {
    const auto snapped = [](double at) {
        const double shifted = at + 0.25, level = std::floor(shifted);
        return level + std::max(0.0, 2 * (shifted - level) - 1);
    };
    return clamped(widen({snapped(lod.low()), snapped(lod.high())}, 0x1p-46), 0, double(count) - 1);
}

PermittedColours brilinear(const Levels& levels, const FilterQuery& q) {
    const PixelFootprint f = q.footprint();
    const Interval level = level_at(LodRule::gl_maximum, levels, q, f);
    return {levels.trilinear(brilinear_level(level, levels.count()), f.centre, q.precision)};
}

/// trilinear-gl on a chain weighed by area.
MethodReference parameterization_aware(const texture::LinearImage& image, const Settings& settings) {
    return [levels = std::make_shared<const Levels>(chain_by_area(image, settings), settings)](
               const FilterQuery& q) -> PermittedColours {
        const PixelFootprint f = q.footprint();
        return {levels->trilinear(level_at(LodRule::gl_maximum, *levels, q, f), f.centre, q.precision)};
    };
}

}  // namespace

std::vector<Definition> mip_definitions() {
    return {{"mip-nearest-point", over_levels(mip_nearest_point)},
            {"mip-nearest-bilinear", over_levels(mip_nearest_bilinear)},
            trilinear_definition("gl", LodRule::gl_maximum),
            trilinear_definition("ellipse", LodRule::ellipse_major),
            trilinear_definition("rms", LodRule::root_mean_square),
            trilinear_definition("area", LodRule::root_of_area),
            trilinear_definition("pbrt", LodRule::pbrt),
            {"trilinear-ray-cone", over_levels(trilinear_by_cone)},
            {"brilinear", over_levels(brilinear)},
            {"trilinear-parameterization-aware", parameterization_aware},
            trilinear_definition("mesa", LodRule::mesa_longer_step)};
}

}  // namespace zproof::oracle::filter_reference
