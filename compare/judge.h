/// The judge: decides for every pixel which answers are lawful, from scene, view and declared precision
/// alone.
#pragma once

#include "compare/verdict.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// A frame and what its renderer promises.
struct Testimony {
    const Frame& frame;
    Precision precision;
};

/// Judges every pixel on the threads of the surrounding tbb::task_arena; the result does not depend on their
/// number. Findings are those that fail the gate; judge_in_full() (compare/judge_in_full.h) has all, and
/// costs more. Both frames must have the view's size (std::invalid_argument otherwise).
Verdict judge(const Scene& scene, const View& view, const Testimony& candidate, const Testimony& reference);

/// The same, and how errors of depth are distributed over their bounds. Asks every pixel for its error, where
/// judge() asks most only whether it is lawful: up to three times the time.
Verdict judge_with_histograms(const Scene& scene, const View& view, const Testimony& candidate,
                              const Testimony& reference);

}  // namespace zproof
