/// Methods that read a mip chain bilinearly and in no other way: many lookups at a time, by the kernels of
/// texture/reads.
#pragma once

#include <cassert>

#include "texture/methods/mip_reads.h"
#include "texture/reads/dispatch.h"
#include "texture/reads/tiles.h"

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
        const float* const texels = chain_.levels[found_->level[i]].texels;
        for (const auto& offset : found_->offset) __builtin_prefetch(texels + offset[i]);
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

/// A tap rule over a mip chain whose every read is bilinear, and its chain as the kernels know it.
template <class Reads>
class BilinearRule {
  public:
    BilinearRule(const LinearImage& image, const FilterOptions& options) : mips_{image, options} {
        for (LinearImage& level : mips_.levels) {
            tiles_.push_back(reads::tiles_of(level));
            level.texels = {};
            levels_.push_back({tiles_.back()[0].texels, double(level.width), double(level.height)});
        }
    }

    void colours(const reads::Kernel& kernel, std::span<const Footprint> seen,
                 std::span<glm::dvec4> colours) const {
        assert(seen.size() == colours.size());
        const Addressing& wrap = mips_.options.addressing;
        ReadCollector reader{kernel, {levels_.data(), wrap.u, wrap.v}};
        for (std::size_t i = 0; i < seen.size(); ++i) {
            reader.begin(colours[i]);
            Reads{}(mips_, seen[i], reader);
        }
    }
    std::vector<Tap> taps(const Footprint& footprint) const {
        std::vector<Tap> taps;
        Reads{}(mips_, footprint, [&](const Tap& tap) { taps.push_back(tap); });
        return taps;
    }

  private:
    MipReads mips_;  ///< sizes alone: the texels are in tiles
    std::vector<std::vector<reads::Tile>> tiles_;
    std::vector<reads::Level> levels_;
};

template <class Reads>
Sampler prepare_bilinear(const LinearImage& image, const FilterOptions& options) {
    const auto rule = std::make_shared<const BilinearRule<Reads>>(image, options);
    const auto colours = [rule](std::span<const Footprint> seen, std::span<glm::dvec4> sums) {
        rule->colours(reads::widest_kernel(), seen, sums);
    };
    return {.colour =
                [colours](const Footprint& footprint) {
                    glm::dvec4 colour{0};
                    colours({&footprint, 1}, {&colour, 1});
                    return colour;
                },
            .colours = colours,
            .taps = [rule](const Footprint& footprint) { return rule->taps(footprint); },
            .stored = stored_mip_chain(image, options.mip_kernel, options.addressing)};
}

}  // namespace zproof::texture
