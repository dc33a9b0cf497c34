/// The smallest gap that is still ordered right, by trying.
#pragma once

#include <vector>

#include "lessons/depth/bound.h"

namespace zproof::study::depth {

/// The gap at one distance, all in scene units.
struct GapAt {
    double depth = 0;
    double predicted = 0;  ///< +inf where nothing between there and far can be told apart
    double measured = 0;   ///< every larger gap tried is ordered right at every pixel; +inf likewise
};

struct GapCurve {
    Format format;
    Interpolation interpolation = Interpolation::reciprocal;
    Planes planes;
    std::vector<GapAt> points;  ///< from near to far
};

/// The gaps at `distances` depths from near to far, spaced by equal ratios. Draws triangles of which no
/// corner lies farther than 1/64 of the depth from it, at random places, and each again with corners 1 + rho
/// times as far from the eye. rho goes down by 2^(1/8) at a time from four times what is predicted, until a
/// pixel shows the farther triangle, or until 80 steps are made. The numbers are the same every time.
GapCurve gap_curve(const Format& format, Interpolation interpolation, const Planes& planes, int distances);

}  // namespace zproof::study::depth
