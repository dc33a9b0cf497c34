// Stand-in for TBB; see run_threads.h.
#pragma once

#include <deque>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/run_threads.h>

namespace tbb {

template <typename Value, typename Sum, typename Body, typename Join>
Sum parallel_reduce(const blocked_range<Value>& range, const Sum& identity, const Body& body,
                    const Join& join) {
    std::deque<Sum> parts(stand_in::chunk_count(range), identity);
    stand_in::for_each_chunk(parts.size(), [&](std::size_t chunk) {
        parts[chunk] = body(stand_in::chunk_of(range, chunk), std::move(parts[chunk]));
    });
    Sum sum = identity;
    for (Sum& part : parts) sum = join(std::move(sum), std::move(part));
    return sum;
}

}  // namespace tbb
