/// Known defects to plant into the rasterizer: rules that are wrong in one way each. For tests only; the
/// library's own render() knows correct_rules alone.
#pragma once

#include <array>
#include <string_view>

#include "rasterizer/pipeline.h"
#include "rasterizer/rules.h"

namespace zproof::rasterizer {

struct PlantedRules {
    std::string_view name;  ///< letters, digits and '_'
    Rules rules;
};

inline constexpr std::array planted_rules{
    PlantedRules{"half_pixel_shift", {.sample_offset_px = 0}},
    PlantedRules{"affine_depth", {.depth_interpolation = DepthInterpolation::affine}},
    PlantedRules{"exclusive_fill", {.fill = FillRule::exclusive}},
    PlantedRules{"inclusive_fill", {.fill = FillRule::inclusive}},
    PlantedRules{"y_flipped", {.raster_y = RasterY::up}},
    PlantedRules{"no_near_clip", {.near_clip = NearClip::just_before_the_eye}},
    PlantedRules{"depth_test_reversed", {.depth_test = DepthTest::farther_wins}},
    PlantedRules{"four_subpixel_bits", {.subpixel_bits = 4}},
};

}  // namespace zproof::rasterizer
