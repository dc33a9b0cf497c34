#include "compare/agree/depth_errors.h"

#include <algorithm>

#include "math/widest.h"

namespace zproof {

namespace {

template <Projection projection>
[[gnu::always_inline]] inline void find_errors(const TriangleDepth& of, int x, int y, int count,
                                               const float* depths, double* errors, const float* other_depths,
                                               double* other_errors) {
    const TriangleDepth triangle = of;  // its numbers change under no pixel's error
    const auto error_at = [&](int i, float depth) {
        return triangle.certain_error<projection>(x + i, y, depth);
    };
    if (other_depths)
        for (int i = 0; i < count; ++i) {
            errors[i] = error_at(i, depths[i]);
            other_errors[i] = error_at(i, other_depths[i]);
        }
    else
        for (int i = 0; i < count; ++i) errors[i] = error_at(i, depths[i]);
}

/// Every pixel's operations keep their order, whatever is done side by side.
void find_on_plane(const TriangleDepth& triangle, int x, int y, int count, const float* depths,
                   double* errors, const float* other_depths, double* other_errors) {
    if (triangle.projection() == Projection::perspective)
        find_errors<Projection::perspective>(triangle, x, y, count, depths, errors, other_depths,
                                             other_errors);
    else
        find_errors<Projection::parallel>(triangle, x, y, count, depths, errors, other_depths, other_errors);
}

}  // namespace

void find_depth_errors(const TriangleDepth& triangle, int x, int y, std::size_t count, const float* depths,
                       double* errors, const float* other_depths, double* other_errors) {
    const std::size_t rounded_up = (count + errors_together - 1) / errors_together * errors_together;
    if (triangle.has_plane()) {
        widest<find_on_plane>(triangle, x, y, int(rounded_up), depths, errors, other_depths, other_errors);
        return;
    }
    std::fill_n(errors, count, undecided_error);
    if (other_depths) std::fill_n(other_errors, count, undecided_error);
}

}  // namespace zproof
