#include "compare/first_pass/pixel_look.h"

#include <limits>

#include "compare/first_pass/held_depths.h"

namespace zproof {

namespace {

/// Few triangles are ever asked about outside of the laws of a tile.
constexpr std::size_t remembered_triangles = 64;

}  // namespace

PixelLook::PixelLook(const Scene& scene, const Witness& candidate, const Witness& reference)
    : triangle_count_(scene.triangles.size()),
      candidate_(candidate),
      reference_(reference),
      triangles_(remembered_triangles) {}

auto PixelLook::depth_of_both(PrimitiveId primitive) -> const DepthOfBoth& {
    return triangles_(std::uint32_t(primitive), [&] {
        const TriangleInView triangle = candidate_.triangle_in_view(primitive);
        return DepthOfBoth{depth_of(triangle, candidate_.bounds()), depth_of(triangle, reference_.bounds())};
    });
}

OpenPixel PixelLook::at(int x, int y, double known_reference_ratio) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    OpenPixel open;
    Finding& f = open.finding;
    f = {.x = x,
         .y = y,
         .candidate = candidate_.answer_at(x, y),
         .reference = reference_.answer_at(x, y),
         .candidate_depth = {nan, nan, nan},
         .error_over_bound = nan};
    open.candidate_invalid = is_invalid(f.candidate, triangle_count_);
    open.reference_invalid = is_invalid(f.reference, triangle_count_);
    if (!open.candidate_invalid && f.candidate.primitive != PrimitiveId::none) {
        const DepthCheck check =
            candidate_.check(depth_of_both(f.candidate.primitive).candidate, f.candidate, x, y);
        f.candidate_depth = check.bound;
        f.error_over_bound = check.error_over_bound;
        open.candidate_depth_lawful = check.lawful;
    }
    if (known_reference_ratio != unsettled) {
        open.reference_error_over_bound = known_reference_ratio;
    } else if (!open.reference_invalid && f.reference.primitive != PrimitiveId::none) {
        const DepthCheck check =
            reference_.check(depth_of_both(f.reference.primitive).reference, f.reference, x, y);
        open.reference_error_over_bound = check.error_over_bound;
        open.reference_depth_lawful = check.lawful;
    }
    return open;
}

bool is_settled(const OpenPixel& p) {
    return p.finding.candidate.primitive == p.finding.reference.primitive && !p.candidate_invalid &&
           !p.reference_invalid && p.candidate_depth_lawful && p.reference_depth_lawful;
}

}  // namespace zproof
