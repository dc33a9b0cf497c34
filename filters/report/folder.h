/// The folder of a study: what lies where.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "filters/report/crops.h"
#include "filters/study/results.h"
#include "frame/picture.h"
#include "reports/report_error.h"

namespace zproof {

/// What figures show; a reader may choose.
struct FigureChoice {
    std::vector<std::string> labels;  ///< methods named in colour; empty: filters_plots() chooses
    std::optional<CropBox> crop;      ///< of every view; none: where methods err most
};

inline constexpr int crop_side = 48, crop_magnification = 6;

/// Writes filters.json, filters.csv and table.tex; of several textures pooled.csv, too.
void write_filters_results(const std::filesystem::path& folder, const study::StudyResults& results);

/// Where the study's pictures lie, and where figures of them go; they may be one.
struct FigureFolders {
    std::filesystem::path study, figures;
};

/// Writes plots/*.svg, crops/VIEW/*.png and filters.html from the results and the pictures beside them.
/// Throws ReportError or FrameError where a file is missing or cannot be written.
void write_filters_figures(const FigureFolders& folders, const study::StudyResults& results,
                           const FigureChoice& choice);

/// Reads filters.json of a folder. Throws ReportError where there is none.
study::StudyResults read_filters_results(const std::filesystem::path& folder);

/// "trilinear-gl_bias_1" for "trilinear-gl:bias=1": a file name without its extension.
std::string file_stem(const std::string& label);

}  // namespace zproof
