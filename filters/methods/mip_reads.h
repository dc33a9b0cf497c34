/// What the methods with a mip chain share: the chain, and reads of one level and of two.
#pragma once

#include <algorithm>

#include "filters/methods/lod.h"
#include "filters/methods/tap_rule.h"
#include "filters/stored/mip_chain.h"

namespace zproof::texture {

/// A reader that is told of a bilinear read as a whole, in texels of its level, instead of its four taps.
template <class Read>
concept takes_whole_reads = requires(Read& read, const glm::dvec2& place) {
    read.bilinear(0, place, 1.0);
};

/// A tap rule's store: `image` of a tap is a level.
struct MipReads {
    std::vector<LinearImage> levels;
    FilterOptions options;

    std::vector<glm::dvec2> scales;  ///< texels of each level per texel of level 0, along either axis

    MipReads(const LinearImage& image, const FilterOptions& settings)
        : levels{mip_chain(image, settings)}, options{settings} {
        for (const LinearImage& level : levels)
            scales.emplace_back(double(level.width) / image.width, double(level.height) / image.height);
    }

    int coarsest() const { return int(levels.size()) - 1; }

    const glm::dvec2& scale(int level) const { return scales[std::size_t(level)]; }

    /// The LOD biased, clamped, and within the chain.
    double in_chain(double lod) const { return lod_in_chain(lod, options, levels.size()); }

    /// One level; the place is in texels of level 0.
    template <class Read>
    void bilinear(int level, const glm::dvec2& place, double weight, Read&& read) const {
        bilinear_in(level, place * scale(level), weight, read);
    }
    /// The place is in texels of that level.
    template <class Read>
    void bilinear_in(int level, const glm::dvec2& place, double weight, Read&& read) const {
        if constexpr (takes_whole_reads<Read>)
            return read.bilinear(level, place, weight);
        else
            read_bilinear(levels[std::size_t(level)], options.addressing, place,
                          Tap{.image = level, .weight = weight}, read);
    }
    template <class Read>
    void nearest(int level, const glm::dvec2& place, double weight, Read&& read) const {
        read_nearest(levels[std::size_t(level)], options.addressing, place * scale(level),
                     Tap{.image = level, .weight = weight}, read);
    }

    /// Bilinear in the levels on either side of an LOD of the chain, weighted by its fraction (OpenGL 4.6
    /// core, 8.14.3). A level of weight 0 is not read.
    template <class Read>
    void trilinear(double lod, const glm::dvec2& place, double weight, Read&& read) const {
        const int finer = int(lod);  // rounded down: it is not negative
        const double share = lod - finer;
        bilinear(finer, place, weight * (1 - share), read);
        if (share > 0) bilinear(finer + 1, place, weight * share, read);
    }
};

/// A tap rule over a mip chain. Reads: `void operator()(const MipReads&, const Footprint&, auto&& read)
/// const`.
template <class Reads>
struct MipRule {
    MipReads mips;

    void operator()(const Footprint& footprint, auto&& read) const { Reads{}(mips, footprint, read); }
    glm::dvec4 value(const Tap& tap) const {
        return glm::dvec4{mips.levels[std::size_t(tap.image)].at(tap.column, tap.row)};
    }
};

template <class Reads>
Sampler prepare_mipped(const LinearImage& image, const FilterOptions& options) {
    return sampler(MipRule<Reads>{MipReads{image, options}},
                   stored_mip_chain(image, options.mip_kernel, options.addressing));
}

}  // namespace zproof::texture
