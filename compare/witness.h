/// One renderer before the judge: its frame, its bounds, and what can be said of its answers one pixel at a
/// time.
#pragma once

#include "compare/judge.h"
#include "compare/truth/depth_bound.h"

namespace zproof {

/// Not an answer at all: NaN, negative depth, an id out of range, background with a depth.
bool is_invalid(const Answer& answer, std::size_t triangle_count);

/// A renderer's depth at one pixel held against the bound of its own id.
struct DepthCheck {
    DepthBound bound;
    double error_over_bound = 0;
    bool lawful = false;
};

class Witness {
  public:
    Witness(const Scene& scene, const View& view, const Testimony& testimony)
        : scene_(scene),
          view_(view),
          first_pixel_(view, 0, 0),
          frame_(testimony.frame),
          bounds_(view, testimony.precision) {}

    Answer answer_at(int x, int y) const { return {frame_.primitive.at(x, y), frame_.camera_depth.at(x, y)}; }
    const Frame& frame() const { return frame_; }
    const ViewBounds& bounds() const { return bounds_; }
    const View& view() const { return view_; }
    Projection projection() const { return first_pixel_.projection; }

    /// The same for every witness of the view. The id must be a triangle of the scene.
    TriangleInView triangle_in_view(PrimitiveId primitive) const;
    /// `triangle` must be the depth of the answer's id.
    DepthCheck check(const TriangleDepth& triangle, const Answer& answer, int x, int y) const;

  private:
    const Scene& scene_;
    const View& view_;
    Sight<double> first_pixel_;
    const Frame& frame_;
    ViewBounds bounds_;
};

/// What is compared.
struct Comparands {
    const Scene& scene;
    const View& view;
    const Witness &candidate, &reference;
};

}  // namespace zproof
