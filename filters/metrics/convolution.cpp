#include "filters/metrics/convolution.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace zproof {

namespace {

template <class Work>
void for_each_row(Resolution size, Work work) {
    tbb::parallel_for(tbb::blocked_range<int>{0, size.height}, [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) work(y);
    });
}

/// sum[x] += tap * values[x]: the loop that a compiler makes wide.
void add(std::span<double> sum, const double* values, double tap) {
    for (std::size_t x = 0; x < sum.size(); ++x) sum[x] += tap * values[x];
}

/// The row with `radius` copies of its ends before and behind it.
std::vector<double> continued(std::span<const double> row, std::size_t radius) {
    std::vector<double> longer(row.size() + 2 * radius, row.back());
    std::fill_n(longer.begin(), radius, row.front());
    std::ranges::copy(row, longer.begin() + std::ptrdiff_t(radius));
    return longer;
}

}  // namespace

Plane<double> convolved(const Plane<double>& values, const std::vector<double>& across,
                        const std::vector<double>& along) {
    const Resolution size = values.size();
    Plane<double> rows(size), both(size);
    for_each_row(size, [&](int y) {
        const std::vector<double> longer = continued(values.row(y), across.size() / 2);
        for (std::size_t i = 0; i < across.size(); ++i) add(rows.row(y), &longer[i], across[i]);
    });
    const int radius = int(along.size()) / 2;
    for_each_row(size, [&](int y) {
        for (int i = 0; i < int(along.size()); ++i)
            add(both.row(y), rows.row(std::clamp(y + i - radius, 0, size.height - 1)).data(),
                along[std::size_t(i)]);
    });
    return both;
}

std::vector<double> normalised(std::vector<double> taps) {
    const double sum = std::accumulate(taps.begin(), taps.end(), 0.0);
    for (double& tap : taps) tap /= sum;
    return taps;
}

}  // namespace zproof
