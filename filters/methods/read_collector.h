/// What hands the reads of a tap rule to the kernels of texture/reads.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <utility>

#include "filters/reads/kernel.h"

namespace zproof::texture {

/// A reader of a tap rule that keeps whole reads until a block is full of them. Of the block before, the
/// taps are known: its texels are asked of memory while this one is filled, and then they are summed.
class ReadCollector {
  public:
    ReadCollector(const reads::Kernel& kernel, const reads::Chain& chain) : kernel_{kernel}, chain_{chain} {}
    ReadCollector(const ReadCollector&) = delete;
    ReadCollector& operator=(const ReadCollector&) = delete;
    ~ReadCollector() {
        turn_over();
        kernel_.add_up(chain_, *found_);
    }

    /// What is read from here on is added to this sum, which begins at 0.
    void begin(glm::dvec4& sum) {
        if (lookups_ == reads::Block::most) turn_over();
        sum = glm::dvec4{0};
        open(&sum.x);
    }
    void bilinear(int level, const glm::dvec2& place, double weight) {
        if (count_ == reads::Block::most) {
            double* const unfinished = filled_->sum[lookups_ - 1];
            turn_over();
            open(unfinished);
        }
        filled_->x[count_] = place.x;
        filled_->y[count_] = place.y;
        filled_->weight[count_] = weight;
        filled_->level[count_] = level;
        fetch(count_);
        ++count_;
    }

  private:
    void open(double* sum) {
        filled_->sum[lookups_] = sum;
        filled_->begin[lookups_] = int(count_);
        ++lookups_;
    }
    void fetch(std::size_t i) const {
        if (i >= found_count_) return;
        for (const auto& offset : found_->offset) __builtin_prefetch(chain_.texels + offset[i]);
    }
    /// The full block's taps are found, and the one before is summed and empty.
    void turn_over() {
        filled_->begin[lookups_] = int(count_);
        filled_->count = int(count_), filled_->lookups = int(lookups_);
        kernel_.find_taps(chain_, *filled_);
        kernel_.add_up(chain_, *found_);
        std::swap(filled_, found_);
        found_count_ = count_;
        count_ = lookups_ = 0;
    }

    const reads::Kernel& kernel_;
    const reads::Chain chain_;
    reads::Block blocks_[2];
    reads::Block *filled_ = &blocks_[0], *found_ = &blocks_[1];
    std::size_t count_ = 0, lookups_ = 0;  ///< of the block being filled
    std::size_t found_count_ = 0;          ///< reads of the other
};

}  // namespace zproof::texture
