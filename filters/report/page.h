/// The study as a page for people: filters.html, without network. Scripts sort its tables and link its crops,
/// and the viewer opens over it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "filters/report/crops.h"
#include "filters/report/plots.h"
#include "filters/study/statistics.h"
#include "reports/planes/embedded.h"

namespace zproof {

/// The folder of a view's pictures, relative to the study's: "pictures/worked-phi-0".
std::filesystem::path view_folder(const study::ViewStudy& view);

/// A picture in the page.
struct PageImage {
    std::string caption;
    std::string data;     ///< data URI
    std::string error{};  ///< the same of its error; empty: none
};

/// What a view shows beside its numbers.
struct ViewFigures {
    PageImage truth;  ///< the whole picture, small
    CropBox crop;
    std::vector<PageImage> crops;  ///< the truth's first, then one per method
    std::vector<Plot> plots;
};

/// What the page shows of a study beside its numbers.
struct StudyFigures {
    std::vector<ViewFigures> views;            ///< one per view
    std::vector<Plot> overview;                ///< of all views together; none where there is one view
    std::vector<study::PooledScores> pools{};  ///< of several textures
};

/// Bytes of a study's page.
inline constexpr std::size_t study_page_budget = 3'000'000;

/// The page, and the scripts beside it.
struct StudyPage {
    Page page;
    std::vector<planes::ScriptFile> scripts;
};

/// `folder`: the study's. The viewer opens on each view's planes.zvp there: the page holds what its budget
/// has room for, scripts beside it the rest. A page without planes still has all else. Throws ReportError
/// where a planes.zvp is damaged.
StudyPage filters_page(const study::StudyResults& results, const StudyFigures& figures,
                       const std::filesystem::path& folder, std::size_t budget = study_page_budget);

}  // namespace zproof
