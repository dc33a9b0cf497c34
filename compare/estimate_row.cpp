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

/// Those of eight pixels, four numbers of each at a time. A perspective's last four are two numbers and what
/// follows them.
[[gnu::always_inline]] inline void put_bounds(Projection projection, const DepthEstimate* const* triangles,
                                              std::size_t first_byte, std::size_t column,
                                              EstimateRow::Bound& row) {
    using Four = float __attribute__((vector_size(16)));
    using Eight = float __attribute__((vector_size(32)));
    const auto put = [&](std::size_t number, const Eight& eight) {
        std::memcpy(
            reinterpret_cast<char*>(&row) + number * sizeof(TileRowOf<float>) + column * sizeof(float),
            &eight, sizeof eight);
    };
    const std::size_t count =
        projection == Projection::perspective ? float_count : float_count - perspective_float_count;
    for (std::size_t i = 0; i < count; i += 4) {
        const auto pair = [&](std::size_t pixel) __attribute__((always_inline))->Eight {
            const std::size_t at = first_byte + i * sizeof(float);
            return __builtin_shufflevector(load<Four>(triangles[pixel], at),
                                           load<Four>(triangles[pixel + 4], at), 0, 1, 2, 3, 4, 5, 6, 7);
        };
        const Eight a = pair(0), b = pair(1), c = pair(2), d = pair(3);
        const Eight ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13),
                    cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13),
                    ab_high = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15),
                    cd_high = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
        put(i, __builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13));
        put(i + 1, __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15));
        if (i + 2 >= count) break;
        put(i + 2, __builtin_shufflevector(ab_high, cd_high, 0, 1, 8, 9, 4, 5, 12, 13));
        put(i + 3, __builtin_shufflevector(ab_high, cd_high, 2, 3, 10, 11, 6, 7, 14, 15));
    }
}

}  // namespace

/// Compiled once per instruction set; it moves numbers only.
[[gnu::flatten, gnu::target_clones("default", "avx2")]] void put_side_by_side(Projection projection,
                                                                              const Estimates& ours,
                                                                              const Estimates& theirs,
                                                                              EstimateRow& row) {
    row.is_one_plane = &ours == &theirs;
    for (std::size_t i = 0; i < tile_columns; i += 4) put_planes(&ours[i], i, row.candidate.plane);
    for (std::size_t i = 0; i < tile_columns && !row.is_one_plane; i += 4)
        put_planes(&theirs[i], i, row.reference.plane);
    for (std::size_t i = 0; i < tile_columns; i += 8) {
        put_bounds(projection, &ours[i], offsetof(DepthEstimate, candidate), i, row.candidate.bound);
        put_bounds(projection, &theirs[i], offsetof(DepthEstimate, reference), i, row.reference.bound);
    }
}

}  // namespace zproof
