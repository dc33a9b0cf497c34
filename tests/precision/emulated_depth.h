/// What a depth buffer holds, how it gets there, and which depth the frame shows.
#pragma once

#include "tests/precision/emulated_edges.h"

namespace zproof {

struct EmulatedDepth {
    double tested = 0;  ///< the smallest wins
    float shown = 0;    ///< camera depth
};

/// A value that is affine in the window, in the declared arithmetic.
class EmulatedValue {
  public:
    EmulatedValue(const RasterPrecision& precision, const WindowPiece& window,
                  const std::array<double, 3>& of_corners);
    double at(const glm::dvec2& p_raster, const Weights& weights) const;

  private:
    bool is_wide_, is_plane_;
    Arithmetic arithmetic_;
    std::array<double, 3> of_corners_;
    float at_origin_ = 0, per_x_ = 0, per_y_ = 0;
};

class EmulatedDepthBuffer;

/// Depth on one piece of a triangle.
class EmulatedInterpolation {
  public:
    EmulatedInterpolation(const EmulatedDepthBuffer& buffer, const EmulatedValue& tested,
                          const EmulatedValue& varying)
        : buffer_(buffer), tested_(tested), varying_(varying) {}
    EmulatedDepth at(const glm::dvec2& p_raster, const Weights& weights) const;

  private:
    const EmulatedDepthBuffer& buffer_;
    EmulatedValue tested_, varying_;
};

class EmulatedDepthBuffer {
  public:
    EmulatedDepthBuffer(const View& view, const RasterPrecision& precision);

    EmulatedInterpolation on(const std::array<EmulatedCorner, 3>& piece, const WindowPiece& window) const;
    double background() const { return HUGE_VAL; }
    /// Camera depth as a buffer of camera_depth tests it.
    double key_of_depth(float depth) const { return depth; }

  private:
    friend class EmulatedInterpolation;
    double z_of(const EmulatedCorner& p) const;
    float linear_of(const EmulatedCorner& p) const;
    float depth_of_linear(float linear) const { return is_perspective_ ? 1 / linear : linear; }
    /// What the buffer holds of an interpolated z.
    double stored(double z) const;
    double step_of(double z, double steps) const;
    float depth_of_stored(double z) const;

    RasterPrecision precision_;
    bool is_perspective_, is_far_infinite_;
    EmulatedDepthCode code_;
};

}  // namespace zproof
