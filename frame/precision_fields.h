/// The keys of a declaration, each with its value in the struct and what it may hold: the one list that
/// reading and writing share (docs/renderer-contract.md explains them).
#pragma once

#include "frame/precision.h"

namespace zproof {

/// Numbers from `low` to `high`.
struct Limits {
    double low = 0, high = 1;
};

inline constexpr Limits share{0, 1};
/// No pixel of an image and no unit of a scene needs more.
inline constexpr Limits length{0, 1e30};
/// Nobody's arithmetic is exact: 0 would be no promise but a mistake.
inline constexpr Limits positive_length{1e-30, 1e30};

template <class Visit>
void visit_fields(RasterPrecision& p, const Visit& visit) {
    visit("transform", p.transform);
    visit("origin", p.origin);
    visit("matrices", p.matrices, Limits{1, 3});
    visit("subpixel_bits", p.subpixel_bits, Limits{0, 16});
    visit("snap", p.snap);
    visit("edge_functions", p.edge_functions);
    visit("edge_arithmetic", p.edge_arithmetic);
    visit("third_weight", p.third_weight);
    visit("barycentric_tolerance", p.barycentric_tolerance, share);
    visit("least_area_px2", p.least_area_px2, length);
    visit("area_epsilon_px2", p.area_epsilon_px2, length);
    visit("watertight", p.watertight);
    visit("nothing_behind_the_eye", p.nothing_behind_the_eye);
    visit("clipping", p.clipping);
    visit("depth_buffer", p.depth_buffer);
    visit("depth_format", p.depth_format);
    visit("depth_rounding", p.depth_rounding);
    visit("clip_range", p.clip_range);
    visit("matrix_far", p.matrix_far);
    visit("depth_interpolation", p.depth_interpolation);
    visit("interpolation", p.interpolation);
    visit("linearization", p.linearization);
    visit("depth_roundings", p.depth_roundings, Limits{0, 10000});
    visit("shown_depth", p.shown_depth);
    visit("depth_step", p.depth_step, length);
}

template <class Visit>
void visit_fields(RayPrecision& p, const Visit& visit) {
    visit("arithmetic", p.arithmetic);
    visit("test", p.test);
    visit("watertight", p.watertight);
    visit("aim_offset_px", p.aim_offset_px, length);
    visit("direction_roundings", p.direction_roundings, Limits{1, 1000});
    visit("barycentric_tolerance", p.barycentric_tolerance, share);
    visit("least_determinant", p.least_determinant, length);
    visit("hit_point", p.hit_point);
    visit("world_absolute", p.world_absolute, length);
    visit("depth_of_range", p.depth_of_range, share);
    visit("depth_roundings", p.depth_roundings, Limits{1, 10000});
    visit("depth_step", p.depth_step, length);
}

template <class Visit>
void visit_fields(PlaneRayPrecision& p, const Visit& visit) {
    visit("aim_offset_px", p.aim_offset_px, share);
    visit("least_corner_sine", p.least_corner_sine, share);
    visit("least_grazing_sine", p.least_grazing_sine, share);
    visit("depth_relative", p.depth_relative, share);
    visit("depth_of_range", p.depth_of_range, share);
    visit("clip_relative", p.clip_relative, share);
    visit("clip_of_reach", p.clip_of_reach, share);
    visit("depth_step", p.depth_step, length);
}

template <class Visit>
void visit_fields(BoundedPrecision& p, const Visit& visit) {
    visit("eps_px", p.eps_px, positive_length);
    visit("depth_relative", p.depth_relative, length);  // a depth may be several times the true one
    visit("depth_absolute", p.depth_absolute, length);
    visit("depth_of_range", p.depth_of_range, share);
    visit("watertight", p.watertight);
    visit("depth_step", p.depth_step, length);
}

/// What a declaration's kind is called.
inline const char* kind_of(const RasterPrecision&) { return "raster"; }
inline const char* kind_of(const RayPrecision&) { return "ray"; }
inline const char* kind_of(const PlaneRayPrecision&) { return "plane_ray"; }
inline const char* kind_of(const BoundedPrecision&) { return "bounded"; }

}  // namespace zproof
