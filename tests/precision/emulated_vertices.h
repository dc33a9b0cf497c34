/// From world to window in the arithmetic that a declaration names, one rounding after the other.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// A corner before the divide. Values are those of the declared arithmetic, held without loss.
struct EmulatedCorner {
    double x = 0, y = 0, z = 0, w = 0;
    double depth = 0;  ///< camera depth; for perspective the same as w

    bool operator==(const EmulatedCorner&) const = default;
};
using EmulatedPolygon = std::vector<EmulatedCorner>;

/// The depth buffer's z, in [0, 1] between near and far, is offset + slope / depth (parallel: offset + slope
/// depth).
struct EmulatedDepthCode {
    double offset = 0, slope = 1;
};
EmulatedDepthCode depth_code(const Camera& camera, const RasterPrecision& precision);

class EmulatedTransform {
  public:
    EmulatedTransform(const View& view, const RasterPrecision& precision);

    EmulatedCorner operator()(const glm::vec3& p_world) const;

  private:
    using Rows = std::array<glm::dvec4, 5>;  ///< of x, y, z, w and depth

    template <class T>
    EmulatedCorner apply(const glm::vec3& p_world) const;

    Arithmetic arithmetic_;
    glm::dvec3 subtracted_;          ///< from corners, before any matrix
    std::vector<glm::dmat4> first_;  ///< by rows
    Rows last_;
};

/// What near, far, and the sides of the window or of the guard band leave of a triangle. A polygon that no
/// plane cuts is the triangle itself.
EmulatedPolygon emulated_clip(const View& view, const RasterPrecision& precision, EmulatedPolygon polygon);

/// Half the guard band's width.
inline constexpr double emulated_guard_band_px = 32768;

}  // namespace zproof
