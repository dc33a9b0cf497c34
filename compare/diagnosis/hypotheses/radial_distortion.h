/// Lenses that bend rays: a claim is asked for at another place of the image, by the same rules and bounds.
#pragma once

#include "compare/diagnosis/hypotheses/other_world.h"

namespace zproof {

/// Which of the two is the other times 1 + k1 r^2: the place in the image, at depth 1, of a ray or of a
/// pixel.
enum class Distorted { pixel, ray };

struct RadialDistortion {
    double k1 = 0;
    Distorted distorted = Distorted::pixel;
    glm::dvec2 unit{1};  ///< r is measured in it, right and up

    /// Where the ray of a pixel meets the plane of depth 1, right and up of the axis.
    glm::dvec2 ray_of(const glm::dvec2& pixel) const;
};

/// The hypothesis that the frame shows the declared scene through that lens.
Hypothesis shown_through(const DiagnosisInput& input, Cause cause, const RadialDistortion& lens);

}  // namespace zproof
