/// What report.html's viewer shows of a view, gathered from scene, frames and verdict.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/witness_hearing.h"
#include "compare/explanation/explain.h"
#include "compare/judge_in_full.h"

namespace zproof {

/// A view whose frames are judged and whose witnesses are heard.
struct JudgedView {
    const Docket& docket;
    const RenderedFrame &candidate, &reference;
    const Verdict& verdict;
    ErrorMaps errors;
    const std::vector<RuledPlace>& rulings;  ///< see JudgedInFull
    const std::vector<Statement>& statements;
};

/// Writes planes.zvp into the view's folder, with the stories of its most telling pixels; colours are read
/// from the pictures that lie there. Throws ReportError where it cannot be written.
void write_viewer_evidence(const std::filesystem::path& folder, JudgedView&& judged);

/// The pixels whose stories are told: of every pair of triangles that some class arises between the worst
/// one, severest class first, then the worst of all, `most` in all; in raster order.
std::vector<PixelPlace> telling_pixels(const Verdict& verdict, std::size_t most);

}  // namespace zproof
