#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/metrics/map.h"
#include "filters/metrics/metrics.h"

namespace zproof {

namespace {

double distance(double a, double b) {
    const double d = std::abs(a - b);
    return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
}

glm::dvec3 distances(const glm::dvec3& a, const glm::dvec3& b) {
    return {distance(a.r, b.r), distance(a.g, b.g), distance(a.b, b.b)};
}

/// of_distances of every pixel's absolute differences.
Plane<double> errors(const LinearPicture& candidate, const LinearPicture& truth,
                     double (*of_distances)(const glm::dvec3&)) {
    require_one_size(candidate, truth);
    return mapped(truth.size(),
                  [&](int x, int y) { return of_distances(distances(candidate.at(x, y), truth.at(x, y))); });
}

double mean_square(const glm::dvec3& d) { return (d.r * d.r + d.g * d.g + d.b * d.b) / 3; }
double mean(const glm::dvec3& d) { return (d.r + d.g + d.b) / 3; }
double largest(const glm::dvec3& d) { return std::max({d.r, d.g, d.b}); }

template <double (*of_distances)(const glm::dvec3&)>
Plane<double> error_map(const LinearPicture& candidate, const LinearPicture& truth) {
    return errors(candidate, truth, of_distances);
}

double decibels(std::span<double> squares) { return -10 * std::log10(mean_of(squares)); }

/// The least value that at least 99 % of all do not exceed (nearest rank).
double percentile_99(std::span<double> values) {
    const std::size_t rank = (99 * values.size() + 99) / 100;
    const auto place = values.begin() + std::ptrdiff_t(rank - 1);
    std::ranges::nth_element(values, place);
    return *place;
}

double maximum(std::span<double> values) { return *std::ranges::max_element(values); }

}  // namespace

PictureMetric rmse_metric() {
    return {.name = "rmse",
            .definition = "Root of the mean squared difference of the three channels.",
            .source = "",
            .map = error_map<mean_square>,
            .pool = root_mean};
}

PictureMetric psnr_metric() {
    return {.name = "psnr",
            .definition = "-20 log10 of the RMSE: decibels against a peak of 1.",
            .source = "",
            .better = Better::higher,
            .decimals = 2,
            .map = error_map<mean_square>,
            .pool = decibels};
}

PictureMetric mae_metric() {
    return {.name = "mae",
            .definition = "Mean absolute difference of the three channels.",
            .source = "",
            .map = error_map<mean>,
            .pool = mean_of};
}

PictureMetric p99_metric() {
    return {.name = "p99",
            .definition = "What the largest channel difference of 99 % of the pixels does not exceed.",
            .source = "",
            .map = error_map<largest>,
            .pool = percentile_99};
}

PictureMetric max_metric() {
    return {.name = "max",
            .definition = "The largest difference of any channel of any pixel.",
            .source = "",
            .map = error_map<largest>,
            .pool = maximum};
}

}  // namespace zproof
