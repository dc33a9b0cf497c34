/// The arbiter of the attack: what is seen of each triangle, in rationals. It is written from
/// docs/renderer-contract.md and docs/truth.md, and knows nothing of compare/.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "math/rational.h"
#include "scenes/scene.h"
#include "scenes/view.h"
#include "tests/attack/convex.h"

namespace zproof::attack {

using Number = Rational;
using ExactPlace = Place<Number>;
using ExactImage = Image<Number>;

/// Where a view cuts.
struct Planes {
    Number near;
    std::optional<Number> far;  ///< none: it is infinite
};
Planes planes_of(const View& view);

/// Nothing is seen farther than this from raster position (0, 0), in x or in y. What lies beyond is no
/// neighbour of a pixel, and places within it are integers of 2^-20 px in 64 bits.
inline constexpr int farthest_place_px = 32768;

/// A point before the divide.
struct Projected;

/// The view's projection of a scene's triangles, each cut by near, far and farthest_place_px.
class ExactScene {
  public:
    ExactScene(const Scene& scene, const View& view) : ExactScene(scene, view, planes_of(view)) {}
    ExactScene(const Scene& scene, const View& view, const Planes& planes);

    const View& view() const { return view_; }
    std::size_t size() const { return images_.size(); }
    const ExactImage& image(std::size_t triangle) const { return images_[triangle]; }
    /// What near and far alone leave of it.
    const ExactImage& left_by_planes(std::size_t triangle) const { return left_by_planes_[triangle]; }
    /// Does no part of that lie beyond farthest_place_px?
    bool is_near_by(std::size_t triangle) const { return is_near_by_[triangle]; }
    /// Does nothing cut it? Its image has the triangle's corners then, in their order.
    bool is_whole(std::size_t triangle) const { return is_whole_[triangle]; }
    /// Its image, rounded: to choose by, never to decide by.
    const Image<double>& rounded(std::size_t triangle) const { return rounded_[triangle]; }

    /// Camera depth from `front`.
    Number depth(const Number& front) const;
    double depth(double front) const { return is_perspective_ ? 1 / front : -front; }

  private:
    ExactImage divided(const std::vector<Projected>& polygon) const;

    View view_;
    bool is_perspective_;
    std::vector<ExactImage> images_, left_by_planes_;
    std::vector<Image<double>> rounded_;
    std::vector<bool> is_whole_, is_near_by_;
};

/// Where pixel (x, y) is sampled.
ExactPlace place_of(const View& view, int x, int y);
Place<double> rounded_place_of(const View& view, int x, int y);

}  // namespace zproof::attack
