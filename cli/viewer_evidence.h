/// What report.html's viewer shows of a view, gathered from scene, frames and verdict.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/oracle_answers.h"
#include "compare/explanation/explain.h"
#include "compare/judge.h"

namespace zproof {

/// A view whose frames are judged and whose oracles are compared.
struct JudgedView {
    const ViewContext& context;
    const RenderedFrame &candidate, &reference;
    Verdict& verdict;  ///< with all_evidence; its maps of errors are taken from it
    const std::vector<OracleAnswer>& answers;
};

/// Writes planes.zvp into the view's folder, with the stories of its most telling pixels; colours are read
/// from the pictures that lie there. Throws ReportError where it cannot be written.
void write_viewer_evidence(const std::filesystem::path& folder, const JudgedView& judged);

/// As write_viewer_evidence(), of what differs alone: no planes of ids, depths and errors, no stories.
void write_viewer_summary(const std::filesystem::path& folder, const JudgedView& judged);

/// The pixels whose stories are told: of every pair of triangles that some class arises between the worst
/// one, severest class first, then the worst of all, `most` in all; in raster order.
std::vector<PixelCoord> telling_pixels(const Verdict& verdict, std::size_t most);

}  // namespace zproof
