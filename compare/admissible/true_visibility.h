/// What is truly visible all over a square, in double with its error bounded: a renderer may always answer
/// what is truly at a pixel's centre, whatever it promises (docs/truth-proofs.md, "In double").
#pragma once

#include "compare/admissible/neighbourhood.h"

namespace zproof {

/// A square of the image plane around a point, which lies `from_view_ray` of the pixel whose view ray the
/// neighbours were seen from.
struct SquareInView {
    PixelOffset from_view_ray;
    double half_side_px;
};

/// An answer, at any place of a square. No use is made of the neighbours' bounds.
class TrueVisibility {
  public:
    /// `answer` is none for background. All must outlive this.
    TrueVisibility(const Camera& camera, const SquareInView& square, const Neighbour* answer);

    /// Does the triangle certainly hold all of the square, between near and far? Background always does.
    bool is_answer_there() const;
    /// Does the other triangle certainly hide it nowhere in the square?
    bool is_seen_past(const Neighbour& other) const;

  private:
    /// The values that an affine function may have in the square.
    struct Range {
        double least, most;
    };
    Range range_of(const Affine<double>& f, double error) const;
    Range plane_of(const Neighbour& n) const;
    bool is_outside(const Neighbour& n) const;

    SquareInView square_;
    const Neighbour* answer_;
    double near_, far_;   ///< inverse depths
    double error_scale_;  ///< of errors within a pixel of the view ray; twice pays for the evaluation
};

}  // namespace zproof
