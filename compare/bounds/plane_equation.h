/// What it costs to interpolate depth by a plane equation in float32 (docs/bounds.md, "A z-buffer").
#pragma once

#include <span>
#include <vector>

#include "compare/bounds/view_facts.h"
#include "compare/bounds/z_range.h"
#include "frame/precision.h"
#include "scenes/view.h"

namespace zproof {

/// A corner as the depth buffer sees it: raster position in px, inverse depth and z.
struct WindowCorner {
    double x = 0, y = 0, z = 0, inverse_depth = 0;
};

/// The part of a triangle that depth is interpolated on, with a corner wherever clipping makes one; at most
/// 9, in order around it, fewer than 3 where nothing is left. View volume: what lies between near and far in
/// the window. Guard band: what lies behind near within the guard band.
std::vector<WindowCorner> window_polygon(const ViewFacts& facts, const TriangleExtent& extent,
                                         Clipping clipping, const ZRange& z);

/// Clipped corners of a guard band lie within it, in x and y (Direct3D 11.3, 15.16: 16.8 coordinates).
inline constexpr double guard_band_px = 32768;

/// All triangles of three corners.
template <class Act>
void for_each_triangle(std::span<const WindowCorner> polygon, const Act& act) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t j = i + 1; j < polygon.size(); ++j)
            for (std::size_t k = j + 1; k < polygon.size(); ++k) act(polygon[i], polygon[j], polygon[k]);
}

/// How far corners move before depth is interpolated, and what rounds their z.
struct CornerShift {
    double snap_px = 0;       ///< onto the sub-pixel grid, which plane equations need not follow
    double drift_px = 0;      ///< by rounding
    double least_z_term = 0;  ///< ZRange::least_term
};

inline constexpr double underflow_of_plane = 16 * 0x1p-126;  ///< what 16 results, flushed to zero, may lack

/// Errors of a plane equation anywhere on the triangle. z_error is unlimited where three corners may lie on a
/// line or nothing of the triangle is left.
struct PlaneEquationBounds {
    double z_error = 0;  ///< of the depth buffer's z
    double spread = 1;   ///< largest sum of |barycentrics| on what the snapped triangle covers
};

/// What z is to a plane equation: numbers whose signs are known, or the sizes of numbers of any sign.
enum class CornerSigns { known, any };

/// The worst of any three corners of the polygon: however it is cut into triangles, they are among them.
PlaneEquationBounds plane_equation_bounds(std::span<const WindowCorner> polygon, const CornerShift& shift,
                                          const View& view, CornerSigns signs = CornerSigns::known);

/// What triangles are clipped to: the window, or that grown to the guard band; in units of the image plane.
Window clip_window_of(const View& view, Clipping clipping);

/// How far corners and edges of a triangle in the window may be off.
struct EdgeShift {
    double drift_px = 0;  ///< of corners
    double edges_px = 0;  ///< of edge functions, beside that
};

/// How the weights of a triangle in the window are made.
struct WeightForm {
    EdgeFunctions edge_functions;
    ThirdWeight third_weight;
    double unit;              ///< roundoff of their arithmetic
    double area_epsilon_px2;  ///< is added to the area
    bool may_vanish;          ///< may near or far leave a piece of no area, so close to a corner they cut?
    double width, height;     ///< the image's

    bool is_rounded() const {
        return edge_functions == EdgeFunctions::from_corner ||
               edge_functions == EdgeFunctions::window_coefficients;
    }
};

/// The areas of the triangles that a polygon may be cut into, and what is made of them.
struct WindowAreas {
    double least_px2 = 0;   ///< what displacement by the drift leaves of the smallest; not above 0: unknown
    double of_area = 0;     ///< the largest relative error of an area, as a factor of all weights
    double of_weights = 0;  ///< the largest sum of the errors of a point's weights, inside the triangle
    double edges_px = 0;    ///< displaces edges beside EdgeShift::edges_px, at most across the image
};
WindowAreas window_areas(std::span<const WindowCorner> polygon, const EdgeShift& shift,
                         const WeightForm& form);

}  // namespace zproof
