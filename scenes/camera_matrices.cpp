#include "scenes/camera_matrices.h"

#include <cmath>

namespace zproof {

namespace {

/// What near and far become in NDC.
struct NdcRange {
    double near_z, far_z;
};

NdcRange range_of(NdcDepth depth) {
    if (depth == NdcDepth::minus_one_to_one) return {-1, 1};
    return depth == NdcDepth::zero_to_one ? NdcRange{0, 1} : NdcRange{1, 0};
}

/// z_ndc = a + b / depth, row z of the matrix (0, 0, -a, b): near and far land on the ends of the range.
std::array<double, 4> perspective_z(const Camera& camera) {
    const auto [near_z, far_z] = range_of(camera.ndc_depth);
    const double near = camera.near_depth, far = camera.far_depth;
    if (std::isinf(far)) return {0, 0, -far_z, (near_z - far_z) * near};
    return {0, 0, -(far_z * far - near_z * near) / (far - near),
            (near_z - far_z) * near * far / (far - near)};
}

/// z_ndc = near_z + (far_z - near_z) (depth - near) / (far - near).
std::array<double, 4> parallel_z(const Camera& camera) {
    const auto [near_z, far_z] = range_of(camera.ndc_depth);
    const double slope = (far_z - near_z) / (camera.far_depth - camera.near_depth);
    return {0, 0, -slope, near_z - slope * camera.near_depth};
}

}  // namespace

MatrixRows camera_from_world(const Camera& camera) {
    const glm::dvec3 eye{camera.eye_world};
    const auto row = [&](const glm::dvec3& axis) {
        return std::array{axis.x, axis.y, axis.z, -glm::dot(axis, eye)};
    };
    return {row(camera.right), row(camera.up), row(camera.back), std::array{0.0, 0.0, 0.0, 1.0}};
}

MatrixRows clip_from_camera(const Camera& camera) {
    const Window& w = camera.window;
    const double x = 2 / (w.right - w.left), y = 2 / (w.top - w.bottom);
    const double x_centre = (w.right + w.left) / (w.right - w.left),
                 y_centre = (w.top + w.bottom) / (w.top - w.bottom);
    if (camera.projection == Projection::perspective)
        return {std::array{x, 0.0, x_centre, 0.0}, std::array{0.0, y, y_centre, 0.0}, perspective_z(camera),
                std::array{0.0, 0.0, -1.0, 0.0}};
    return {std::array{x, 0.0, x * camera.shear.x, -x_centre},
            std::array{0.0, y, y * camera.shear.y, -y_centre}, parallel_z(camera),
            std::array{0.0, 0.0, 0.0, 1.0}};
}

}  // namespace zproof
