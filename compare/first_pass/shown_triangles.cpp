#include "compare/first_pass/shown_triangles.h"

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

std::uint32_t ShownTriangles::look_further(PrimitiveId triangle) {
    const std::uint64_t key = key_of(triangle);
    for (std::size_t at = first_slot_of(triangle);; at = (at + 1) & (slots_.size() - 1)) {
        Slot& slot = slots_[at];
        if (slot.key == key) return slot.place;
        if (slot.key >> 32 == tile_) continue;
        slot = {key, std::uint32_t(triangles_.size())};
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

void ShownTriangles::set_tolerances(const PixelBox& tile, std::vector<DepthTolerance>& far_off,
                                    std::vector<CornerTolerance>& next_to_corners) const {
    far_off.resize(triangles_.size());
    next_to_corners.resize(triangles_.size());
    far_off[0] = tolerance_of_nothing;
    next_to_corners[0] = corner_tolerance_of_nothing;
    maker_.make_tolerances(std::span(triangles_).subspan(1), tile,
                           {std::span(far_off).subspan(1), std::span(next_to_corners).subspan(1)});
}

}  // namespace zproof
