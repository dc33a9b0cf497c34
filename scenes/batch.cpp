#include "scenes/batch.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace zproof {
void Batch::add(std::size_t count, Work work) {
    for (std::size_t from = 0; from < count; from += range_elements)
        ranges_.push_back({works_.size(), from, std::min(from + range_elements, count)});
    works_.push_back(std::move(work));
}

void Batch::run() {
    tbb::parallel_for(std::size_t{0}, ranges_.size(), [&](std::size_t i) {
        const WorkRange& range = ranges_[i];
        works_[range.work](range.from, range.to);
    });
    works_.clear();
    ranges_.clear();
}

}  // namespace zproof
