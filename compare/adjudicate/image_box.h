/// Boxes of raster space around what a triangle may show, in double with the rounding error added.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "compare/bounds/bounds.h"

namespace zproof {

/// A closed box of raster space, pixels; empty at first.
struct Box {
    /// Finite, so that an empty box does not meet what it bounds.
    static constexpr double without_end = std::numeric_limits<double>::max();

    double left = std::numeric_limits<double>::infinity(), top = left, right = -left, bottom = -left;

    void add(double x, double y) {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
    }
    void add(const Box& o) {
        add(o.left, o.top);
        add(o.right, o.bottom);
    }
    void widen(double by) { left -= by, top -= by, right += by, bottom += by; }
    bool is_empty() const { return !(left <= right && top <= bottom); }
    static Box unlimited() { return {-without_end, -without_end, without_end, without_end}; }
    bool operator==(const Box&) const = default;
    bool holds(double x, double y) const { return left <= x && x <= right && top <= y && y <= bottom; }
    bool meets(const Box& o) const {
        return left <= o.right && o.left <= right && top <= o.bottom && o.top <= bottom;
    }
};

/// The square of half-side reach_px around a pixel's centre.
inline Box square_around(int x, int y, double reach_px) {
    return {x + 0.5 - reach_px, y + 0.5 - reach_px, x + 0.5 + reach_px, y + 0.5 + reach_px};
}

/// World to raster for boxes. Raster space is moved so that the view samples every pixel at its centre.
class BoxProjection {
  public:
    explicit BoxProjection(const View& view);

    /// The box around the image of what a triangle has beyond half the near depth; empty where that is none.
    Box operator()(const CornersWorld& p_world) const;
    /// The box around all that it has before the eye, however near, in a perspective.
    Box before_eye(const CornersWorld& p_world) const;
    /// The box around one corner's image; empty where it lies nearer than half the near depth or is no place.
    Box operator()(const glm::vec3& p_world) const;

  private:
    struct InCamera {
        std::array<glm::dvec3, 3> p_camera;
        double size;  ///< the largest sum of a corner's absolute coordinates, from the eye
    };
    InCamera in_camera(const CornersWorld& p_world) const;
    glm::dvec3 to_camera(const glm::dvec3& from_eye) const;
    void add(Box& box, const glm::dvec3& p_camera) const;
    Box widen(Box box, double size, double nearest) const;

    Camera camera_;
    bool perspective_;
    glm::dvec2
        sample_px_;  ///< boxes lie by it up and left of the image: as if pixels were sampled at their centres
    double px_per_u_, px_per_v_;
    double least_depth_;  ///< half the near depth
};

}  // namespace zproof
