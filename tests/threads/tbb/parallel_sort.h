// Stand-in for TBB; see run_threads.h.
#pragma once

#include <algorithm>
#include <iterator>

#include <tbb/run_threads.h>

namespace tbb {

/// Both halves are sorted side by side.
template <typename Container, typename Less>
void parallel_sort(Container& container, const Less& less) {
    const auto first = std::begin(container), last = std::end(container);
    const auto middle = first + (last - first) / 2;
    stand_in::for_each_chunk(2, [&](std::size_t half) {
        half == 0 ? std::sort(first, middle, less) : std::sort(middle, last, less);
    });
    std::inplace_merge(first, middle, last, less);
}

}  // namespace tbb
