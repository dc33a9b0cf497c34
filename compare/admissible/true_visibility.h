/// What is truly visible at a pixel's centre, in double with its error bounded: a renderer may always answer
/// that, whatever it promises (docs/truth-proofs.md, "In double").
#pragma once

#include "compare/admissible/neighbourhood.h"

namespace zproof {

/// An answer, at a centre. No use is made of the neighbours' bounds.
class TrueVisibility {
  public:
    /// The centre lies `from_view_ray` of the pixel whose view ray the neighbours were seen from. `answer` is
    /// none for background. All must outlive this.
    TrueVisibility(const Camera& camera, const PixelOffset& from_view_ray, const Neighbour* answer);

    /// Does the triangle certainly hold the centre, between near and far? Background always does.
    bool is_answer_there() const;
    /// Does the other triangle certainly not hide it?
    bool is_seen_past(const Neighbour& other) const;

  private:
    /// The values that an affine function may have at the centre.
    struct Range {
        double least, most;
    };
    Range range_of(const Affine<double>& f, double error) const;
    Range plane_of(const Neighbour& n) const;
    bool is_outside(const Neighbour& n) const;

    PixelOffset centre_;  ///< from the view ray
    const Neighbour* answer_;
    double near_, far_;   ///< inverse depths
    double error_scale_;  ///< of errors within a pixel of the view ray; twice pays for the evaluation
};

}  // namespace zproof
