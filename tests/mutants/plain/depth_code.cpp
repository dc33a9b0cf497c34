#include "tests/mutants/plain/depth_code.h"

#include <algorithm>

namespace plain {
namespace {

constexpr float steps = 16'777'215;  ///< of 24 bits

ZMapping perspective_mapping(const Camera& camera, DepthBuffer buffer) {
    if (buffer == DepthBuffer::camera_depth) return {0, 1};
    if (buffer == DepthBuffer::reversed_z) return {0, camera.near};
    if (std::isinf(camera.far)) return {1, -camera.near};
    return {camera.far / (camera.far - camera.near), -camera.near * camera.far / (camera.far - camera.near)};
}

ZMapping parallel_mapping(const Camera& camera, DepthBuffer buffer) {
    const double range = camera.far - camera.near;
    if (buffer == DepthBuffer::camera_depth) return {-1, 0};
    if (buffer == DepthBuffer::reversed_z) return {-1 / range, camera.far / range};
    return {1 / range, -camera.near / range};
}

}  // namespace

ZMapping z_mapping(const Camera& camera, DepthBuffer buffer) {
    return camera.projection == Projection::parallel ? parallel_mapping(camera, buffer)
                                                     : perspective_mapping(camera, buffer);
}

DepthCode::DepthCode(const Camera& camera, DepthBuffer buffer)
    : projection_(camera.projection),
      buffer_(buffer),
      z_(z_mapping(camera, buffer)),
      largest_(std::isinf(camera.far) ? steps - 1 : steps) {}

float DepthCode::stored(float z) const {
    if (buffer_ != DepthBuffer::standard_z24) return z;
    return -std::clamp(std::nearbyint(z * steps), 0.0f, largest_);
}

float DepthCode::camera_depth(float stored) const {
    const double z = buffer_ == DepthBuffer::standard_z24 ? -stored / double(steps) : double(stored);
    if (projection_ == Projection::parallel) return float((z - z_.offset) / z_.factor);
    return float(z_.offset / (z - z_.factor));
}

}  // namespace plain
