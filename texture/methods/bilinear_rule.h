/// Methods that read a mip chain bilinearly and in no other way: many lookups at a time, by the kernels of
/// texture/reads.
#pragma once

#include <cassert>

#include "texture/methods/mip_reads.h"
#include "texture/reads/dispatch.h"
#include "texture/reads/tiles.h"

namespace zproof::texture {

/// A reader of a tap rule that keeps whole reads until there are enough of them.
class ReadCollector {
  public:
    ReadCollector(const reads::Kernel& kernel, const reads::Chain& chain) : kernel_{kernel}, chain_{chain} {}
    ReadCollector(const ReadCollector&) = delete;
    ReadCollector& operator=(const ReadCollector&) = delete;
    ~ReadCollector() { add_up(); }

    /// What is read from here on is added to this sum, which begins at 0.
    void begin(glm::dvec4& sum) {
        if (lookups_ == reads::Block::most) add_up();
        sum = glm::dvec4{0};
        open(&sum.x);
    }
    void bilinear(int level, const glm::dvec2& place, double weight) {
        if (count_ == reads::Block::most) {
            double* const unfinished = block_.sum[lookups_ - 1];
            add_up();
            open(unfinished);
        }
        block_.x[count_] = place.x;
        block_.y[count_] = place.y;
        block_.weight[count_] = weight;
        block_.level[count_] = level;
        ++count_;
    }

  private:
    void open(double* sum) {
        block_.sum[lookups_] = sum;
        block_.begin[lookups_] = int(count_);
        ++lookups_;
    }
    void add_up() {
        block_.begin[lookups_] = int(count_);
        block_.count = int(count_), block_.lookups = int(lookups_);
        kernel_.add_up(chain_, block_);
        count_ = lookups_ = 0;
    }

    const reads::Kernel& kernel_;
    const reads::Chain chain_;
    std::size_t count_ = 0, lookups_ = 0;  ///< of the block so far
    reads::Block block_;
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
