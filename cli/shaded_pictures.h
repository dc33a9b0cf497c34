/// Colour pictures for a report: the candidate's frame shaded by zproof, and what witnesses paint themselves.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/witness_hearing.h"

namespace zproof {

/// A view whose frames are judged, ready to be painted.
struct Easel {
    const Docket& docket;
    const Frame& candidate;
    const Plane<PixelClass>& candidate_classes;
    std::filesystem::path folder;  ///< the view's evidence
};

/// Writes colour.exr and .png, and for every witness that was heard and can paint WITNESS-colour and
/// WITNESS-difference; how far its picture lies from the candidate's goes into its result, by the severer of
/// both renderers' classes. A witness that fails to paint keeps its statement; why stands in its result.
void paint(const Easel& easel, const std::vector<SummonedWitness>& witnesses,
           std::vector<Statement>& statements);

}  // namespace zproof
