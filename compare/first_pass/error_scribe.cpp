#include "compare/first_pass/error_scribe.h"

#include <algorithm>
#include <limits>

namespace zproof {

namespace {

/// Few triangles are asked about one by one.
constexpr std::size_t remembered_triangles = 64;

/// Every ratio as the map has it; `unsettled` stays what it is. Are there such?
[[gnu::target_clones("default", "avx2", "avx512f")]] bool round_ratios(const PrimitiveId* shown,
                                                                       const Strip::Values<double>& ratios,
                                                                       std::uint32_t triangle_count,
                                                                       Strip::Values<float>& errors) {
    std::uint32_t left = 0;
    for (std::size_t i = 0; i < Strip::width; ++i) {
        const bool is_asked = std::uint32_t(shown[i]) < triangle_count;
        const auto ratio = float(ratios[i]);
        errors[i] = is_asked ? ratio : std::numeric_limits<float>::quiet_NaN();
        left |= is_asked & (ratio < 0);
    }
    return left != 0;
}

}  // namespace

ErrorScribe::ErrorScribe(const Witness& witness, std::size_t triangle_count, Plane<float>& map)
    : witness_(witness),
      triangle_count_(std::uint32_t(triangle_count)),
      map_(map),
      triangles_(remembered_triangles) {}

void ErrorScribe::write(const Strip::Side& shown, const Strip::Values<double>& ratio, const Pixels& pixels) {
    Strip::Values<float> errors;
    const bool are_some_left = round_ratios(shown.primitive, ratio, triangle_count_, errors);
    for (std::size_t i = 0; are_some_left && i < pixels.count; ++i)
        if (errors[i] == float(unsettled))
            errors[i] = error_at(shown.primitive[i], pixels.x + int(i), pixels.y);
    std::copy_n(errors.begin(), pixels.count, map_.row(pixels.y).begin() + pixels.x);
}

float ErrorScribe::error_at(PrimitiveId primitive, int x, int y) {
    const TriangleDepth& triangle = triangles_(std::uint32_t(primitive), [&] {
        return depth_of(witness_.triangle_in_view(primitive), witness_.bounds());
    });
    return float(error_over_bound(triangle.at(x, y), witness_.frame().camera_depth.at(x, y)));
}

}  // namespace zproof
