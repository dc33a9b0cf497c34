/// The texels of a lookup that is bound to a number of them (Manson and Schaefer 2013,
/// Cardinality-Constrained Texture Filtering), by place and LOD. docs/texture-filters.md, "Tables of texels",
/// defines ours.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace zproof::texture {

/// A texel of one of three levels and its weight. Its column and row are counted from the texel of its level
/// that holds the lookup's place.
struct TableTap {
    int level = 0;  ///< above the finest of the three
    int column = 0, row = 0;
    double weight = 0;
};

class CardinalityTable {
  public:
    static constexpr int levels = 3;
    /// Places a texel of the finest level, along either axis, and LODs a level.
    static constexpr int steps = 8;
    /// Places along a texel of the coarsest level, after which the three levels' texels repeat.
    static constexpr int places = steps << (levels - 1);
    static constexpr int lods = (levels - 1) * steps;

    /// At most so many texels an entry.
    explicit CardinalityTable(int texels);

    /// Place and LOD above the finest level, from 0 to `places` and to `lods` exclusive.
    std::span<const TableTap> at(int u, int v, int lod) const {
        const std::size_t entry = (std::size_t(lod) * places + std::size_t(v)) * places + std::size_t(u);
        return std::span{taps_}.subspan(begin_[entry], begin_[entry + 1] - begin_[entry]);
    }

  private:
    std::vector<std::size_t> begin_{0};
    std::vector<TableTap> taps_;
};

}  // namespace zproof::texture
