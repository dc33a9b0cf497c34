/// Everything about a view that vertices and triangles need, derived once.
#pragma once

#include <cstdint>
#include <optional>

#include "frame/plane.h"
#include "rasterizer/clip.h"
#include "rasterizer/depth_functional.h"
#include "rasterizer/optimizations.h"
#include "rasterizer/projection.h"
#include "rasterizer/rules.h"
#include "rasterizer/snap.h"
#include "rasterizer/triangles.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

struct ViewSetup {
    Resolution size;
    ClipTransform clip_from_world;
    double guard_px;  ///< half-width of the guard band
    ClipVolume volume;
    SubpixelGrid grid;
    SnappedPoint
        sample;  ///< of the view, from the pixel's centre: what is snapped is moved by it, up and left
    DepthFunctional depth;
    FillRule fill = FillRule::top_left;
    RasterY raster_y = RasterY::down;
    Facing facing = Facing::both;
    HierarchicalZ hierarchical_z = HierarchicalZ::blocks;

    ViewSetup(const View& view, const Rules& rules, const Optimizations& optimizations = {});

    /// Divide by w > 0, viewport, snap. Nothing where the result leaves the guard band, which takes rounding
    /// gone astray (subnormal depths), or NaN: no such number is ever converted to an integer.
    std::optional<SnappedVertex> snap(const ClipVertex& v) const noexcept;

    struct GuardedVertex {
        SnappedVertex vertex;            ///< meaningful in the guard band
        std::int32_t in_guard_band = 0;  ///< 1 or 0
    };
    /// The raster position for kernels. Rounding may put a vertex of the guard band's border a hair outside.
    [[gnu::always_inline]] GuardedVertex land(const ClipVertex& v) const noexcept {
        const double x_ndc = v.x / v.w;
        const double y_ndc = v.y / v.w;
        const double x_raster = (x_ndc + 1) * (0.5 * size.width);
        const double y_down_ndc = raster_y == RasterY::down ? -y_ndc : y_ndc;
        const double y_raster = (y_down_ndc + 1) * (0.5 * size.height);
        const double limit = guard_px + 1;
        const bool is_in =
            (-limit <= x_raster) & (x_raster <= limit) & (-limit <= y_raster) & (y_raster <= limit);
        return {{{grid.snap(is_in ? x_raster : 0) - sample.x, grid.snap(is_in ? y_raster : 0) - sample.y},
                 depth.of_depth(v.depth)},
                is_in};
    }
};

}  // namespace zproof::rasterizer
