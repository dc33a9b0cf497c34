// Stand-in for TBB; see run_threads.h.
#pragma once

#include <concepts>

#include <tbb/blocked_range.h>
#include <tbb/run_threads.h>

namespace tbb {

struct simple_partitioner {};

template <typename Value, typename Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
    stand_in::for_each_chunk(stand_in::chunk_count(range),
                             [&](std::size_t chunk) { body(stand_in::chunk_of(range, chunk)); });
}

template <std::integral Index, typename Body>
void parallel_for(Index first, Index last, const Body& body, simple_partitioner = {}) {
    parallel_for(blocked_range<Index>(first, last),
                 [&](const blocked_range<Index>& one) { body(one.begin()); });
}

}  // namespace tbb
