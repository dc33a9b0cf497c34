#include "compare/first_pass/law_maker.h"

#include <algorithm>
#include <array>

#include "compare/bounds/in_four.h"
#include "compare/bounds/side_by_side.h"
#include "compare/bounds/tolerance_terms.h"

namespace zproof {

namespace {

LawMaker::Lens::Side side_of(const ViewBounds& bounds) {
    return {bounds.common_terms(), bounds.keeps_to_corners() ? KeepsToCorners::yes : KeepsToCorners::no};
}

PlaneOfLaw<Four> plane_of(const LawMaker::Lens& lens, const TriangleSize<Four>& triangle,
                          const Corners<Four>& p) {
    const ScaledNearness<Four> plane = scaled_nearness(lens.first_pixel, p);
    const Affine<Four> nearness = (1.0 / plane.divisor) * plane.scaled;
    const auto& depth = triangle.depth;
    const Four low = smaller(smaller(depth[0], depth[1]), depth[2]);
    const Four high = larger(larger(depth[0], depth[1]), depth[2]);
    return {.nearness = nearness,
            .gradient = absolute(nearness.a) + absolute(nearness.b),
            .own_error = own_error_of(triangle.plane, nearness, lens.size),
            .nearest = held_between(low, lens.near_depth, lens.far_depth),
            .farthest = held_between(high, lens.near_depth, lens.far_depth)};
}

DepthLawOf<Four> law_of(const LawMaker::Lens::Side& side, const PlaneOfLaw<Four>& plane,
                        const TriangleSize<Four>& triangle) {
    const auto* raster = std::get_if<RasterTerms>(&side.terms);
    return law_of(plane, raster ? raster->of(triangle) : std::get_if<RayTerms>(&side.terms)->of(triangle),
                  side.keeps);
}

/// What both renderers say of four triangles.
struct LawsOfFour {
    DepthLawOf<Four> candidate, reference;
};
[[gnu::always_inline]] inline void set(LawsOfFour& laws, const LawMaker::Lens& lens,
                                       const std::array<CornersWorld, four_count>& p_world) {
    const Corners<Four> p = side_by_side(p_world);
    const TriangleSize<Four> triangle = lens.gauge(p);
    const PlaneOfLaw<Four> plane = plane_of(lens, triangle, p);
    laws.candidate = law_of(lens.candidate, plane, triangle);
    laws.reference = law_of(lens.reference, plane, triangle);
}

// Both are compiled once per instruction set, with everything that they call. No bit depends on which runs.

using FourLaws = std::span<DepthLaw, four_count>;
[[gnu::flatten, gnu::target_clones("default", "avx2")]] void make_four(
    const LawMaker::Lens& lens, const std::array<CornersWorld, four_count>& p_world, FourLaws candidate,
    FourLaws reference) {
    LawsOfFour laws;
    set(laws, lens, p_world);
    part<DepthLawOf>(laws.candidate, candidate);
    part<DepthLawOf>(laws.reference, reference);
}

[[gnu::flatten, gnu::target_clones("default", "avx2")]] void make_four(
    const LawMaker::Lens& lens, const std::array<CornersWorld, four_count>& p_world, const PixelBox& tile,
    std::span<DepthTolerance, four_count> far_off, std::span<CornerTolerance, four_count> next_to_corners) {
    LawsOfFour laws;
    set(laws, lens, p_world);
    const TolerancesOf<Four> both =
        tolerances_of<Four>(laws.candidate, laws.reference, lens.first_pixel.projection, tile);
    part<DepthToleranceOf>(both.far_off, far_off);
    part<CornerToleranceOf>(both.next_to_corners, next_to_corners);
}

/// Of triangles that are so much further on, memory is asked for what will be read; a triangle's indices say
/// where its corners are.
constexpr std::size_t indices_ahead = 24, corners_ahead = 12;

/// Inlined by force: gcc 12 takes it for a function without effects and leaves out a call.
[[gnu::always_inline]] inline void fetch_ahead(const Scene& scene, std::span<const PrimitiveId> triangles,
                                               std::size_t first) {
    const std::size_t indices = first + indices_ahead, corners = first + corners_ahead;
    for (std::size_t i = indices; i < std::min(indices + four_count, triangles.size()); ++i)
        __builtin_prefetch(&scene.triangles[std::size_t(triangles[i])]);
    for (std::size_t i = corners; i < std::min(corners + four_count, triangles.size()); ++i) {
        const glm::uvec3& t = scene.triangles[std::size_t(triangles[i])];
        for (const std::uint32_t vertex : {t.x, t.y, t.z})
            __builtin_prefetch(&scene.vertices.position_world[vertex]);
    }
}

}  // namespace

LawMaker::LawMaker(const Scene& scene, const Witness& candidate, const Witness& reference)
    : scene_(scene), candidate_(candidate), reference_(reference) {
    const View& view = candidate.view();
    lens_ = {.first_pixel = in_four(Sight<double>(view, 0, 0)),
             .gauge = candidate.bounds().gauge<Four>(),
             .near_depth = everywhere<Four>(view.camera.near_depth),
             .far_depth = everywhere<Four>(view.camera.far_depth),
             .candidate = side_of(candidate.bounds()),
             .reference = side_of(reference.bounds()),
             .size = {view.width, view.height}};
    is_common_ = lens_.candidate.terms.index() != 0 && lens_.reference.terms.index() != 0;
}

/// make(first, corners): of those from place `first` on, whose last corners are left where fewer are.
template <class Make>
void LawMaker::for_each_four(std::span<const PrimitiveId> triangles, const Make& make) const {
    std::array<CornersWorld, four_count> p_world{};
    for (std::size_t first = 0; first < triangles.size(); first += four_count) {
        const std::size_t count = std::min(four_count, triangles.size() - first);
        fetch_ahead(scene_, triangles, first);
        for (std::size_t i = 0; i < count; ++i)
            p_world[i] = corners_of(scene_, std::uint32_t(triangles[first + i]));
        make(first, p_world);
    }
}

/// make(i, candidate, reference): the laws of the triangle at place i.
template <class Make>
void LawMaker::for_each(std::span<const PrimitiveId> triangles, const Make& make) const {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const TriangleInView triangle = candidate_.triangle_in_view(triangles[i]);
        make(i, depth_law_of(triangle, candidate_.bounds()), depth_law_of(triangle, reference_.bounds()));
    }
}

