/// The judge: decides for every pixel which answers are admissible, from scene, view and declared precision
/// alone.
#pragma once

#include "compare/rendered_frame.h"
#include "compare/verdict.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// What is wanted of a verdict beside classes, counts and records. No class depends on it.
struct JudgeOptions {
    enum class Findings {
        defects,      ///< pixels that fail the gate
        differences,  ///< all pixels that do not `agree`
    };
    Findings findings = Findings::defects;
    enum class Errors { records, maps };
    Errors errors = Errors::records;  ///< maps: Verdict::errors, too
};

/// All that there is: for pages that show it.
inline constexpr JudgeOptions full_detail{.findings = JudgeOptions::Findings::differences,
                                          .errors = JudgeOptions::Errors::maps};

/// Judges every pixel on the threads of the surrounding tbb::task_arena; the result does not depend on their
/// number. Where the surrounding task group is cancelled, the verdict is incomplete: throw it away. Both
/// frames must have the view's size (std::invalid_argument otherwise).
Verdict judge(const Scene& scene, const View& view, const RenderedFrame& candidate,
              const RenderedFrame& reference, const JudgeOptions& options = {});

}  // namespace zproof
