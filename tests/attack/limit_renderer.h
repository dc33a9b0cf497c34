/// Honest renderers at the limits of their promise. They draw triangles that are displaced as far as the
/// promise lets them be, with depths that err as far, and decide each tie the unlikely way. Written from
/// docs/renderer-contract.md alone.
#pragma once

#include <cstdint>
#include <string>

#include "frame/frame.h"
#include "frame/precision.h"
#include "tests/attack/oracle.h"

namespace zproof::attack {

/// How a corner moves within its permitted square.
enum class Movement {
    stay,          ///< not at all
    one_way,       ///< all corners to the same corner of their squares
    any_corner,    ///< each to a corner of its own
    grow,          ///< away from the middle of the first triangle that has it
    shrink,        ///< towards it
    nearest_grid,  ///< to the nearest place of the grid; of two, either
    beside_grid,   ///< to the place of the grid before or behind it, in x and in y
};

/// Do triangles that share an edge move it alike?
enum class Sharing { alike, apart };

/// Which depths within their error are taken.
enum class DepthError {
    none,
    nearest,   ///< all as near as they may be
    farthest,  ///< all as far
    reversed,  ///< so that the farthest surface that may win does
};

/// Who has a pixel's centre that lies on an edge.
enum class EdgeOwner {
    all,           ///< every triangle that has the edge
    top_left,      ///< as Direct3D and most others
    bottom_right,  ///< the other one
};

/// Where near and far are cut, in units of the depth error there.
enum class PlaneCut { outwards, exact, inwards };

/// A way to keep a promise.
struct Limits {
    Movement movement = Movement::stay;
    Sharing sharing = Sharing::alike;
    DepthError depth_error = DepthError::none;
    EdgeOwner edge_owner = EdgeOwner::all;
    PlaneCut plane_cut = PlaneCut::exact;
    std::uint64_t seed = 0;  ///< of what is drawn by lot
};
std::string text_of(const Limits& limits);

/// What is promised, as far as these renderers need to know it.
struct Allowance {
    double eps_px = 0;      ///< displacement, where there is no grid
    int subpixel_bits = 0;  ///< of the grid, where there is one
    double depth_relative = 0, depth_absolute = 0;
};

/// Of a declaration that says what it permits: bounded, and a rasterizer with a float64 transform, exact edge
/// functions and a buffer of camera depth.
Allowance allowance_of(const BoundedPrecision& precision, const View& view);
Allowance allowance_of(const RasterPrecision& precision);

/// What a renderer that keeps its promise in this way may show. `scene` is cut where `limits` say.
Frame draw_at_limits(const ExactScene& scene, const Allowance& allowance, const Limits& limits);

/// Where it cuts.
Planes planes_of(const View& view, const Allowance& allowance, PlaneCut cut);

}  // namespace zproof::attack
