#include "compare/agree/depth_errors.h"

#include <algorithm>

#include "math/widest.h"

namespace zproof {

namespace {

template <Projection projection, TriangleDepth::Relative relative>
[[gnu::always_inline]] inline void find_errors(const TriangleDepth& of, int x, int y, int count,
                                               const float* depths, double* errors, double* rooms) {
    const TriangleDepth triangle = of;  // its numbers change under no pixel's error
    for (int i = 0; i < count; ++i) {
        const auto [error, room] = triangle.certain_error<projection, relative>(x + i, y, depths[i]);
        errors[i] = error;
        rooms[i] = room;
    }
}

template <Projection projection>
[[gnu::always_inline]] inline void find_errors(const TriangleDepth& of, int x, int y, int count,
                                               const float* depths, double* errors, double* rooms) {
    using enum TriangleDepth::Relative;
    if (of.relative() == constant)
        find_errors<projection, constant>(of, x, y, count, depths, errors, rooms);
    else
        find_errors<projection, by_inverse_depth>(of, x, y, count, depths, errors, rooms);
}

/// Every pixel's operations keep their order, whatever is done side by side.
void find_on_plane(const TriangleDepth& triangle, int x, int y, int count, const float* depths,
                   double* errors, double* rooms) {
    if (triangle.projection() == Projection::perspective)
        find_errors<Projection::perspective>(triangle, x, y, count, depths, errors, rooms);
    else
        find_errors<Projection::parallel>(triangle, x, y, count, depths, errors, rooms);
}

}  // namespace

void find_depth_errors(const TriangleDepth& triangle, int x, int y, std::size_t count, const float* depths,
                       double* errors, double* rooms) {
    const std::size_t rounded_up = (count + errors_together - 1) / errors_together * errors_together;
    if (triangle.has_plane()) {
        widest<find_on_plane>(triangle, x, y, int(rounded_up), depths, errors, rooms);
        return;
    }
    std::fill_n(errors, count, undecided_error);
    std::fill_n(rooms, count, undecided_error);
}

}  // namespace zproof
