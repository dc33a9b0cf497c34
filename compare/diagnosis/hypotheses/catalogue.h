/// Every hypothesis that a diagnosis tests, in families. Within a family, and from one to the next, the more
/// specific stands first (docs/diagnosis.md).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// Answers that are none: a depth that is no number, a background that is not told as one.
std::vector<Hypothesis> hypotheses_of_signs(const DiagnosisInput& input);
/// The image is flipped, turned or shifted.
std::vector<Hypothesis> hypotheses_of_place(const DiagnosisInput& input);
/// The grid of pixels is stretched, coarse or sampled beside the centres.
std::vector<Hypothesis> hypotheses_of_grid(const DiagnosisInput& input);
/// Depth is told in other units.
std::vector<Hypothesis> hypotheses_of_depth(const DiagnosisInput& input);
/// The image is flipped, too: two mistakes of one read-back.
std::vector<Hypothesis> hypotheses_of_flipped_depth(const DiagnosisInput& input);
/// Depth is that of another place, averaged, or of another scale that is fitted.
std::vector<Hypothesis> hypotheses_of_depth_elsewhere(const DiagnosisInput& input);
/// Depth is made of several samples of a pixel.
std::vector<Hypothesis> hypotheses_of_resolved_depth(const DiagnosisInput& input);
/// Depth was kept in bytes of one base, and read to another.
std::vector<Hypothesis> hypotheses_of_packed_depth(const DiagnosisInput& input);
/// Ids name other triangles.
std::vector<Hypothesis> hypotheses_of_ids(const DiagnosisInput& input);
/// Ids name more than one triangle each.
std::vector<Hypothesis> hypotheses_of_shared_ids(const DiagnosisInput& input);
/// Labels name other labels; where a candidate has no ids, its depths say where background is.
std::vector<Hypothesis> hypotheses_of_labels(const DiagnosisInput& input);
/// Ids, or labels, are means of those around.
std::vector<Hypothesis> hypotheses_of_blended_ids(const DiagnosisInput& input);
/// Triangles across planes or sides, and small ones, are left out.
std::vector<Hypothesis> hypotheses_of_dropped_triangles(const DiagnosisInput& input);
/// Another depth test, fill rule, culling or clipping.
std::vector<Hypothesis> hypotheses_of_drawing(const DiagnosisInput& input);
/// Coverage asks for more or less than the pixel's centre.
std::vector<Hypothesis> hypotheses_of_coverage(const DiagnosisInput& input);
/// Part of the frame is missing or comes from elsewhere.
std::vector<Hypothesis> hypotheses_of_parts(const DiagnosisInput& input);
/// Another window, camera or scene is drawn.
std::vector<Hypothesis> hypotheses_of_window(const DiagnosisInput& input);
/// Another window or pose of the camera, fitted to the depths.
std::vector<Hypothesis> hypotheses_of_fitted_cameras(const DiagnosisInput& input);
/// Less precision than was declared, the least loss first.
std::vector<Hypothesis> hypotheses_of_precision(const DiagnosisInput& input);

/// Nothing was drawn.
std::vector<Hypothesis> hypotheses_of_blank_frames(const DiagnosisInput& input);

/// All hypotheses, the more specific first: of two that explain the same, the first is named.
/// Where a frame shows no triangle, those alone that would leave it blank.
std::vector<Hypothesis> all_hypotheses(const DiagnosisInput& input);
/// Those of these names, from the first family that has them; none of fitted cameras, which take longer to
/// make than all others together.
std::vector<Hypothesis> hypotheses_named(std::span<const std::string> names, const DiagnosisInput& input);

}  // namespace zproof
