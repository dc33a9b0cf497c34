/// Boxes of raster space around what a triangle may show, in double with the rounding error added.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "compare/bounds/bounds.h"
#include "compare/bounds/four.h"

namespace zproof {

/// A closed box of raster space, pixels; empty at first.
struct Box {
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
    bool fits(double side) const { return right - left <= side && bottom - top <= side; }
    bool meets(const Box& o) const {
        return left <= o.right && o.left <= right && top <= o.bottom && o.top <= bottom;
    }
    double middle_x() const { return 0.5 * (left + right); }
    double middle_y() const { return 0.5 * (top + bottom); }
};

/// The boxes that a triangle's corners lie in, side by side; the last lane repeats the third corner's.
struct alignas(four_alignment) CornerBoxes {
    Four left, top, right, bottom;

    Box of(std::size_t corner) const { return {left[corner], top[corner], right[corner], bottom[corner]}; }
    /// Around all of them.
    Box all() const {
        Box box = of(0);
        box.add(of(1));
        box.add(of(2));
        return box;
    }
};

/// The square of half-side reach_px around a pixel's centre.
inline Box square_around(int x, int y, double reach_px) {
    return {x + 0.5 - reach_px, y + 0.5 - reach_px, x + 0.5 + reach_px, y + 0.5 + reach_px};
}

/// A box of the image: places within half_x, half_y of a place (x, y), given as pixel indices (so that a
/// pixel's centre is a whole number).
struct Around {
    double x = 0, y = 0, half_x = 0, half_y = 0;
};

inline Box raster_box(const Around& at) {
    const double x = at.x + 0.5, y = at.y + 0.5;
    return {x - at.half_x, y - at.half_y, x + at.half_x, y + at.half_y};
}

inline Around around(const Box& raster) {
    return {raster.middle_x() - 0.5, raster.middle_y() - 0.5, 0.5 * (raster.right - raster.left),
            0.5 * (raster.bottom - raster.top)};
}

/// World to raster for boxes.
class BoxProjection {
  public:
    explicit BoxProjection(const View& view);

    /// Around the image of a triangle; nothing where it lies behind half the near depth.
    std::optional<Box> operator()(const CornersWorld& p_world) const;
    /// Around the image of one corner; nothing where it lies behind half the near depth or is no place.
    std::optional<Box> operator()(const glm::vec3& p_world) const;
    /// Of each of a triangle's corners, where all have one.
    std::optional<CornerBoxes> of_corners(const CornersWorld& p_world) const;

    /// What it is made of, for those who project many corners: a corner at depth z >= least_depth lies at
    /// (u - left) px_per_u, (top - v) px_per_v, with an error of at most
    /// px_of_rounding |corner - eye|_1 + 16 u max(|x|, |y|, 65536).
    struct Terms {
        Camera camera;
        bool perspective;
        double px_per_u, px_per_v;
        double least_depth;     ///< half the near depth
        double px_of_rounding;  ///< per unit of a corner's distance from the eye
    };
    const Terms& terms() const { return terms_; }

  private:
    glm::dvec3 to_camera(const glm::dvec3& from_eye) const;
    void add(Box& box, const glm::dvec3& p_camera) const;
    Box widened(Box box, double size) const;

    Terms terms_;
};

}  // namespace zproof
