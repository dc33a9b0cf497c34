/// A scene's edges as lines of raster space: every edge once, cut by near, far and the picture, and told
/// apart by whether it is seen.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lessons/projection/outline.h"

namespace zproof::study::projection {

/// An edge of the scene; corners at one place are one corner.
struct SceneEdge {
    std::uint32_t from = 0, to = 0;        ///< vertices of the scene at its ends
    std::vector<std::uint32_t> triangles;  ///< that have it, at least one, rising
};

/// Edges of no length are left out. In the order of their first triangles.
std::vector<SceneEdge> edges_of(const Scene& scene);

enum class Visibility {
    seen,
    hidden,
    unknown,  ///< nobody was asked
};

struct WireLine {
    RasterSegment segment;   ///< within the picture
    std::uint32_t edge = 0;  ///< index into Wireframe::edges
    Visibility visibility = Visibility::unknown;
};

struct Wireframe {
    std::vector<SceneEdge> edges;
    std::vector<WireLine> lines;  ///< by edge, those that show in the picture
};

/// The lines are projected in float64 by the lessons' stages; off axis, parallel and oblique cameras alike.
Wireframe wireframe_of(const Scene& scene, const View& view);

/// The lines of a wireframe, cut where they become visible or hidden: a piece of about one pixel's length is
/// seen where a triangle that has the edge is named by a pixel around its middle (3 x 3). So an occluder's
/// border is found to about a pixel; the lines' places are as exact as before.
Wireframe split_by_visibility(const Wireframe& wireframe, const Plane<PrimitiveId>& ids);

}  // namespace zproof::study::projection
