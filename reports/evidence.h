/// What one view leaves behind on disk, so that a verdict can be checked without running zproof again.
#pragma once

#include <filesystem>
#include <iosfwd>

#include "compare/verdict.h"
#include "frame/frame.h"
#include "frame/picture.h"
#include "reports/report_error.h"

namespace zproof {

/// What every view leaves, into folder (made where absent): view.webp (reports/view_picture.h), and
/// findings.csv with every pixel that is not `agree`. Throws ReportError or FrameError where a file cannot be
/// written.
void write_view_summary(const std::filesystem::path& folder, const Plane<Rgb8>& picture,
                        const Verdict& verdict);

/// Writes beside them:
/// candidate.exr, reference.exr                      both frames, bit for bit
/// id.png, reference-id.png, depth.png, class.png    pictures, full size
/// *-small.png of the four                           the same for pages, see reports/pictures.h
/// on the threads of the surrounding tbb::task_arena. Throws ReportError or FrameError where a file cannot be
/// written.
void write_view_evidence(const std::filesystem::path& folder, const Frame& candidate, const Frame& reference,
                         const Verdict& verdict);

/// view-large.jpg beside them (reports/view_picture.h).
void write_large_picture(const std::filesystem::path& folder, const Plane<Rgb8>& picture);

/// ORACLE.exr beside them; the name is one that zproof knows, so a file can have it.
void write_oracle_frame(const std::filesystem::path& folder, const std::string& oracle, const Frame& frame);

/// The candidate's colours: colour.exr (linear), colour.png.
void write_colours(const std::filesystem::path& folder, const Picture& picture);

/// ORACLE-colour.exr and .png, and ORACLE-difference.png from the candidate's colours.
void write_oracle_picture(const std::filesystem::path& folder, const std::string& oracle,
                          const Picture& candidate, const Picture& picture);

/// The findings as CSV with a heading, in raster order. Numbers read back to the same bits; ids of background
/// are `none`; non-finite numbers are nan, inf, -inf.
void write_findings(std::ostream& out, const Verdict& verdict);

}  // namespace zproof
