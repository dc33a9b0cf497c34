/// Work that is gathered first and done side by side.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace zproof {

/// Many arrays of any length as one piece of work: a part of a hundred triangles costs no waiting for other
/// threads, and a part of a million is shared out.
class Batch {
  public:
    using Work = std::function<void(std::size_t from, std::size_t to)>;

    /// Longest range: some ten thousand instructions at least, and still in the cache when it is read again.
    static constexpr std::size_t range_elements = 1024;

    /// Has work(from, to) called for ranges that make up [0, count) before run() returns, in any order and by
    /// any thread. Work must not throw.
    void add(std::size_t count, Work work);

    /// Does all that was added, and forgets it.
    void run();

  private:
    struct WorkRange {
        std::size_t work, from, to;
    };
    std::vector<Work> works_;
    std::vector<WorkRange> ranges_;
};

}  // namespace zproof
