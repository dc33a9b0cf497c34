/// Two runs side by side: what became better, what became worse.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reports/results.h"

namespace zproof {

/// A pixel whose class fails the gate in one of the runs.
struct DefectPixel {
    int x = 0, y = 0;
    PixelClass verdict = PixelClass::agree;
    auto operator<=>(const DefectPixel&) const = default;
};

/// The defects of one view, in raster order; nothing where no findings are at hand.
using DefectList = std::optional<std::vector<DefectPixel>>;

std::vector<DefectPixel> defects_among(const std::vector<Finding>& findings);  ///< in raster order

/// A view of one run or both.
struct ViewChange {
    std::string scene, view;
    const ViewResult* before = nullptr;  ///< nullptr: the view is new
    const ViewResult* after = nullptr;   ///< nullptr: the view is gone
    /// Defects of one run that are none in the other, where both runs' findings are at hand.
    std::optional<std::vector<DefectPixel>> appeared, gone;
};

/// What each run's defects are: called with the index of a run's view.
struct RunToCompare {
    const Results& results;
    std::vector<DefectList> defects;  ///< per view
};

/// The changes in the order of the older run, then what is new. Views are the same by scene and view name.
std::vector<ViewChange> changes_between(const RunToCompare& before, const RunToCompare& after);

/// Worse: a view that was proven and is not, that is gone, that is new and not proven, that has more defects
/// without a waiver, or a defect where there was none. A class that passes is never worse.
bool is_worse(const ViewChange& change);
bool is_any_different(const ViewChange& change);  ///< outcome, a count, or a pixel

std::string differences_table(const Results& before, const Results& after,
                              const std::vector<ViewChange>& changes);
std::string differences_json(const Results& before, const Results& after,
                             const std::vector<ViewChange>& changes);

}  // namespace zproof
