#include "scenes/camera_depth.h"

#include <algorithm>
#include <cmath>

#include "frame/frame_error.h"

namespace zproof {
namespace {

/// Focal length in pixels, along x.
double focal_px(const View& view) {
    return view.width / (view.camera.window.right - view.camera.window.left);
}

/// Equal as numbers of the stored type, which may be float32; NaN equals NaN.
bool same_number(double stored, double declared) {
    return stored == declared || stored == double(float(declared)) ||
           (std::isnan(stored) && std::isnan(declared));
}

}  // namespace

CameraDepth::CameraDepth(const Convention& convention, const View& view)
    : convention_(convention), view_(view) {
    if (convention.depth_kind == DepthKind::disparity && view.camera.projection == Projection::parallel)
        throw FrameError("view '" + view.name +
                         "': a parallel projection has no disparity; expected another depth_kind");
}

double CameraDepth::operator()(double stored, int x, int y) const {
    const double value = stored * convention_.depth_scale;
    const Camera& camera = view_.camera;
    switch (convention_.depth_kind) {
        case DepthKind::camera:
            return value;
        case DepthKind::ray_length:
            return value * per_length(x, y);
        case DepthKind::ray_length_from_near:
            return camera.near_depth + value * per_length(x, y);
        case DepthKind::ndc_z:
            return of_remaining_z((1 - value) / 2);
        case DepthKind::window_z:
            return of_remaining_z(1 - value);
        case DepthKind::reversed_z:
            return of_remaining_z(value);
        case DepthKind::inverse:
            return 1 / value;
        case DepthKind::disparity:
            break;
    }
    return focal_px(view_) * convention_.baseline.value() / value;
}

bool CameraDepth::is_identity() const {
    return convention_.depth_kind == DepthKind::camera && convention_.depth_scale == 1;
}

double CameraDepth::per_length(int x, int y) const {
    const Camera& camera = view_.camera;
    const Window& w = camera.window;
    if (camera.projection == Projection::parallel)
        return 1 / std::sqrt(1 + camera.shear.x * camera.shear.x + camera.shear.y * camera.shear.y);
    const glm::dvec2 p_raster = sampled_at(view_, x, y);
    const double u = w.left + (w.right - w.left) * p_raster.x / view_.width;
    const double v = w.top - (w.top - w.bottom) * p_raster.y / view_.height;
    return 1 / std::sqrt(1 + u * u + v * v);
}

double CameraDepth::of_remaining_z(double q) const {
    const auto [near, far] = std::pair{view_.camera.near_depth, view_.camera.far_depth};
    if (view_.camera.projection == Projection::parallel) return near + (1 - q) * (far - near);
    // Perspective: q = (1/depth - 1/far) / (1/near - 1/far). No term of the sum cancels another.
    return std::isinf(far) ? near / q : near * far / (near + q * (far - near));
}

bool CameraDepth::is_background(double stored) const {
    const auto is_declared = [&](double declared) { return same_number(stored, declared); };
    return std::ranges::any_of(convention_.background_depths, is_declared) ||
           (convention_.far_is_background && is_declared(far_value() / convention_.depth_scale));
}

double CameraDepth::far_value() const {
    const double far = view_.camera.far_depth;
    switch (convention_.depth_kind) {
        case DepthKind::ndc_z:
        case DepthKind::window_z:
            return 1;
        case DepthKind::reversed_z:
            return 0;
        case DepthKind::inverse:
            return 1 / far;
        case DepthKind::disparity:
            return focal_px(view_) * convention_.baseline.value() / far;
        default:
            return far;
    }
}

}  // namespace zproof
