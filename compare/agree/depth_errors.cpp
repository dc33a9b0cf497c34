#include "compare/agree/depth_errors.h"

#include <algorithm>

#include "math/widest.h"

namespace zproof {

namespace {

template <Projection projection>
[[gnu::always_inline]] inline void find_errors(const TriangleDepth& of, int x, int y, int count,
                                               const float* depths, double* errors) {
    const TriangleDepth triangle = of;  // its numbers change under no pixel's error
    for (int i = 0; i < count; ++i) errors[i] = triangle.certain_error<projection>(x + i, y, depths[i]);
}

/// Every pixel's operations keep their order, whatever is done side by side.
void find_on_plane(const TriangleDepth& triangle, int x, int y, int count, const float* depths,
                   double* errors) {
    if (triangle.projection() == Projection::perspective)
        find_errors<Projection::perspective>(triangle, x, y, count, depths, errors);
    else
        find_errors<Projection::parallel>(triangle, x, y, count, depths, errors);
}

}  // namespace

void find_depth_errors(const TriangleDepth& triangle, int x, int y, std::size_t count, const float* depths,
                       double* errors) {
    const std::size_t rounded_up = (count + errors_together - 1) / errors_together * errors_together;
    if (triangle.has_plane())
        widest<find_on_plane>(triangle, x, y, int(rounded_up), depths, errors);
    else
        std::fill_n(errors, count, undecided_error);
}

}  // namespace zproof
