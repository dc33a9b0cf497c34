/// A camera as plain facts. Rasterizer, oracle and judge each derive their own projection from these.
///
/// Camera space is right-handed, y up, looking down -z. For the raster position (x, y) of a W x H image let
///     u = window.left + (window.right - window.left) x / W,
///     v = window.top - (window.top - window.bottom) y / H.
/// Then the pixel's view ray, parametrised by camera depth t = -z_camera, is
///     perspective:  p_camera(t) = t (u, v, -1)
///     parallel:     p_camera(t) = (u, v, 0) + t (shear.x, shear.y, -1)
/// and p_world = eye_world + p_camera.x right + p_camera.y up + p_camera.z back.
/// All numbers are exact: they define the one true picture. Pixel (i, j) is sampled at (i + 1/2, j + 1/2), or
/// beside it where the view says so (scenes/sample.h).
#pragma once

#include <glm/glm.hpp>

namespace zproof {

enum class Projection {
    perspective,
    parallel,  ///< orthographic, or oblique where shear is not 0
};

/// The range of NDC z that the camera's projection matrix maps near and far to.
enum class NdcDepth {
    minus_one_to_one,      ///< OpenGL, glTF: near -1, far 1
    zero_to_one,           ///< Direct3D, Vulkan: near 0, far 1
    zero_to_one_reversed,  ///< near 1, far 0
};

/// The part of the image plane that fills the image: of the plane at camera depth 1 for perspective
/// (tangents), of the plane through the eye for parallel projections (scene units). left < right and
/// bottom < top.
struct Window {
    double left = -1, right = 1, bottom = -1, top = 1;
};

struct Camera {
    glm::vec3 eye_world{0, 0, 0};  ///< float32, baked like every other position
    /// Camera axes in world space, orthonormal to a few ulps of double.
    glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
    Projection projection = Projection::perspective;
    Window window;
    glm::dvec2 shear{0, 0};                     ///< parallel only: sideways step per unit of depth
    double near_depth = 0.1, far_depth = 1000;  ///< 0 < near < far <= +inf; parallel: near < far, far finite
    NdcDepth ndc_depth = NdcDepth::minus_one_to_one;
};

/// Throws SceneError, naming the field, where a number is not finite, an interval is empty, or the axes are
/// not orthonormal within 1e-12.
void validate(const Camera& camera);

/// Orientation of a camera at eye that looks at target; up is a hint. The eye is rounded to float32 first,
/// and the axes are computed from the rounded eye. Throws SceneError where eye, target and up do not span a
/// view.
Camera look_at(const glm::dvec3& eye_world, const glm::dvec3& target_world, const glm::dvec3& up_world);

/// The window of a symmetric perspective camera: vertical field of view in radians (0, pi), width / height.
Window symmetric_window(double yfov_radians, double aspect);

}  // namespace zproof
