#include "compare/agree/coarse_tiles.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "compare/adjudicate/image_box.h"
#include "compare/bounds/triangle_depth.h"

namespace zproof {

namespace {

/// The largest eps anywhere on the triangle.
double most_eps_px(const TriangleBounds& bounds) {
    return bounds.eps_base_px +
           bounds.eps_per_inverse_depth * CornerInverseDepth(bounds.nearest, bounds.farthest).highest;
}

/// May near or far cut the triangle?
bool may_be_cut(const Camera& camera, const TriangleBounds& bounds) {
    return bounds.nearest <= camera.near_depth + bounds.near_slack ||
           bounds.farthest >= camera.far_depth - bounds.far_slack;
}

double inverse_depth_at(double depth, Projection projection) {
    if (projection == Projection::parallel) return -depth;
    return depth > 0 ? 1 / depth : unlimited;
}

/// A triangle by the bounds of both.
struct BoundedByBoth {
    BoundedByBoth(const FramePair& frames, const CornersWorld& p_world)
        : in_view(frames.view, frames.reference.bounds, p_world),
          reference(frames.reference.bounds.of(in_view.extent)),
          candidate(frames.candidate.bounds.of(in_view.extent)),
          reference_on_plane(reference, in_view.gradient),
          candidate_on_plane(candidate, in_view.gradient) {}

    /// Is the reference's eps the larger, or the place of its near or far the less certain, anywhere in the
    /// box?
    bool is_coarse_in(const Box& pixels, const Camera& camera) const {
        const Affine<double>& f = in_view.inverse_depth;
        const double middle = f.at((pixels.left + pixels.right) / 2, (pixels.top + pixels.bottom) / 2),
                     reach = in_view.gradient * (pixels.right - pixels.left) + in_view.own_error;
        const bool is_known = !in_view.is_edge_on && std::isfinite(reach);
        const double low = is_known ? middle - reach : -unlimited,
                     high = is_known ? middle + reach : unlimited;
        const auto holds_plane = [&](double depth, double slack) {
            return inverse_depth_at(depth + slack, camera.projection) <= high &&
                   inverse_depth_at(depth - slack, camera.projection) >= low;
        };
        return !(reference_on_plane.at(high).eps_px <= candidate_on_plane.at(low).eps_px) ||
               (reference.may_be_missing && !candidate.may_be_missing) ||
               (reference.near_slack > candidate.near_slack &&
                holds_plane(camera.near_depth, reference.near_slack)) ||
               (reference.far_slack > candidate.far_slack &&
                holds_plane(camera.far_depth, reference.far_slack));
    }

    TriangleInView in_view;
    TriangleBounds reference, candidate;
    BoundsOnPlane reference_on_plane, candidate_on_plane;
};

/// Triangles of which the reference may promise less; most are told from the rest by the reference's bounds.
std::vector<std::uint32_t> coarse_triangles(const FramePair& frames) {
    const ViewBounds &reference = frames.reference.bounds, &candidate = frames.candidate.bounds;
    const Camera& camera = frames.view.camera;
    tbb::enumerable_thread_specific<std::vector<std::uint32_t>> found;
    tbb::parallel_for(std::size_t(0), frames.scene.triangles.size(), [&](std::size_t i) {
        const TriangleBounds bounds = reference.of(corners_of(frames.scene, std::uint32_t(i)));
        if (!(most_eps_px(bounds) <= candidate.least_eps_px()) || bounds.may_be_missing ||
            may_be_cut(camera, bounds))
            found.local().push_back(std::uint32_t(i));
    });
    std::vector<std::uint32_t> all;
    for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace

CoarseTiles::CoarseTiles(const FramePair& frames) : tiles_(frames.view), is_coarse_(tiles_.count()) {
    const ViewBounds &reference = frames.reference.bounds, &candidate = frames.candidate.bounds;
    if (!(reference.background_eps_px() <= candidate.background_eps_px()) ||
        (candidate.is_watertight() && !reference.is_watertight()))
        is_coarse_.assign(tiles_.count(), true);
    for (const std::uint32_t triangle : coarse_triangles(frames)) mark(frames, triangle);
    has_any_ = std::ranges::count(is_coarse_, true) > 0;
}

void CoarseTiles::mark(const FramePair& frames, std::uint32_t triangle) {
    const CornersWorld p_world = corners_of(frames.scene, triangle);
    const BoundedByBoth both(frames, p_world);
    Box box = BoxProjection(frames.view)(p_world).value_or(Box{});
    if (box.is_empty()) return;
    box.widen(most_eps_px(both.reference));
    constexpr double side = Tiles::side_px;
    const auto clamped = [](double px, int count) { return int(std::clamp(px / side, 0.0, count - 1.0)); };
    for (int row = clamped(box.top, tiles_.rows); row <= clamped(box.bottom, tiles_.rows); ++row)
        for (int column = clamped(box.left, tiles_.columns); column <= clamped(box.right, tiles_.columns);
             ++column) {
            const Box pixels{column * side, row * side, (column + 1) * side, (row + 1) * side};
            const std::size_t tile = tiles_.index(column, row);
            if (!is_coarse_[tile] && box.meets(pixels))
                is_coarse_[tile] = both.is_coarse_in(pixels, frames.view.camera);
        }
}

}  // namespace zproof
