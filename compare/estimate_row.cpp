#include "compare/estimate_row.h"

#include <cstddef>
#include <cstring>

namespace zproof {

namespace {

/// Numbers as they follow each other in memory.
constexpr std::size_t double_count = 5, float_count = 10;
/// Of the floats, those that perspectives have alone.
constexpr std::size_t perspective_float_count = 2;
static_assert((float_count - perspective_float_count) % 4 == 0);
static_assert(sizeof(EstimateRow::Plane) == double_count * sizeof(TileRow));
static_assert(sizeof(EstimateRow::Bound) == float_count * sizeof(TileRowOf<float>));
static_assert(offsetof(DepthEstimate, candidate) == double_count * sizeof(double));
static_assert(sizeof(DepthEstimate::Bound) == float_count * sizeof(float));
static_assert(sizeof(DepthEstimate) >= offsetof(DepthEstimate, reference) + 12 * sizeof(float));
static_assert(sizeof(DepthEstimate::Quiet) == 4 * sizeof(float));
static_assert(sizeof(EstimateRow::Quiet) == 4 * sizeof(TileRowOf<float>));

template <class Vector>
[[gnu::always_inline]] inline Vector load(const DepthEstimate* triangle, std::size_t first_byte) {
    Vector numbers;
    std::memcpy(&numbers, reinterpret_cast<const char*>(triangle) + first_byte, sizeof numbers);
    return numbers;
}

// Vectors of 32 bytes are passed in other registers where a function is compiled for AVX2: whatever returns
// one is part of put_side_by_side, in builds without optimization, too.

/// Those of four pixels, two numbers of each at a time. The last pair is one number and what follows it.
[[gnu::always_inline]] inline void put_planes(const DepthEstimate* const* triangles, std::size_t column,
                                              EstimateRow::Plane& row) {
    using Two = double __attribute__((vector_size(16)));
    using Four = double __attribute__((vector_size(32)));
    const auto put = [&](std::size_t number, const Four& four) {
        std::memcpy(reinterpret_cast<char*>(&row) + number * sizeof(TileRow) + column * sizeof(double), &four,
                    sizeof four);
    };
    for (std::size_t i = 0; i < double_count; i += 2) {
        const auto pair = [&](std::size_t pixel) { return load<Two>(triangles[pixel], i * sizeof(double)); };
        const Four even = __builtin_shufflevector(pair(0), pair(2), 0, 1, 2, 3);
        const Four odd = __builtin_shufflevector(pair(1), pair(3), 0, 1, 2, 3);
        put(i, __builtin_shufflevector(even, odd, 0, 4, 2, 6));
        if (i + 1 < double_count) put(i + 1, __builtin_shufflevector(even, odd, 1, 5, 3, 7));
    }
}

/// Four floats, numbers `first` to `last` of a row.
struct Floats {
    std::size_t first_byte;  ///< in DepthEstimate
    std::size_t first, last;
};

/// Those of eight pixels.
[[gnu::always_inline]] inline void put_four(const DepthEstimate* const* triangles, const Floats& floats,
                                            std::size_t column, void* row) {
    using Four = float __attribute__((vector_size(16)));
    using Eight = float __attribute__((vector_size(32)));
    const auto put = [&](std::size_t number, const Eight& eight) {
        std::memcpy(static_cast<char*>(row) + number * sizeof(TileRowOf<float>) + column * sizeof(float),
                    &eight, sizeof eight);
    };
    const auto pair = [&](std::size_t pixel) __attribute__((always_inline))->Eight {
        return __builtin_shufflevector(load<Four>(triangles[pixel], floats.first_byte),
                                       load<Four>(triangles[pixel + 4], floats.first_byte), 0, 1, 2, 3, 4, 5,
                                       6, 7);
    };
    const Eight a = pair(0), b = pair(1), c = pair(2), d = pair(3);
    const Eight ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13),
                cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13),
                ab_high = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15),
                cd_high = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    put(floats.first, __builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13));
    put(floats.first + 1, __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15));
    if (floats.first + 2 > floats.last) return;
    put(floats.first + 2, __builtin_shufflevector(ab_high, cd_high, 0, 1, 8, 9, 4, 5, 12, 13));
    put(floats.first + 3, __builtin_shufflevector(ab_high, cd_high, 2, 3, 10, 11, 6, 7, 14, 15));
}

/// Numbers [0, count), four at a time. A perspective's last four are two numbers and what follows them.
[[gnu::always_inline]] inline void put_floats(const Estimates& triangles, std::size_t first_byte,
                                              std::size_t count, void* row) {
    for (std::size_t column = 0; column < tile_columns; column += 8)
        for (std::size_t i = 0; i < count; i += 4)
            put_four(&triangles[column], {first_byte + i * sizeof(float), i, count - 1}, column, row);
}

std::size_t byte_of(DepthEstimate::Quiet DepthEstimate::*whose) {
    return whose == &DepthEstimate::candidate_quiet ? offsetof(DepthEstimate, candidate_quiet)
                                                    : offsetof(DepthEstimate, reference_quiet);
}
std::size_t byte_of(DepthEstimate::Bound DepthEstimate::*whose) {
    return whose == &DepthEstimate::candidate ? offsetof(DepthEstimate, candidate)
                                              : offsetof(DepthEstimate, reference);
}

}  // namespace

// Compiled once per instruction set; they move numbers only.

[[gnu::flatten, gnu::target_clones("default", "avx2")]] void put_side_by_side(const Estimates& triangles,
                                                                              EstimateRow::Plane& row) {
    for (std::size_t i = 0; i < tile_columns; i += 4) put_planes(&triangles[i], i, row);
}

[[gnu::flatten, gnu::target_clones("default", "avx2")]] void put_side_by_side(
    const Estimates& triangles, DepthEstimate::Quiet DepthEstimate::*whose, EstimateRow::Quiet& row) {
    put_floats(triangles, byte_of(whose), 4, &row);
}

[[gnu::flatten, gnu::target_clones("default", "avx2")]] void put_side_by_side(
    const Estimates& triangles, DepthEstimate::Bound DepthEstimate::*whose, Projection projection,
    EstimateRow::Bound& row) {
    const bool perspective = projection == Projection::perspective;
    put_floats(triangles, byte_of(whose), perspective ? float_count : float_count - perspective_float_count,
               &row);
}

}  // namespace zproof
