#include "compare/labels/search_reach.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

#include "compare/admissible/neighbourhood.h"

namespace zproof {

namespace {

/// Triangles whose eps is below this everywhere are found by any search. It costs or saves time and changes
/// no answer.
constexpr double least_px = 1.0 / 16;

}  // namespace

SearchReach::SearchReach(const Scene& scene, const View& view, const ViewBounds& bounds)
    : scene_(scene), view_(view), bounds_(bounds) {
    const BoxProjection projection(view);
    tbb::enumerable_thread_specific<std::vector<Wide>> found;
    tbb::parallel_for(std::size_t(0), scene.triangles.size(), [&](std::size_t t) {
        const CornersWorld p_world = corners_of(scene, std::uint32_t(t));
        const double most_px = bounds.of(p_world).most_eps_px();
        if (most_px <= least_px) return;
        if (const Box box = projection.before_eye(p_world); !box.is_empty())
            found.local().push_back({std::uint32_t(t), most_px, box});
    });
    for (const auto& some : found) wide_.insert(wide_.end(), some.begin(), some.end());
    tbb::parallel_sort(wide_, [](const Wide& a, const Wide& b) {
        return std::tie(b.most_px, a.triangle) < std::tie(a.most_px, b.triangle);
    });
}

/// docs/labels.md says why that is far enough. 2: TileWork asks as far as twice an answer's eps whose eps
/// counts.
double SearchReach::at(const PixelCoord& pixel) const {
    double reach_px = least_px;
    for (const Wide& wide : wide_) {
        if (wide.most_px <= reach_px) break;
        if (!wide.box.meets(square_around(pixel.x, pixel.y, 2 * wide.most_px))) continue;
        const double eps_px = own_eps_px(scene_, view_, bounds_, pixel, PrimitiveId(wide.triangle));
        if (wide.box.meets(square_around(pixel.x, pixel.y, 2 * eps_px)))
            reach_px = std::max(reach_px, eps_px);
    }
    return reach_px;
}

}  // namespace zproof
