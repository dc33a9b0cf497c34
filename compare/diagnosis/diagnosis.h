/// Why a view fails: hypotheses put to the judge, and the one that nothing speaks against
/// (docs/diagnosis.md).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/diagnosis/diagnosis_result.h"
#include "compare/judge.h"
#include "compare/labels/labelled_frame.h"
#include "frame/convention.h"

namespace zproof {

/// What explained earlier views of a run.
struct EarlierCause {
    std::string name;
    double saved_bits = 0, all_bits = 0;  ///< over these views: what it spares, of what the defects take
};

/// What a frame was that became one of triangles and camera depths.
struct FrameAsGiven {
    std::optional<SaidLabels> said{};  ///< nothing: it names triangles
    Convention convention{};           ///< of its depths
};

/// Shares of what is spared that differ by less are alike: they are known from samples of a thousand pixels.
inline constexpr double alike_shares = 0.01;

/// Tests every hypothesis on a verdict's defects, or on an evenly spread part of them where they are many.
/// A cause is named where nothing that was asked speaks against it and it shortens the description of the
/// frame by three quarters of what the defects take, with further causes of what it leaves, where there are
/// some (docs/diagnosis.md, "Named, or not"). Nothing without defects. Deterministic for any number of
/// threads; frames as judge() wants them. `given`: what the candidate's frame was before it was judged.
/// `without`: names of hypotheses that are left out, to learn what is said of a cause that nobody thought of.
/// `earlier`: asked before all others, and alone where one of them explains this view too.
std::optional<Diagnosis> diagnose(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                  const RenderedFrame& reference, const Verdict& verdict,
                                  const FrameAsGiven& given = {}, std::span<const std::string> without = {},
                                  std::span<const EarlierCause> earlier = {});

}  // namespace zproof
