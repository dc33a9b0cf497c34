#include "scenes/flat_triangles.h"

#include <algorithm>
#include <cstring>

#include "math/widest.h"

namespace zproof {
namespace {

/// A vertex and whatever follows it in memory, side by side.
typedef float Floats __attribute__((vector_size(16)));
typedef double Doubles __attribute__((vector_size(32)));
typedef std::int64_t Longs __attribute__((vector_size(32)));

static_assert(sizeof(glm::vec3) + Positions::allocator_type::padding >= sizeof(Floats));

/// The number of triangles to fetch ahead: their vertices were just written, often by another core.
constexpr std::size_t fetched_ahead = 16;

/// Counted in each of the first three lanes; what the last one holds means nothing. Without a branch: in a
/// box or a house every other triangle lies in a plane of the axes, so that one component alone tells
/// nothing.
std::uint64_t flat_side_by_side(std::span<const glm::uvec3> triangles, const glm::vec3* positions) {
    Longs flat{};
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const glm::uvec3& t = triangles[k];
        const glm::uvec3& later = triangles[std::min(k + fetched_ahead, triangles.size() - 1)];
        for (int i = 0; i < 3; ++i) __builtin_prefetch(positions + later[i]);
        Floats corner[3];
        for (int i = 0; i < 3; ++i) std::memcpy(&corner[i], positions + t[i], sizeof(Floats));
        const Doubles origin = __builtin_convertvector(corner[0], Doubles);
        const Doubles a = __builtin_convertvector(corner[1], Doubles) - origin;
        const Doubles b = __builtin_convertvector(corner[2], Doubles) - origin;
        const Longs zero =
            __builtin_shufflevector(a, a, 1, 2, 0, 3) * __builtin_shufflevector(b, b, 2, 0, 1, 3) ==
            __builtin_shufflevector(a, a, 2, 0, 1, 3) * __builtin_shufflevector(b, b, 1, 2, 0, 3);
        flat -= zero & __builtin_shufflevector(zero, zero, 1, 2, 0, 3) &
                __builtin_shufflevector(zero, zero, 2, 0, 1, 3);
    }
    return static_cast<std::uint64_t>(flat[0]);
}

}  // namespace

std::uint64_t flat_among(std::span<const glm::uvec3> triangles, const Positions& positions) {
    return widest<flat_side_by_side, InstructionSet::avx2>(triangles, positions.data());
}

}  // namespace zproof
