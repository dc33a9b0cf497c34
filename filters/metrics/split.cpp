#include <algorithm>
#include <cmath>

#include "filters/metrics/map.h"
#include "filters/metrics/metrics.h"

namespace zproof {

namespace {

constexpr int window_side = 8;

/// What the mean squared difference of a window is made of. With r the truth, m the candidate and
/// beta = cov(m, r) / var(r):  mean (m - r)^2 = (mean m - mean r)^2 + (1 - beta)^2 var(r) + var(m - beta r),
/// since m - beta r and r do not correlate. Where the truth is constant beta is 1, and all that varies is
/// alias.
struct Split {
    double bias = 0, blur = 0, alias = 0;
};

struct Window {
    int left, top, right, bottom;  ///< pixels, half open
    double pixels() const { return double(right - left) * double(bottom - top); }
};

Window window_at(Resolution size, int x, int y) {
    const int left = x - x % window_side, top = y - y % window_side;
    return {left, top, std::min(left + window_side, size.width), std::min(top + window_side, size.height)};
}

/// Mean of value(x, y) over the window.
template <class Value>
double mean_over(const Window& window, Value value) {
    double sum = 0;
    for (int y = window.top; y < window.bottom; ++y)
        for (int x = window.left; x < window.right; ++x) sum += value(x, y);
    return sum / window.pixels();
}

Split split_of(const LinearPicture& candidate, const LinearPicture& truth, const Window& window,
               int channel) {
    const auto m = [&](int x, int y) { return candidate.at(x, y)[channel]; };
    const auto r = [&](int x, int y) { return truth.at(x, y)[channel]; };
    const double mean_m = mean_over(window, m), mean_r = mean_over(window, r);
    const double variance =
        mean_over(window, [&](int x, int y) { return (r(x, y) - mean_r) * (r(x, y) - mean_r); });
    const double covariance =
        mean_over(window, [&](int x, int y) { return (m(x, y) - mean_m) * (r(x, y) - mean_r); });
    const double beta = variance > 0 ? covariance / variance : 1;
    const double rest = mean_over(window, [&](int x, int y) {
        const double left_over = m(x, y) - mean_m - beta * (r(x, y) - mean_r);
        return left_over * left_over;
    });
    const double bias = mean_m - mean_r;
    return {bias * bias, (1 - beta) * (1 - beta) * variance, rest};
}

/// Every pixel of a window holds the window's share, averaged over the channels.
template <double Split::*share>
Plane<double> share_map(const LinearPicture& candidate, const LinearPicture& truth) {
    require_one_size(candidate, truth);
    const Resolution size = truth.size();
    const Resolution windows{(size.width + window_side - 1) / window_side,
                             (size.height + window_side - 1) / window_side};
    const Plane<double> shares = mapped(windows, [&](int column, int row) {
        const Window window = window_at(size, column * window_side, row * window_side);
        double sum = 0;
        for (int channel = 0; channel < 3; ++channel)
            sum += split_of(candidate, truth, window, channel).*share;
        return sum / 3;
    });
    return mapped(size, [&](int x, int y) { return shares.at(x / window_side, y / window_side); });
}

}  // namespace

PictureMetric bias_metric() {
    return {.name = "bias",
            .definition = "RMS over 8 x 8 windows of the difference of their means.",
            .source = "ours: rmse^2 = bias^2 + blur^2 + alias^2",
            .map = share_map<&Split::bias>,
            .pool = root_mean};
}

PictureMetric blur_metric() {
    return {.name = "blur",
            .definition = "RMS of the truth's detail in 8 x 8 windows that is too weak (or too strong).",
            .source = "ours: rmse^2 = bias^2 + blur^2 + alias^2",
            .map = share_map<&Split::blur>,
            .pool = root_mean};
}

PictureMetric alias_metric() {
    return {.name = "alias",
            .definition = "RMS of the detail in 8 x 8 windows that has nothing to do with the truth's.",
            .source = "ours: rmse^2 = bias^2 + blur^2 + alias^2",
            .map = share_map<&Split::alias>,
            .pool = root_mean};
}

}  // namespace zproof
