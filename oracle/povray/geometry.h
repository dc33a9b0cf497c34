/// A view's triangles in POV-Ray's units, in clusters.
///
/// POV-Ray's units are scene units times a power of two, with the eye at the origin and the world's axes: the
/// difference of corner and eye is rounded once to double, and the rest is exact.
#pragma once

#include <array>
#include <vector>

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// The sizes that a view gives to POV-Ray's world.
struct PovrayUnits {
    double scale = 1;          ///< POV-Ray's units per scene unit, a power of two
    double low = 1, high = 2;  ///< depths of all that is seen lie between these; POV-Ray's units
    double near = 0, far = 0;  ///< the clip planes; POV-Ray's units, far may be +inf
    double start = 0;  ///< depth of the rays' origins: 0, or in front of `low` for parallel projections
    double origin_reach = 0;  ///< no coordinate of a ray's origin is larger
};

/// Whether near and far leave a triangle as it is.
enum class Cut { none, by_near_or_far };

struct PovrayTriangle {
    PrimitiveId primitive;
    std::array<glm::dvec3, 3> corner;
};

/// Neighbours that POV-Ray finds by one box.
struct PovrayCluster {
    std::vector<PovrayTriangle> triangles;
    Cut cut = Cut::none;
    /// A box that holds the triangles with a margin of 256 float32 roundings of its coordinates and those of
    /// the rays' origins. POV-Ray keeps boxes, and meets them with rays, in float32.
    glm::dvec3 lowest, highest;
};

struct PovrayGeometry {
    PovrayUnits units;
    std::vector<PovrayCluster> clusters;
};

/// Leaves out triangles that lie wholly before near or beyond far, those too thin to have a normal, and those
/// that no ray meets (povray/raster_box.h). Throws OracleError, naming the view, where what is seen spans
/// more depth than POV-Ray can reach.
PovrayGeometry povray_geometry(const Scene& scene, const View& view);

}  // namespace zproof::oracle
