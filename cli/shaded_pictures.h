/// Colour pictures for a report: the candidate's frame shaded by zproof, and what oracles paint themselves.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/oracle_answers.h"
#include "reports/view_picture.h"

namespace zproof {

/// A view whose frames are judged, ready to be painted.
struct PaintContext {
    const ViewContext& context;
    const Frame& candidate;
    const Plane<PixelClass>& candidate_classes;
    std::filesystem::path folder;  ///< the view's evidence
};

/// What the candidate saw (reports/view_picture.h), shaded by zproof with one light; black where it names no
/// triangle of the scene.
Plane<Rgb8> picture_of(const ViewContext& context, const Frame& candidate, const Plane<PixelClass>& classes,
                       PictureSize size);

/// Writes colour.exr and .png, and for every oracle that was compared and can paint ORACLE-colour and
/// ORACLE-difference; how far its picture lies from the candidate's goes into its result, by the severer of
/// both renderers' classes. An oracle that fails to paint keeps its answer; why stands in its result.
void paint(const PaintContext& paint_context, const std::vector<OpenedOracle>& oracles,
           std::vector<OracleAnswer>& answers);

}  // namespace zproof
