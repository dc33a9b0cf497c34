/// Making a map: every pixel from its place alone, so that threads cannot matter.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>

#include "filters/metrics/picture_metric.h"

namespace zproof {

/// value(x, y) at every pixel.
template <class Value>
auto mapped(Resolution size, Value value) {
    Plane<decltype(value(0, 0))> map(size);
    tbb::parallel_for(tbb::blocked_range<int>{0, size.height}, [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y)
            for (int x = 0; x < size.width; ++x) map.at(x, y) = value(x, y);
    });
    return map;
}

/// Throws std::invalid_argument.
inline void require_one_size(const LinearPicture& candidate, const LinearPicture& truth) {
    if (candidate.size() != truth.size())
        throw std::invalid_argument{"a metric of planes of different sizes"};
}

/// The sum runs in the order of the values, so the bits are always the same.
inline double mean_of(std::span<double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

inline double root_mean(std::span<double> squares) { return std::sqrt(mean_of(squares)); }

}  // namespace zproof
