/// The charts of a study.
#pragma once

#include <string>
#include <vector>

#include "filters/study/results.h"

namespace zproof {

struct Plot {
    std::string name;     ///< of its file, without .svg
    std::string caption;  ///< one sentence
    std::string svg;
};

/// Cost against error, error by anisotropy, error by angle; of all views together, RMSE pooled over their
/// pixels and costs averaged. `labels`: the methods that are named in colour; empty: those that no other
/// beats in both cost and error, and where those are fewer than four, all.
std::vector<Plot> filters_plots(const study::StudyResults& results, const std::vector<std::string>& labels);

/// The plots of one view.
std::vector<Plot> filters_plots(const study::StudyResults& results, const study::ViewStudy& view,
                                const std::vector<std::string>& labels);

}  // namespace zproof
