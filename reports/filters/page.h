/// The study as a page for people: filters.html, without network; scripts sort its tables and link its crops.
#pragma once

#include <string>
#include <vector>

#include "reports/filters/crops.h"
#include "reports/filters/plots.h"
#include "study/filters/statistics.h"

namespace zproof {

/// A picture in the page.
struct PageImage {
    std::string caption;
    std::string data;  ///< data URI
};

/// What a view shows beside its numbers.
struct ViewFigures {
    PageImage truth;  ///< the whole picture, small
    CropBox crop;
    std::vector<PageImage> crops;  ///< the truth's first, then one per method
    std::vector<Plot> plots;
};

/// All views together: none of it where there is one view.
struct StudyOverview {
    std::vector<Plot> plots;
    std::vector<study::PooledScores> pools;  ///< of several textures
};

/// `figures`: one per view.
std::string filters_page(const study::StudyResults& results, const std::vector<ViewFigures>& figures,
                         const StudyOverview& overview);

}  // namespace zproof
