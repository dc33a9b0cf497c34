/// What a renderer really does, as its pictures of small probe scenes tell (docs/measure.md).
///
/// Raster x runs right and y down; both axes are measured by themselves. Every measured number is a bracket:
/// what bisection left, no more.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenes/camera.h"

namespace zproof::measure {

/// A number is known to lie in [low, high].
struct Bracket {
    double low = 0, high = 0;
    double middle() const { return low + (high - low) / 2; }
};

enum class Axis { x, y };
inline constexpr std::array both_axes{Axis::x, Axis::y};

/// Where vertices between two grid lines go.
enum class SnapRounding {
    nearest,
    towards_smaller,  ///< truncated: left or up
    towards_greater,  ///< right or down
};

/// Where vertices half-way between two grid lines go, if snap is to the nearest.
enum class TieRounding {
    to_even,
    towards_smaller,
    towards_greater,
    unclear,  ///< no probe met a tie exactly, or they differ without a rule
};

/// A grid that vertices snap to.
struct SnapGrid {
    Bracket step_px;
    SnapRounding snap = SnapRounding::nearest;
    TieRounding ties = TieRounding::unclear;
};

/// How vertices move before they are drawn, along one axis.
struct Displacement {
    std::optional<SnapGrid> grid;  ///< none: no grid of finest_px or coarser
    double finest_px = 0;          ///< the finest grid step that would have been recognised, a power of two
    Bracket at_least_px;  ///< vertices move by as little as low (< 0: left or up) and as much as high
};

/// Who owns a pixel centre that lies exactly on an edge.
struct FillSide {
    int dx = 0, dy = 0;  ///< the edge's direction, with the triangle to its right
    bool owns = false;
};
using FillSides = std::vector<FillSide>;

/// How finely depth is told apart and told, at one depth.
struct DepthStep {
    Projection projection = Projection::parallel;
    double depth = 0;  ///< scene units
    Bracket step;      ///< depths closer than this may count as equal in the depth test, scene units
    double error = 0;  ///< greatest |depth in the frame - true depth| seen, scene units
};

enum class LimitPlane { near, far };

/// What happens at the near or far plane.
struct DepthLimit {
    Projection projection = Projection::parallel;
    LimitPlane plane = LimitPlane::near;
    double depth = 0;               ///< of the plane, scene units
    std::optional<Bracket> offset;  ///< how far outside the plane drawing ends, scene units; none: it goes on
    bool keeps_plane = false;       ///< is a triangle drawn that lies exactly in the plane?
};

/// Meshes whose edges are shared, drawn over all pixels.
struct Watertightness {
    std::uint64_t pixels = 0, holes = 0, double_hits = 0;
};

/// All of it. What could not be measured is absent and has a line in `unmeasured`.
struct Measurement {
    std::array<std::optional<Bracket>, 2>
        centre_px;  ///< by Axis: from a pixel's upper left corner to its sample
    std::array<std::optional<Displacement>, 2> displacement;  ///< by Axis
    std::optional<FillSides> fill;
    std::vector<DepthStep> depth_steps;
    std::vector<DepthLimit> depth_limits;
    std::optional<Watertightness> watertightness;
    std::vector<std::string> unmeasured;
};

}  // namespace zproof::measure