void LawMaker::make(std::span<const PrimitiveId> triangles, std::size_t first_place, LawsOfBoth& laws) const {
    // whole groups of four; whoever stands in those of the last group that nobody asked for goes again
    const std::size_t room = first_place + triangles.size() + four_count;
    if (laws.candidate.size() < room) {
        laws.candidate.resize(2 * room);
        laws.reference.resize(2 * room);
    }
    DepthLaw *const candidate = &laws.candidate[first_place], *const reference = &laws.reference[first_place];
    if (is_common_)
        for_each_four(triangles, [&](std::size_t first, const auto& p_world) {
            make_four(lens_, p_world, FourLaws(candidate + first, four_count),
                      FourLaws(reference + first, four_count));
        });
    else
        for_each(triangles, [&](std::size_t i, const DepthLaw& ours, const DepthLaw& theirs) {
            candidate[i] = ours, reference[i] = theirs;
        });
}

void LawMaker::make_tolerances(std::span<const PrimitiveId> triangles, const PixelBox& tile,
                               const TileTolerances& tolerances) const {
    if (is_common_)
        for_each_four(triangles, [&](std::size_t first, const auto& p_world) {
            std::array<DepthTolerance, four_count> four;
            std::array<CornerTolerance, four_count> four_corners;
            make_four(lens_, p_world, tile, four, four_corners);
            const std::size_t count = std::min(four_count, triangles.size() - first);
            std::copy_n(four.begin(), count, &tolerances.far_off[first]);
            std::copy_n(four_corners.begin(), count, &tolerances.next_to_corners[first]);
        });
    else
        for_each(triangles, [&](std::size_t i, const DepthLaw& ours, const DepthLaw& theirs) {
            const Tolerances both = tolerances_of(ours, theirs, candidate_.projection(), tile);
            tolerances.far_off[i] = both.far_off;
            tolerances.next_to_corners[i] = both.next_to_corners;
        });
}

}  // namespace zproof
