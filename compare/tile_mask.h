/// Pixels of a tile.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "compare/tile_row.h"
#include "compare/tiles.h"

namespace zproof {

/// A tile's first pixel in the image.
struct TilePlace {
    int left = 0, top = 0;

    RowPlace row(int y) const { return {left, top + y}; }
};

/// A bit for each pixel of a tile; rows are counted from its top.
class TileMask {
  public:
    static constexpr int rows = Tiles::side_px;

    constexpr TileMask() = default;
    static constexpr TileMask all() { return ~TileMask{}; }

    static constexpr TileMask of(std::span<const std::uint16_t, rows> columns_of_row) {
        TileMask mask;
        for (int y = 0; y < rows; ++y) mask.add(y, columns_of_row[std::size_t(y)]);
        return mask;
    }

    constexpr ColumnMask row(int y) const {
        return ColumnMask(words_[word_of(y)] >> shift_of(y)) & all_columns;
    }
    constexpr void add(int y, ColumnMask columns) {
        words_[word_of(y)] |= std::uint64_t{columns} << shift_of(y);
    }
    /// Bit y: row y has some.
    constexpr unsigned rows_with_some() const {
        unsigned found = 0;
        for (int y = 0; y < rows; ++y) found |= unsigned(row(y) != 0) << y;
        return found;
    }
    constexpr bool is_none() const { return (words_[0] | words_[1] | words_[2] | words_[3]) == 0; }
    constexpr int count() const {
        int sum = 0;
        for (const std::uint64_t word : words_) sum += std::popcount(word);
        return sum;
    }

    constexpr TileMask& operator&=(const TileMask& other) {
        for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
        return *this;
    }
    constexpr TileMask& operator|=(const TileMask& other) {
        for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
        return *this;
    }
    friend constexpr TileMask operator&(TileMask a, const TileMask& b) { return a &= b; }
    friend constexpr TileMask operator|(TileMask a, const TileMask& b) { return a |= b; }
    friend constexpr TileMask operator~(const TileMask& a) {
        TileMask others;
        for (std::size_t i = 0; i < a.words_.size(); ++i) others.words_[i] = ~a.words_[i];
        return others;
    }
    friend constexpr bool operator==(const TileMask&, const TileMask&) = default;

  private:
    static constexpr int rows_in_word = 64 / int(tile_columns);
    static constexpr std::size_t word_of(int y) { return std::size_t(y / rows_in_word); }
    static constexpr int shift_of(int y) { return y % rows_in_word * int(tile_columns); }

    std::array<std::uint64_t, rows / rows_in_word> words_{};
};

/// Calls visit(y, columns) for each row that has any of the pixels.
template <class Visit>
void for_each_row(const TileMask& pixels, const Visit& visit) {
    for (int y = 0; y < TileMask::rows; ++y)
        if (const ColumnMask columns = pixels.row(y); columns != 0) visit(y, columns);
}

}  // namespace zproof
