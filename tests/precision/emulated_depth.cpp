#include "tests/precision/emulated_depth.h"

#include <algorithm>
#include <cmath>

namespace zproof {

namespace {

template <class T>
double ratio(double numerator, double denominator) {
    return T(numerator) / T(denominator);
}

template <class T>
double weighted_mean(const Weights& weights, const std::array<double, 3>& values) {
    return (T(weights[0]) * T(values[0]) + T(weights[1]) * T(values[1])) + T(weights[2]) * T(values[2]);
}

bool is_wide(const RasterPrecision& precision) { return precision.depth_format == DepthFormat::float64; }

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
                             const std::array<double, 3>& of_corners)
    : is_wide_(is_wide(precision)),
      is_plane_(precision.depth_interpolation == DepthInterpolation::plane),
      arithmetic_(precision.interpolation),
      of_corners_(of_corners) {
    if (!is_plane_) return;
    const auto x = [&](std::size_t i) { return float(window[i].x); };
    const auto y = [&](std::size_t i) { return float(window[i].y); };
    const float dx01 = x(0) - x(1), dy01 = y(0) - y(1), dx20 = x(2) - x(0), dy20 = y(2) - y(0);
    const float one_over_area = 1 / (dx01 * dy20 - dx20 * dy01);
    const auto z0 = float(of_corners[0]), z1 = float(of_corners[1]), z2 = float(of_corners[2]);
    const float rise01 = z0 - z1, rise20 = z2 - z0;
    per_x_ = rise01 * (dy20 * one_over_area) - rise20 * (dy01 * one_over_area);
    per_y_ = rise20 * (dx01 * one_over_area) - rise01 * (dx20 * one_over_area);
    at_origin_ = z0 - (per_x_ * (x(0) - 0.5f) + per_y_ * (y(0) - 0.5f));
}

double EmulatedValue::at(const glm::dvec2& p_raster, const Weights& weights) const {
    if (is_plane_) return (at_origin_ + per_x_ * float(p_raster.x - 0.5)) + per_y_ * float(p_raster.y - 0.5);
    const double mean = arithmetic_ == Arithmetic::float32 ? weighted_mean<float>(weights, of_corners_)
                                                           : weighted_mean<double>(weights, of_corners_);
    return is_wide_ ? mean : float(mean);
}

EmulatedDepthBuffer::EmulatedDepthBuffer(const View& view, const RasterPrecision& precision)
    : precision_(precision),
      is_perspective_(view.camera.projection == Projection::perspective),
      is_far_infinite_(std::isinf(view.camera.far_depth)),
      code_(depth_code(view.camera, precision)) {}

EmulatedInterpolation EmulatedDepthBuffer::on(const std::array<EmulatedCorner, 3>& piece,
                                              const WindowPiece& window) const {
    std::array<double, 3> z, linear;
    for (std::size_t i = 0; i < 3; ++i) {
        z[i] = z_of(piece[i]);
        linear[i] = linear_of(piece[i]);
    }
    return {*this, EmulatedValue(precision_, window, z), EmulatedValue(precision_, window, linear)};
}

double EmulatedDepthBuffer::step_of(double z, double steps) const {
    const float scaled = float(z) * float(steps);
    switch (precision_.depth_rounding) {
        case DepthRounding::either:
            return std::nearbyint(z * steps);
        case DepthRounding::nearest:
            return std::floor(double(scaled + 0.5f));
        case DepthRounding::truncate:
            return std::floor(double(scaled));
    }
    return 0;
}

/// 1 / depth (parallel: depth) of a corner.
float EmulatedDepthBuffer::linear_of(const EmulatedCorner& p) const {
    if (!is_perspective_) return float(p.depth);
    return float(precision_.transform == Arithmetic::float32 ? ratio<float>(1, p.w) : ratio<double>(1, p.w));
}

double EmulatedDepthBuffer::z_of(const EmulatedCorner& p) const {
    if (precision_.depth_buffer == DepthBuffer::camera_depth) return linear_of(p);
    const bool is_centred = precision_.clip_range == ClipRange::minus_one_to_one;
    if (is_wide(precision_) && precision_.transform == Arithmetic::float64)
        return is_centred ? ratio<double>(p.z, p.w) * 0.5 + 0.5 : ratio<double>(p.z, p.w);
    const auto z =
        float(precision_.transform == Arithmetic::float32 ? ratio<float>(p.z, p.w) : ratio<double>(p.z, p.w));
    return is_centred ? z * 0.5f + 0.5f : z;
}

double EmulatedDepthBuffer::stored(double z) const {
    if (precision_.depth_buffer == DepthBuffer::camera_depth) return z;
    const double kept = std::clamp(z, 0.0, 1.0);
    const double steps = steps_of(precision_.depth_format);
    if (steps == 0) return kept;
    const double last = is_far_infinite_ ? steps - 1 : steps;  // infinity is the background's depth
    return std::min(step_of(kept, steps), last) / steps;
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
                            ? buffer_.depth_of_linear(float(varying_.at(p_raster, weights)))
                            : buffer_.depth_of_stored(z);
    return {is_greater_nearer ? -z : z, shown};
}

}  // namespace zproof
