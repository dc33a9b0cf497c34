#include "compare/truth/estimate.h"

namespace zproof {

const Neighbourhood& Estimate::around() {
    if (!around_) around_.emplace(gather_());
    return *around_;
}

AdmissibleSet<double>& Estimate::set_within(double half_side_px) {
    if (!set_) set_.emplace(around(), coplanar_);
    set_->set_half_side(half_side_px);
    return *set_;
}

bool Estimate::is_seen_within(double half_side_px) {
    AdmissibleSet<double>& set = set_within(half_side_px);
    if (answer_ == PrimitiveId::none) return set.holds_background(EdgeRule::watertight);
    const std::optional<std::size_t> index = around_->index_of(answer_);
    return index && set.is_seen(*index);
}

std::vector<PixelOffset> Estimate::places_seen(double half_side_px) {
    AdmissibleSet<double>& set = set_within(half_side_px);
    std::vector<PixelOffset> places;
    if (const auto index = around_->index_of(answer_))
        for (const Region<double>& part : set.visible_parts(*index)) {
            const auto [x, y] = part.middle();
            places.push_back({x, y});
        }
    return places;
}

}  // namespace zproof
