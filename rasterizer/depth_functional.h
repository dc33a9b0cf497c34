/// What the z-buffer compares: a number that is affine over a triangle's raster image and grows towards the
/// eye.
#pragma once

#include "rasterizer/rules.h"
#include "scenes/camera.h"

namespace zproof::rasterizer {

/// "Inverse depth": 1 / depth for perspective, -depth for parallel projections. The z-buffer holds it as
/// float32, rounded once; of two equal values the first to come stays.
///
/// The range is float32's: as 1 / depth it is relatively exact for depths of 2^-126 to 2^126 scene units.
struct DepthFunctional {
    enum class Form { reciprocal, linear };
    Form form = Form::reciprocal;
    double sign = 1;  ///< -1 turns the depth test round

    [[gnu::always_inline]] constexpr double of_depth(double depth) const {
        const bool is_reciprocal = form == Form::reciprocal;
        const double linear = -sign * depth;
        return (is_reciprocal ? sign : linear) / (is_reciprocal ? depth : 1.0);  // no branch, for vectors
    }
    /// Camera depth of a stored value. The quotient of two float32, computed in float32, is rounded once.
    [[gnu::always_inline]] constexpr float depth_of(float inverse_depth) const {
        const float s = static_cast<float>(sign);
        return form == Form::reciprocal ? s / inverse_depth : -s * inverse_depth;
    }
};

/// No pixel that a triangle covers gets more, of vertices with these: max N + 4u max |N| (u = 2^-53, of three
/// roundings per term and the quotient's; what underflow adds is lost in the rounding to float32). 2^-50 is
/// twice that, for this sum's own rounding. Rounding to float32 keeps the order.
[[gnu::always_inline]] constexpr float nearest_pixel(double n0, double n1, double n2) {
    const auto greater = [](double a, double b) { return a > b ? a : b; };
    const auto magnitude = [](double a) { return a < 0 ? -a : a; };
    const double most = greater(n0, greater(n1, n2));
    const double largest = greater(magnitude(n0), greater(magnitude(n1), magnitude(n2)));
    return static_cast<float>(most + 0x1p-50 * largest);
}

constexpr DepthFunctional depth_functional(Projection projection, const Rules& rules) {
    const bool affine_in_raster_space = projection == Projection::parallel;
    const bool reciprocal =
        !affine_in_raster_space && rules.depth_interpolation == DepthInterpolation::perspective_correct;
    return {.form = reciprocal ? DepthFunctional::Form::reciprocal : DepthFunctional::Form::linear,
            .sign = rules.depth_test == DepthTest::nearer_wins ? 1.0 : -1.0};
}

}  // namespace zproof::rasterizer
