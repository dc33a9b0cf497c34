#include "compare/adjudicate/triangle_cache.h"

#include <algorithm>

namespace zproof {

TriangleCache::TriangleCache(const Scene& scene, const View& view, const TriangleSearch& search,
                             std::span<const std::uint32_t> near)
    : scene_(scene), camera_(view.camera), near_(near) {
    boxes_.reserve(near.size());
    for (const std::uint32_t triangle : near) boxes_.push_back(search.boxes_of(triangle));
}

std::optional<std::size_t> TriangleCache::place_of(PrimitiveId answer) const {
    const auto found =
        std::ranges::lower_bound(near_, answer, {}, [](std::uint32_t t) { return PrimitiveId(t); });
    if (found == near_.end() || PrimitiveId(*found) != answer) return std::nullopt;
    return std::size_t(found - near_.begin());
}

const Box& TriangleCache::box(std::size_t place, const ViewBounds& bounds) {
    const ImageBoxes& boxes = boxes_[place];
    return boxes.are_one() ? boxes.all : boxes.by(of(place, bounds).bounds, camera_);
}

const BoundedTriangle& TriangleCache::of(std::size_t place, const ViewBounds& bounds) {
    auto found = std::ranges::find(renderers_, &bounds, &OfRenderer::bounds);
    if (found == renderers_.end())
        found = renderers_.insert(renderers_.end(),
                                  {&bounds, std::vector<std::optional<BoundedTriangle>>(near_.size())});
    std::optional<BoundedTriangle>& triangle = found->triangles[place];
    if (!triangle) triangle.emplace(bounds, corners_of(scene_, near_[place]));
    return *triangle;
}

}  // namespace zproof
