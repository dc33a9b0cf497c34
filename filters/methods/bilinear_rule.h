/// Methods that read a mip chain bilinearly and in no other way: many lookups at a time, by the kernels of
/// texture/reads.
#pragma once

#include <cassert>
#include <concepts>

#include "filters/methods/mip_reads.h"
#include "filters/methods/read_collector.h"
#include "filters/reads/kernel.h"
#include "filters/reads/tiles.h"
#include "math/processor.h"

namespace zproof::texture {

/// Equal trilinear taps on a line through the footprint's centre.
struct LineOfTaps {
    glm::dvec2 whole{0};  ///< texels, from one end to the other
    int taps = 1;
    double lod = 0;  ///< of each, in the chain
};

/// Tap rules that are such a line, with `static constexpr reads::Places places` on it and `LineOfTaps
/// line(const MipReads&, const Footprint&) const`.
template <class Reads>
concept reads_a_line = requires(const Reads& reads, const MipReads& mips, const Footprint& footprint) {
    { reads.line(mips, footprint) } -> std::same_as<LineOfTaps>;
};

/// Reads the line of taps, tap by tap.
template <reads_a_line Reads>
void read_line(const Reads& reads, const MipReads& mips, const Footprint& footprint, auto&& read) {
    const LineOfTaps line = reads.line(mips, footprint);
    for (int i = 0; i < line.taps; ++i) {
        const double along = (i + Reads::spacing.first) / (line.taps + Reads::spacing.more) - 0.5;
        mips.trilinear(line.lod, footprint.centre + along * line.whole, 1.0 / line.taps, read);
    }
}

/// A tap rule over a mip chain whose every read is bilinear, and its chain as the kernels know it.
template <class Reads>
class BilinearRule {
  public:
    BilinearRule(const LinearImage& image, const FilterOptions& options)
        : mips_{image, options}, tiles_{mips_.levels} {
        for (LinearImage& level : mips_.levels) level.texels = {};
    }

    void colours(const reads::Kernel& kernel, std::span<const Footprint> seen,
                 std::span<glm::dvec4> colours) const {
        assert(seen.size() == colours.size());
        if constexpr (reads_a_line<Reads>) {
            constexpr std::size_t most = reads::Lines::most;
            for (std::size_t i = 0; i < seen.size(); i += most) {
                const std::size_t count = std::min(most, seen.size() - i);
                add_lines(kernel, seen.subspan(i, count), colours.subspan(i, count));
            }
        } else {
            ReadCollector reader{kernel, tiles_.chain(mips_.options.addressing)};
            for (std::size_t i = 0; i < seen.size(); ++i) {
                reader.begin(colours[i]);
                Reads{}(mips_, seen[i], reader);
            }
        }
    }
    std::vector<Tap> taps(const Footprint& footprint) const {
        std::vector<Tap> taps;
        const auto read = [&](const Tap& tap) { taps.push_back(tap); };
        if constexpr (reads_a_line<Reads>)
            read_line(Reads{}, mips_, footprint, read);
        else
            Reads{}(mips_, footprint, read);
        return taps;
    }

  private:
    void add_lines(const reads::Kernel& kernel, std::span<const Footprint> seen,
                   std::span<glm::dvec4> colours) const {
        reads::Lines lines;
        lines.spacing = Reads::spacing;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const LineOfTaps line = Reads{}.line(mips_, seen[i]);
            const int finer = int(line.lod);  // rounded down: it is not negative
            lines.x[i] = seen[i].centre.x, lines.y[i] = seen[i].centre.y;
            lines.across[i] = line.whole.x, lines.down[i] = line.whole.y;
            lines.taps[i] = line.taps, lines.share[i] = line.lod - finer;
            lines.finer[i] = finer, lines.coarser[i] = std::min(finer + 1, mips_.coarsest());
            colours[i] = glm::dvec4{0};
            lines.sum[i] = &colours[i].x;
        }
        lines.count = int(seen.size());
        kernel.add_lines(tiles_.chain(mips_.options.addressing), lines);
    }

    MipReads mips_;  ///< sizes alone: the texels are in tiles
    reads::TiledImages tiles_;
};

template <class Reads>
Sampler prepare_bilinear(const LinearImage& image, const FilterOptions& options) {
    const auto rule = std::make_shared<const BilinearRule<Reads>>(image, options);
    const auto colours = [rule](std::span<const Footprint> seen, std::span<glm::dvec4> sums) {
        rule->colours(widest_of(reads::kernels), seen, sums);
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
