/// The least displacement under which answers are admissible, by the judge's own rule (docs/fit.md).
#pragma once

#include <span>
#include <vector>

#include "compare/bounds/pixel_coord.h"
#include "compare/verdict.h"
#include "measure/fit/octaves.h"
#include "measure/measurement.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::measure {

/// What may open between occluders at a pixel.
enum class Mesh {
    closed,      ///< nothing
    with_seams,  ///< triangles that touch without sharing an edge may part (Admissibility::through_a_crack)
    with_gaps,   ///< triangles that share an edge may, too
};

/// What a frame shows at one pixel.
struct PixelAnswer {
    PixelCoord pixel;
    Answer answer;
    Mesh mesh = Mesh::closed;
};

/// What is granted to depths.
struct Allowance {
    enum class Depths {
        bounded,  ///< an error of depth_relative
        any,      ///< nothing hides, and near and far may lie anywhere: place alone decides
    };
    double depth_relative = 0;
    Depths depths = Depths::bounded;
};

/// eps is told in steps: the greater of two neighbours is less than 2 % above the other.
inline constexpr int steps_per_octave = 36;
double eps_px_at(int step);
inline constexpr double least_eps_px = 0x1p-30;  ///< what needs no more counts as right

/// eps.low does not explain all of some answers, eps.high does. Low is 0 where least_eps_px explains them.
struct LeastEps {
    Bracket px{0, least_eps_px};
    std::vector<PixelCoord> decided_by;  ///< what eps.low does not explain

    double found_px() const { return px.low > 0 ? px.high : 0; }
};

/// One view's answers and the judge's rule, on the threads of the surrounding tbb::task_arena.
class PlaceRule {
  public:
    /// Both must outlive it.
    PlaceRule(const Scene& scene, const View& view) : scene_(scene), view_(view) {}

    /// Which answers are admissible under that eps, in their order?
    std::vector<bool> admit(std::span<const PixelAnswer> answers, double eps_px,
                            const Allowance& allowance) const;
    /// The answers that are not.
    std::vector<PixelAnswer> inadmissible(std::span<const PixelAnswer> answers, double eps_px,
                                          const Allowance& allowance) const;
    /// By answer: the octave of the least eps that explains it.
    std::vector<int> octaves(std::span<const PixelAnswer> answers, const Allowance& allowance) const;
    /// The least eps that explains all of them; `octaves` are theirs, and none is no_octave.
    LeastEps least(std::span<const PixelAnswer> answers, std::span<const int> octaves,
                   const Allowance& allowance) const;

  private:
    const Scene& scene_;
    const View& view_;
};

}  // namespace zproof::measure
