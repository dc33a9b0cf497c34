#include "tests/precision/emulated_depth.h"

#include <algorithm>
#include <cmath>

namespace zproof {

namespace {

template <class T>
float ratio(double numerator, double denominator) {
    return float(T(numerator) / T(denominator));
}

template <class T>
float weighted_mean(const Weights& weights, const std::array<float, 3>& values) {
    return float((T(weights[0]) * T(values[0]) + T(weights[1]) * T(values[1])) +
                 T(weights[2]) * T(values[2]));
}

/// How many steps a fixed-point buffer has; 0 for floats.
double steps_of(DepthFormat format) {
    switch (format) {
        case DepthFormat::float32:
        case DepthFormat::float64:
            return 0;
        case DepthFormat::unorm16:
            return 0xFFFF;
        case DepthFormat::unorm24:
            return 0xFF'FFFF;
        case DepthFormat::unorm32:
            return 0xFFFF'FFFF;
    }
    return 0;
}

}  // namespace

/// The plane goes through corners as the transform left them, and has its origin at the window's corner.
EmulatedValue::EmulatedValue(const RasterPrecision& precision, const WindowPiece& window,
                             const std::array<float, 3>& of_corners)
    : is_plane_(precision.depth_interpolation == DepthInterpolation::plane),
      arithmetic_(precision.interpolation),
      of_corners_(of_corners) {
    if (!is_plane_) return;
    const auto x = [&](std::size_t i) { return float(window[i].x); };
    const auto y = [&](std::size_t i) { return float(window[i].y); };
    const float dx01 = x(0) - x(1), dy01 = y(0) - y(1), dx20 = x(2) - x(0), dy20 = y(2) - y(0);
    const float one_over_area = 1 / (dx01 * dy20 - dx20 * dy01);
    const float rise01 = of_corners[0] - of_corners[1], rise20 = of_corners[2] - of_corners[0];
    per_x_ = rise01 * (dy20 * one_over_area) - rise20 * (dy01 * one_over_area);
    per_y_ = rise20 * (dx01 * one_over_area) - rise01 * (dx20 * one_over_area);
    at_origin_ = of_corners[0] - (per_x_ * (x(0) - 0.5f) + per_y_ * (y(0) - 0.5f));
}

float EmulatedValue::at(const glm::dvec2& p_raster, const Weights& weights) const {
    if (is_plane_) return (at_origin_ + per_x_ * float(p_raster.x - 0.5)) + per_y_ * float(p_raster.y - 0.5);
    return arithmetic_ == Arithmetic::float32 ? weighted_mean<float>(weights, of_corners_)
                                              : weighted_mean<double>(weights, of_corners_);
}

EmulatedDepthBuffer::EmulatedDepthBuffer(const View& view, const RasterPrecision& precision)
    : precision_(precision),
      is_perspective_(view.camera.projection == Projection::perspective),
      is_far_infinite_(std::isinf(view.camera.far_depth)),
      code_(depth_code(view.camera, precision)) {}

EmulatedInterpolation EmulatedDepthBuffer::on(const std::array<EmulatedCorner, 3>& piece,
                                              const WindowPiece& window) const {
    std::array<float, 3> z, linear;
    for (std::size_t i = 0; i < 3; ++i) {
        z[i] = z_of(piece[i]);
        linear[i] = linear_of(piece[i]);
    }
    return {*this, EmulatedValue(precision_, window, z), EmulatedValue(precision_, window, linear)};
}

/// 1 / depth (parallel: depth) of a corner.
float EmulatedDepthBuffer::linear_of(const EmulatedCorner& p) const {
    if (!is_perspective_) return float(p.depth);
    return precision_.transform == Arithmetic::float32 ? ratio<float>(1, p.w) : ratio<double>(1, p.w);
}

float EmulatedDepthBuffer::z_of(const EmulatedCorner& p) const {
    if (precision_.depth_buffer == DepthBuffer::camera_depth) return linear_of(p);
    const float z =
        precision_.transform == Arithmetic::float32 ? ratio<float>(p.z, p.w) : ratio<double>(p.z, p.w);
    return precision_.clip_range == ClipRange::minus_one_to_one ? z * 0.5f + 0.5f : z;
}

double EmulatedDepthBuffer::stored(float z) const {
    if (precision_.depth_buffer == DepthBuffer::camera_depth) return z;
    const float kept = std::clamp(z, 0.0f, 1.0f);
    const double steps = steps_of(precision_.depth_format);
    if (steps == 0) return kept;
    const double last = is_far_infinite_ ? steps - 1 : steps;  // infinity is the background's depth
    return std::min(std::nearbyint(double{kept} * steps), last) / steps;
}

float EmulatedDepthBuffer::depth_of_stored(double z) const {
    if (precision_.depth_buffer == DepthBuffer::camera_depth) return depth_of_linear(float(z));
    if (precision_.linearization == Arithmetic::float32) {
        const float below = float(code_.offset) - float(z), slope = -float(code_.slope);
        return is_perspective_ ? slope / below : below / slope;
    }
    const double below = code_.offset - z;  // 0 at an infinite far plane
    return float(is_perspective_ ? -code_.slope / below : below / -code_.slope);
}

EmulatedDepth EmulatedInterpolation::at(const glm::dvec2& p_raster, const Weights& weights) const {
    const RasterPrecision& p = buffer_.precision_;
    const double z = buffer_.stored(tested_.at(p_raster, weights));
    const bool is_greater_nearer = p.depth_buffer == DepthBuffer::reversed_z ||
                                   (p.depth_buffer == DepthBuffer::camera_depth && buffer_.is_perspective_);
    const float shown = p.shown_depth == ShownDepth::varying
                            ? buffer_.depth_of_linear(varying_.at(p_raster, weights))
                            : buffer_.depth_of_stored(z);
    return {is_greater_nearer ? -z : z, shown};
}

}  // namespace zproof
