/// Triangles as polygons of raster space: projected by the lessons' stages in float64, cut by near and far.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "frame/frame.h"
#include "lessons/projection/camera.h"
#include "scenes/scene.h"

namespace zproof::study::projection {

/// A straight line from a to b, raster space.
struct RasterSegment {
    glm::dvec2 a{0}, b{0};
    bool operator==(const RasterSegment&) const = default;
};

double length_of(const RasterSegment& segment);

/// The least distance of two points, one on each.
double distance_between(const RasterSegment& s, const RasterSegment& t);

/// The part within the rectangle; nothing where there is none (Liang and Barsky 1984).
std::optional<RasterSegment> within(const RasterSegment& segment, const glm::dvec2& low,
                                    const glm::dvec2& high);

class Outliner {
  public:
    Outliner(const Scene& scene, const View& view) : scene_(scene), camera_(camera_of<double>(view)) {}

    /// The corners, in order, of what near and far leave of the triangle; empty where that is nothing, or a
    /// corner is not finite.
    std::vector<glm::dvec2> outline(PrimitiveId triangle) const;

    /// The outline's sides.
    std::vector<RasterSegment> sides(PrimitiveId triangle) const;

    /// What near and far leave of the line between two points of the world.
    std::optional<RasterSegment> line(const glm::vec3& a_world, const glm::vec3& b_world) const;

    /// Is the raster position within the triangle's outline, its border included?
    bool holds(PrimitiveId triangle, const glm::dvec2& p_raster) const;

  private:
    Vector3<double> in_camera(const glm::vec3& p_world) const;
    glm::dvec2 in_raster(const Vector3<double>& p_camera) const;

    const Scene& scene_;
    NumericCamera<double> camera_;
};

}  // namespace zproof::study::projection
