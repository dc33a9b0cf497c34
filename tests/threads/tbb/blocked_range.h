// Stand-in for TBB; see run_threads.h.
#pragma once

#include <algorithm>
#include <cstddef>

namespace tbb {

template <typename Value>
class blocked_range {
  public:
    blocked_range(Value begin, Value end, std::size_t grainsize = 1)
        : begin_(begin), end_(end), grainsize_(grainsize) {}

    Value begin() const { return begin_; }
    Value end() const { return end_; }
    std::size_t size() const { return std::size_t(end_ - begin_); }
    bool empty() const { return !(begin_ < end_); }
    std::size_t grainsize() const { return grainsize_; }

  private:
    Value begin_, end_;
    std::size_t grainsize_;
};

namespace stand_in {

/// A range is cut into pieces of its grain size: no smaller ones are allowed, and larger ones would hide
/// races.
template <typename Value>
std::size_t chunk_count(const blocked_range<Value>& range) {
    return range.empty() ? 0 : (range.size() + range.grainsize() - 1) / range.grainsize();
}

template <typename Value>
blocked_range<Value> chunk_of(const blocked_range<Value>& range, std::size_t chunk) {
    const std::size_t first = chunk * range.grainsize();
    const std::size_t end = std::min(range.size(), first + range.grainsize());
    return {Value(range.begin() + Value(first)), Value(range.begin() + Value(end)), range.grainsize()};
}

}  // namespace stand_in

}  // namespace tbb
