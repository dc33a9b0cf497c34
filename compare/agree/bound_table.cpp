#include "compare/agree/bound_table.h"

#include <algorithm>

namespace zproof {

void BoundTable::clear() {
    std::ranges::fill(slots_, Slot{});
    triangles_.clear();
    depths_.clear();
}

auto BoundTable::slot_of(PrimitiveId triangle) -> Slot& {
    const std::size_t last = slots_.size() - 1;
    std::size_t at = (std::uint32_t(triangle) * 0x9E3779B97F4A7C15u >> 40) & last;
    while (slots_[at].triangle != triangle && slots_[at].triangle != PrimitiveId::none) at = (at + 1) & last;
    return slots_[at];
}

std::uint32_t BoundTable::place_of(PrimitiveId triangle) {
    Slot& slot = slot_of(triangle);
    if (slot.triangle == triangle) return slot.place;
    slot = {triangle, std::uint32_t(triangles_.size())};
    triangles_.push_back(triangle);
    if (2 * triangles_.size() > slots_.size()) grow();
    return std::uint32_t(triangles_.size() - 1);
}

void BoundTable::grow() {
    slots_.assign(2 * slots_.size(), {});
    for (std::size_t place = 0; place < triangles_.size(); ++place)
        slot_of(triangles_[place]) = {triangles_[place], std::uint32_t(place)};
}

void BoundTable::make() {
    const auto& [scene, view, candidate, reference] = frames_;
    for (std::size_t place = depths_.size(); place < triangles_.size(); ++place) {
        const TriangleInView triangle(first_pixel_, candidate.bounds,
                                      corners_of(scene, std::uint32_t(triangles_[place])));
        const ViewBounds &ours = candidate.shown_bounds, &theirs = reference.shown_bounds;
        depths_.push_back({TriangleDepth(triangle, ours), TriangleDepth(triangle, theirs)});
    }
}

}  // namespace zproof
