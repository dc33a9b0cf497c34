/// A triangle of the scene, and how large it is as error analysis sees it: sums of absolute products, the
/// same for every renderer of a view (docs/bounds.md, "A triangle's size").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compare/bounds/triangle_image.h"
#include "math/rounding.h"
#include "scenes/scene.h"

namespace zproof {

using CornersWorld = std::array<glm::vec3, 3>;

inline CornersWorld corners_of(const Scene& scene, std::uint32_t triangle) {
    const glm::uvec3& index = scene.triangles[triangle];
    const auto& p = scene.vertices.position_world;
    return {p[index.x], p[index.y], p[index.z]};
}

/// A triangle's corners in the number type asked for, without loss.
template <class Number>
Corners<Number> corners(const CornersWorld& p) {
    return {exactly<Number>(glm::dvec3(p[0])), exactly<Number>(glm::dvec3(p[1])),
            exactly<Number>(glm::dvec3(p[2]))};
}

/// Sums of absolute products behind inverse depth = (normal . direction) / volume: how ill-conditioned it is.
/// Parallel projections: depth = (normal . corner) / facing, in the same places.
struct PlaneSize {
    double volume{}, volume_abs{}, numerator_abs{};
    /// Parallel projections: what the judge's own rounding of the origin of the view ray may add to the
    /// numerator.
    double origin_error{};
};

/// Forward error of the judge's own inverse depth, computed in double by image_of: absolute sums of both
/// products, 16 roundings at most in each.
class PlaneError {
  public:
    PlaneError() = default;
    explicit PlaneError(const PlaneSize& size)
        : condition_(size.volume_abs / size.volume),
          numerator_(size.numerator_abs / size.volume),
          of_origin_(2.0 * size.origin_error / size.volume),
          is_known_(rounding * condition_ < 0.5) {}

    /// The error where |inverse depth| is at most `largest_inverse_depth`; infinite where the plane's
    /// orientation, as seen, is not certain.
    double at(double largest_inverse_depth) const {
        const double error = 2 * rounding * (numerator_ + largest_inverse_depth * condition_) + of_origin_;
        return is_known_ ? error : std::numeric_limits<double>::infinity();
    }

  private:
    static constexpr double rounding = gamma(16, unit_roundoff_float64);
    double condition_{}, numerator_{}, of_origin_{};
    bool is_known_ = false;
};

struct TriangleSize {
    std::array<double, 3> depth{};  ///< of the corners
    glm::dvec3 from_eye{0};         ///< max over corners of sum |axis_j| |p_j - eye_j|
    glm::dvec3 from_origin{0};      ///< max over corners of sum |axis_j| (|p_j| + |eye_j|)
    PlaneSize plane;

    /// The largest depth of a corner, in absolute value.
    double largest_depth() const {
        return std::max({std::abs(depth[0]), std::abs(depth[1]), std::abs(depth[2])});
    }
};

struct TriangleExtent {
    std::array<glm::dvec3, 3> v_world;  ///< corner - eye
    TriangleSize size;
};

}  // namespace zproof
