/// A ray caster of this test's own: each pixel's ray against each triangle, in double. It shares no line with
/// rasterizer/, oracle/ or compare/.
#pragma once

#include <array>
#include <functional>

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::field_reports {

/// A triangle as the camera has it: right, up, depth.
struct CameraTriangle {
    std::uint32_t id = 0;
    std::array<glm::dvec3, 3> p_camera;
};

/// Two-fold signed area of a triangle's image, px^2. All corners must lie before the eye.
double double_area_px2(const View& view, const CameraTriangle& triangle);
/// Where a point's image lies, px.
glm::dvec2 raster_position(const View& view, const glm::dvec3& p_camera);

/// What a renderer does otherwise. Absent: as it should be.
struct Habits {
    std::function<glm::dvec2(int x, int y)> aims_at{};  ///< raster position of a pixel's ray
    std::function<bool(const CameraTriangle&)> draws{};
    double least_determinant = 0;  ///< of edges and ray, whose component ahead is 1
    /// Edges are moved outwards so far, px, in x and in y. Triangles must lie before the eye.
    double grown_px = 0;
    std::function<bool(const CameraTriangle&, int x, int y)> covers{};  ///< of the pixels that it meets
    double lead = 0;  ///< by so much must a later triangle lie nearer than what is drawn
};

/// The nearest triangle between near and far at each pixel; of equals, the first.
Frame cast(const Scene& scene, const View& view, const Habits& habits = {});

}  // namespace zproof::field_reports
