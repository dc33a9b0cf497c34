/// What may be said of results, given how well the truth is known.
#pragma once

#include <string_view>
#include <vector>

#include "filters/study/results.h"

namespace zproof::study {

/// Is the truth of the region known to a fifth of this difference of light?
bool may_claim(const RegionScore& score, double difference);

/// Is the method's own distance from the truth, its RMSE in the region, known so well?
bool is_resolved(const StudyResults& results, const RegionScore& score);

/// Places by RMSE in a region, by ViewStudy::methods; 1 is the best. Methods share a place where what lies
/// between one and the next cannot be claimed; 0 where the region is empty.
std::vector<int> ranks(const StudyResults& results, const ViewStudy& view, std::string_view region);

/// The score of a region; null where the study has none of that name.
const RegionScore* find_score(const MethodScore& method, std::string_view region);

/// Index into RegionScore::values; metrics.size() where there is none of that name.
std::size_t metric_index(const StudyResults& results, std::string_view metric);

/// The value of a metric in a region; NaN where there is none.
double value_of(const StudyResults& results, const MethodScore& method, std::string_view region,
                std::string_view metric);

}  // namespace zproof::study
