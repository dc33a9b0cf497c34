#include "filters/study/claims.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "filters/area/area_integral.h"

namespace zproof::study {

namespace {

double rmse_of(const StudyResults& results, const RegionScore& score) {
    return score.pixels == 0 ? std::numeric_limits<double>::quiet_NaN()
                             : score.values.at(metric_index(results, "rmse"));
}

}  // namespace

bool may_claim(const RegionScore& score, double difference) {
    return oracle::is_resolved(difference, score.truth_half_width);
}

bool is_resolved(const StudyResults& results, const RegionScore& score) {
    return score.pixels == 0 || may_claim(score, rmse_of(results, score));
}

std::vector<int> ranks(const StudyResults& results, const ViewStudy& view, std::string_view region) {
    std::vector<int> places(view.methods.size(), 0);
    if (places.empty()) return places;
    const RegionScore* const first = find_score(view.methods[0], region);
    if (first == nullptr || first->pixels == 0) return places;
    const auto rmse = [&](std::size_t i) {
        const double value = rmse_of(results, *find_score(view.methods[i], region));
        return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
    };
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, rmse);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_apart = i == 0 || (rmse(order[i]) != rmse(order[i - 1]) &&
                                         may_claim(*first, rmse(order[i]) - rmse(order[i - 1])));
        places[order[i]] = is_apart ? int(i) + 1 : places[order[i - 1]];
    }
    return places;
}

const RegionScore* find_score(const MethodScore& method, std::string_view region) {
    const auto found = std::ranges::find(method.regions, region, &RegionScore::region);
    return found == method.regions.end() ? nullptr : &*found;
}

std::size_t metric_index(const StudyResults& results, std::string_view metric) {
    return std::size_t(std::ranges::find(results.metrics, metric, &MetricCard::name) -
                       results.metrics.begin());
}

double value_of(const StudyResults& results, const MethodScore& method, std::string_view region,
                std::string_view metric) {
    const RegionScore* const score = find_score(method, region);
    const std::size_t index = metric_index(results, metric);
    if (score == nullptr || index >= score->values.size()) return std::numeric_limits<double>::quiet_NaN();
    return score->values[index];
}

}  // namespace zproof::study
