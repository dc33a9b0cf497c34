/// Everything about a view that vertices and triangles need, derived once.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "frame/plane.h"
#include "rasterizer/clip.h"
#include "rasterizer/depth_functional.h"
#include "rasterizer/draw_list.h"
#include "rasterizer/kernel.h"
#include "rasterizer/projection.h"
#include "rasterizer/rules.h"
#include "rasterizer/snap.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

struct ViewSetup {
    Resolution size;
    ClipTransform clip_from_world;
    double guard_px;  ///< half-width of the guard band
    ClipVolume volume;
    SubpixelGrid grid;
    DepthFunctional depth;
    FillRule fill = FillRule::top_left;
    RasterY raster_y = RasterY::down;
    Facing facing = Facing::both;
    HierarchicalZ hierarchical_z = HierarchicalZ::blocks;

    ViewSetup(const View& view, const Rules& rules, const Tricks& tricks = {});

    /// Divide by w > 0, viewport, snap. Nothing where the result leaves the guard band, which takes rounding
    /// gone astray (subnormal depths), or NaN: no such number is ever converted to an integer.
    std::optional<SnappedVertex> snap(const ClipVertex& v) const noexcept;
};

/// The vertices of a scene as one view sees them.
struct ProjectedVertices {
    std::vector<SnappedVertex>
        snapped;  ///< meaningful where the outcode has no needs_clip and no not_finite bit
    std::vector<std::uint8_t> outcode;

    /// Transforms every vertex once, on the threads of the surrounding tbb::task_arena. Memory is kept from
    /// the time before.
    void fill(const Vertices& vertices, const ViewSetup& setup);

    /// The same for some vertices; what is known of the others means nothing.
    void fill(const Vertices& vertices, const ViewSetup& setup, std::span<const Range> ranges);
};

}  // namespace zproof::rasterizer
