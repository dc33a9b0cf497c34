#include "filters/study/statistics.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

#include "filters/study/claims.h"

namespace zproof::study {

namespace {

/// values[texture][method]
using Table = std::vector<std::vector<double>>;

struct ViewsOfTextures {
    std::vector<std::vector<const ViewStudy*>> by_texture;
    std::size_t views = 0;
};

bool has_the_region(const ViewStudy& view, const std::string& region) {
    return std::ranges::any_of(view.methods, [&](const MethodScore& method) {
        const RegionScore* const score = find_score(method, region);
        return score != nullptr && score->pixels > 0;
    });
}

/// The views that have pixels in the region, texture by texture in the study's order.
ViewsOfTextures views_of_textures(const StudyResults& results, const std::string& region) {
    ViewsOfTextures found;
    std::map<std::string, std::size_t> place;
    for (const ViewStudy& view : results.views) {
        if (!has_the_region(view, region)) continue;
        const auto [at, is_new] = place.try_emplace(view.scene, found.by_texture.size());
        if (is_new) found.by_texture.emplace_back();
        found.by_texture[at->second].push_back(&view);
        ++found.views;
    }
    return found;
}

double value_in(const StudyResults& results, const ViewStudy& view, const std::string& label,
                const PoolChoice& choice) {
    const auto method = std::ranges::find(view.methods, label, &MethodScore::label);
    return method == view.methods.end() ? std::nan("")
                                        : value_of(results, *method, choice.region, choice.metric);
}

double mean_over(const StudyResults& results, const std::vector<const ViewStudy*>& views,
                 const std::string& label, const PoolChoice& choice) {
    double sum = 0;
    for (const ViewStudy* view : views) sum += value_in(results, *view, label, choice);
    return sum / double(views.size());
}

/// The mean of every method over the textures drawn.
std::vector<double> means(const Table& table, const std::vector<std::size_t>& drawn) {
    std::vector<double> sums(table.front().size(), 0);
    for (const std::size_t texture : drawn)
        for (std::size_t m = 0; m < sums.size(); ++m) sums[m] += table[texture][m];
    for (double& sum : sums) sum /= double(drawn.size());
    return sums;
}

/// Methods of one value share the better rank.
std::vector<int> ranks_of(const std::vector<double>& values, bool higher_is_better) {
    std::vector<int> ranks;
    for (const double own : values)
        ranks.push_back(1 + int(std::ranges::count_if(values, [&](double other) {
                            return higher_is_better ? other > own : other < own;
                        })));
    return ranks;
}

/// The 2.5th and the 97.5th percentile.
Spread spread_of(std::vector<double> values) {
    std::ranges::sort(values);
    const auto at = [&](double share) {
        return values[std::size_t(std::lround(share * double(values.size() - 1)))];
    };
    return {at(0.025), at(0.975)};
}

std::vector<std::size_t> drawn(std::mt19937& engine, std::size_t count) {
    std::vector<std::size_t> textures(count);
    for (std::size_t& texture : textures)
        texture = std::size_t((std::uint64_t{static_cast<std::uint32_t>(engine())} * count) >> 32);
    return textures;
}

/// What each method has more than the baseline, texture by texture.
Table paired(const Table& table, std::size_t baseline) {
    Table differences = table;
    for (std::vector<double>& row : differences) {
        const double base = row[baseline];
        for (double& value : row) value -= base;
    }
    return differences;
}

/// The ranks of every method in every sample.
std::vector<std::vector<double>> sampled_ranks(const Table& table, const PoolChoice& choice,
                                               bool higher_is_better) {
    std::vector<std::vector<double>> samples(table.front().size());
    std::mt19937 engine{choice.seed};
    for (int i = 0; i < choice.samples; ++i) {
        const std::vector<int> ranks = ranks_of(means(table, drawn(engine, table.size())), higher_is_better);
        for (std::size_t m = 0; m < ranks.size(); ++m) samples[m].push_back(ranks[m]);
    }
    return samples;
}

std::vector<double> column_of(const Table& table, std::size_t method) {
    std::vector<double> column;
    for (const std::vector<double>& row : table) column.push_back(row[method]);
    return column;
}

std::size_t place_of(const std::vector<std::string>& labels, const std::string& label) {
    const auto found = std::ranges::find(labels, label);
    if (found == labels.end()) throw std::invalid_argument("'" + label + "' is no method of the pool");
    return std::size_t(found - labels.begin());
}

}  // namespace

std::size_t texture_count(const StudyResults& results) {
    std::set<std::string> names;
    for (const ViewStudy& view : results.views) names.insert(view.scene);
    return names.size();
}

Spread interval_of_mean(std::span<const double> values) {
    const double count = double(values.size());
    if (values.size() < 2) return {std::nan(""), std::nan("")};
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double squares = 0, cubes = 0;
    for (const double value : values) {
        const double off = value - mean;
        squares += off * off / count, cubes += off * off * off / count;
    }
    if (squares == 0) return {mean, mean};
    const double error = std::sqrt(squares / (count - 1)), root = std::sqrt(count);
    const double third = cubes / std::pow(squares, 1.5) / 3;  // of the skewness
    // Hall's transformation g(T) = T + third T^2 + third^2 T^3 / 3 + third / 2n, in units of sqrt(n),
    // inverted.
    const auto skewed = [&](double t) {
        if (std::abs(third) < 1e-6) return t;
        return root / third * (std::cbrt(1 + 3 * third * (t / root - third / (2 * count))) - 1);
    };
    const double t = boost::math::quantile(boost::math::students_t{count - 1}, 0.975);
    return {mean - error * skewed(t), mean - error * skewed(-t)};
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_higher_better(const StudyResults& results, const PoolChoice& choice) {
    return results.metrics.at(metric_index(results, choice.metric)).higher_is_better;
}

/// Whole columns of values, one for each method that has them all.
struct Values {
    std::vector<std::string> labels;
    Table table;
};

/// What is infinitely wrong has pixels that are no numbers.
Values values_of(const StudyResults& results, const ViewsOfTextures& views, const PoolChoice& choice,
                 std::vector<std::string>& left_out) {
    const double worst = is_higher_better(results, choice) ? -infinity : infinity;
    Values values{{}, Table(views.by_texture.size())};
    for (const MethodCard& card : results.methods) {
        std::vector<double> column;
        for (const auto& of_texture : views.by_texture)
            column.push_back(mean_over(results, of_texture, card.label, choice));
        const bool is_whole =
            std::ranges::none_of(column, [&](double v) { return std::isnan(v) || v == worst; });
        (is_whole ? values.labels : left_out).push_back(card.label);
        for (std::size_t t = 0; is_whole && t < column.size(); ++t) values.table[t].push_back(column[t]);
    }
    return values;
}

/// No mean is taken over infinities.
void drop_infinite(Table& table, ViewsOfTextures& views, std::vector<std::string>& left_out) {
    for (std::size_t t = table.size(); t-- > 0;) {
        if (std::ranges::all_of(table[t], [](double v) { return std::isfinite(v); })) continue;
        left_out.insert(left_out.begin(), views.by_texture[t].front()->scene);
        views.views -= views.by_texture[t].size();
        views.by_texture.erase(views.by_texture.begin() + std::ptrdiff_t(t));
        table.erase(table.begin() + std::ptrdiff_t(t));
    }
}

}  // namespace

PooledScores pooled(const StudyResults& results, const PoolChoice& choice) {
    ViewsOfTextures views = views_of_textures(results, choice.region);
    PooledScores pool{.choice = choice, .methods = {}, .left_out = {}, .textures_left_out = {}};
    auto [labels, table] = values_of(results, views, choice, pool.left_out);
    drop_infinite(table, views, pool.textures_left_out);
    pool.textures = views.by_texture.size();
    pool.views = views.views;
    if (table.empty() || labels.empty()) return pool;
    const bool higher_is_better = is_higher_better(results, choice);
    std::vector<std::size_t> all(table.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const std::vector<double> mean = means(table, all);
    const std::vector<int> rank = ranks_of(mean, higher_is_better);
    if (choice.baseline.empty())
        pool.choice.baseline = labels[std::size_t(std::ranges::min_element(rank) - rank.begin())];
    const std::size_t baseline = place_of(labels, pool.choice.baseline);
    const Table differences = paired(table, baseline);
    const std::vector<double> difference = means(differences, all);
    const std::vector<std::vector<double>> ranks = sampled_ranks(table, choice, higher_is_better);
    for (std::size_t m = 0; m < labels.size(); ++m)
        pool.methods.push_back({.label = labels[m],
                                .mean = mean[m],
                                .mean_spread = interval_of_mean(column_of(table, m)),
                                .rank = rank[m],
                                .rank_spread = spread_of(ranks[m]),
                                .first_share = double(std::ranges::count(ranks[m], 1)) / choice.samples,
                                .difference = difference[m],
                                .difference_spread = interval_of_mean(column_of(differences, m))});
    std::ranges::stable_sort(pool.methods, {}, &PooledMethod::rank);
    return pool;
}

}  // namespace zproof::study
