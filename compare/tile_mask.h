/// Pixels of a tile.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "compare/tile_row.h"
#include "compare/tiles.h"

namespace zproof {

static_assert(std::endian::native == std::endian::little, "four rows are looked at as one word");

/// A tile's first pixel in the image.
struct TilePlace {
    int left = 0, top = 0;

    RowPlace row(int y) const { return {left, top + y}; }
};

/// A bit for each pixel of a tile; rows are counted from its top. In vectors throughout: what is written by
/// halves and read whole waits for its own stores.
class TileMask {
  public:
    static constexpr int rows = Tiles::side_px;

    TileMask() = default;
    static TileMask all() { return ~TileMask{}; }

    static TileMask of(std::span<const std::uint16_t, rows> columns_of_row) {
        TileMask mask;
        std::memcpy(mask.halves_.data(), columns_of_row.data(), columns_of_row.size_bytes());
        return mask;
    }

    ColumnMask row(int y) const { return halves_[half_of(y)][y % rows_of_half]; }
    void add(int y, ColumnMask columns) {
        halves_[half_of(y)][y % rows_of_half] = std::uint16_t(row(y) | columns);
    }
    /// Row by row: bit i is column i.
    std::array<std::uint16_t, rows> columns_of_row() const {
        return std::bit_cast<std::array<std::uint16_t, rows>>(halves_);
    }
    /// Bit y: row y has some.
    unsigned rows_with_some() const {
        constexpr std::uint64_t all_but_first = 0x7fff'7fff'7fff'7fff, gather = 0x0001'0002'0004'0008;
        unsigned found = 0;
        for (std::size_t i = 0; i < halves_.size() * 2; ++i) {
            const std::uint64_t word = std::bit_cast<Bits>(halves_)[i];  // four rows
            const std::uint64_t some = (((word & all_but_first) + all_but_first) | word) & ~all_but_first;
            found |= unsigned((some >> 15) * gather >> 48 & 0xf) << 4 * i;
        }
        return found;
    }
    /// Columns that some row has.
    ColumnMask columns_with_some() const {
        const auto words = std::bit_cast<Words>(halves_[0] | halves_[1]);
        const std::uint64_t four = words[0] | words[1], two = four | four >> 32;
        return ColumnMask(two | two >> 16) & all_columns;
    }
    bool is_none() const {
        const auto words = std::bit_cast<Words>(halves_[0] | halves_[1]);
        return (words[0] | words[1]) == 0;
    }
    int count() const {
        const Half pairs = (halves_[0] & 0x5555) + (halves_[0] >> 1 & 0x5555);
        const Half other_pairs = (halves_[1] & 0x5555) + (halves_[1] >> 1 & 0x5555);
        const Half fours =
            (pairs & 0x3333) + (pairs >> 2 & 0x3333) + (other_pairs & 0x3333) + (other_pairs >> 2 & 0x3333);
        const Half bytes = (fours & 0x0f0f) + (fours >> 4 & 0x0f0f);
        const auto words = std::bit_cast<Words>(Half((bytes & 0x00ff) + (bytes >> 8)));
        constexpr std::uint64_t one_each = 0x0001'0001'0001'0001;
        return int((words[0] + words[1]) * one_each >> 48);
    }

    TileMask& operator&=(const TileMask& other) {
        for (std::size_t i = 0; i < halves_.size(); ++i) halves_[i] &= other.halves_[i];
        return *this;
    }
    TileMask& operator|=(const TileMask& other) {
        for (std::size_t i = 0; i < halves_.size(); ++i) halves_[i] |= other.halves_[i];
        return *this;
    }
    friend TileMask operator&(TileMask a, const TileMask& b) { return a &= b; }
    friend TileMask operator|(TileMask a, const TileMask& b) { return a |= b; }
    friend TileMask operator~(TileMask a) {
        for (Half& half : a.halves_) half = ~half;
        return a;
    }
    friend bool operator==(const TileMask& a, const TileMask& b) {
        return std::bit_cast<Bits>(a.halves_) == std::bit_cast<Bits>(b.halves_);
    }

  private:
    using Half [[gnu::vector_size(16)]] = std::uint16_t;
    using Words = std::array<std::uint64_t, 2>;
    using Bits = std::array<std::uint64_t, 4>;
    static constexpr int rows_of_half = sizeof(Half) / sizeof(std::uint16_t);
    static constexpr std::size_t half_of(int y) { return std::size_t(y / rows_of_half); }

    std::array<Half, rows / rows_of_half> halves_{};
};

/// Calls visit(y, columns) for each row that has any of the pixels.
template <class Visit>
void for_each_row(const TileMask& pixels, const Visit& visit) {
    for (unsigned rows = pixels.rows_with_some(); rows != 0; rows &= rows - 1) {
        const int y = std::countr_zero(rows);
        visit(y, pixels.row(y));
    }
}

}  // namespace zproof
