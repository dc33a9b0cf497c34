/// Views and triangles in Fours. To be called where everything is inlined, as four.h has it.
#pragma once

#include <array>

#include "compare/bounds/bounds.h"
#include "compare/bounds/four.h"
#include "compare/bounds/triangle_image.h"

namespace zproof {

inline Vector3<Four> in_four(const Vector3<double>& v) {
    return {everywhere<Four>(v.x), everywhere<Four>(v.y), everywhere<Four>(v.z)};
}

inline Sight<Four> in_four(const Sight<double>& sight) {
    Sight<Four> four;
    four.projection = sight.projection;
    four.origin = in_four(sight.origin);
    four.direction = in_four(sight.direction);
    four.step_x = in_four(sight.step_x);
    four.step_y = in_four(sight.step_y);
    return four;
}

/// Floats, widened without loss.
inline Four widened(float a, float b, float c, float d) {
    using Floats = float __attribute__((vector_size(16)));
    return __builtin_convertvector((Floats{a, b, c, d}), Four);
}

/// A triangle to each lane.
inline Corners<Four> side_by_side(const std::array<CornersWorld, four_count>& p) {
    const auto corner = [&](std::size_t i) -> Vector3<Four> {
        return {widened(p[0][i].x, p[1][i].x, p[2][i].x, p[3][i].x),
                widened(p[0][i].y, p[1][i].y, p[2][i].y, p[3][i].y),
                widened(p[0][i].z, p[1][i].z, p[2][i].z, p[3][i].z)};
    };
    return {corner(0), corner(1), corner(2)};
}

}  // namespace zproof
