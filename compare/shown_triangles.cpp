#include "compare/shown_triangles.h"

namespace zproof {

ShownTriangles::ShownTriangles(const Scene& scene, const Witness& candidate, const Witness& reference)
    : maker_(scene, candidate, reference), slots_(1024), laws_{{law_of_nothing}, {law_of_nothing}} {
    clear();
}

void ShownTriangles::clear() {
    ++tile_;
    triangles_.assign(1, PrimitiveId::none);
    made_ = 1;
}

std::uint32_t ShownTriangles::place_of(PrimitiveId triangle) {
    const auto id = std::uint32_t(triangle);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = (id * 0x9E3779B97F4A7C15u >> 40) & mask;; at = (at + 1) & mask) {
        Slot& slot = slots_[at];
        if (slot.tile == tile_ && slot.triangle == id) return slot.place;
        if (slot.tile == tile_) continue;
        slot = {id, std::uint32_t(triangles_.size()), tile_};
        triangles_.push_back(triangle);
        if (triangles_.size() > slots_.size() / 2) grow();
        return std::uint32_t(triangles_.size() - 1);
    }
}

void ShownTriangles::grow() {
    slots_.assign(2 * slots_.size(), {});
    const std::vector<PrimitiveId> triangles = std::move(triangles_);
    triangles_.assign(1, PrimitiveId::none);
    for (std::size_t place = 1; place < triangles.size(); ++place) place_of(triangles[place]);
}

void ShownTriangles::make_laws() {
    maker_.make(std::span(triangles_).subspan(made_), made_, laws_);
    made_ = triangles_.size();
}

}  // namespace zproof
