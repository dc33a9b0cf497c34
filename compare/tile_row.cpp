#include "compare/tile_row.h"

namespace zproof {

namespace {

/// Compilers make vectors of it.
template <class Test>
[[gnu::always_inline]] inline ColumnMask mask_of(const Test& test) {
    std::uint64_t mask = 0;
    for (std::size_t i = 0; i < tile_columns; ++i) mask |= test(i) ? std::uint64_t{1} << i : 0;
    return ColumnMask(mask);
}

}  // namespace

[[gnu::target_clones("default", "avx2", "avx512f")]] ColumnMask above(const TileRow& a, const TileRow& b) {
    return mask_of([&](std::size_t i) { return a[i] > b[i]; });
}

[[gnu::target_clones("default", "avx2", "avx512f")]] ColumnMask at_least_zero(const TileRow& a) {
    return mask_of([&](std::size_t i) { return a[i] >= 0; });
}

[[gnu::target_clones("default", "avx2", "avx512f")]] TileRow raised(const TileRow& a, const TileRow& b,
                                                                    ColumnMask mask) {
    TileRow all;
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const double larger = a[i] < b[i] ? b[i] : a[i];
        all[i] = (std::uint64_t{mask} & std::uint64_t{1} << i) != 0 ? larger : a[i];
    }
    return all;
}

}  // namespace zproof
