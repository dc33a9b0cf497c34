#include "compare/hearing/glance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace zproof {

void Glance::turn_to(std::span<const std::uint32_t> near, double aside_px) {
    near_ = near;
    aside_px_ = aside_px;
    filters_.clear();
    points_.turn_to(0);
    acquaintance_.expect(near);
    for (const std::uint32_t t : near) {
        const TriangleFilter& filter = acquaintance_.of(t).filter;
        filters_.push_back(&filter);
        filter.is_trusted ? points_.add(filter, false) : points_.add_unknown();
    }
}

bool Glance::sees(PrimitiveId answer, const PixelPlace& pixel) const {
    const Place centre{double(pixel.x), double(pixel.y)};
    if (answer == PrimitiveId::none) return is_bare(centre);
    const auto found = std::ranges::find(near_, std::uint32_t(answer));
    if (found == near_.end()) return false;
    const auto index = std::size_t(found - near_.begin());
    return is_seen(index, likely_place(*filters_[index], centre));
}

/// Inside the edges that pass that close to the centre: of two, where their values are as their errors.
auto Glance::likely_place(const TriangleFilter& answer, const Place& centre) const -> Place {
    std::array<std::size_t, 3> passing{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < answer.edge.size(); ++k) {
        const Affine<double>& e = answer.edge[k];
        if (e.at(centre.x, centre.y) <= aside_px_ * (std::abs(e.a) + std::abs(e.b)) + answer.edge_error[k])
            passing[count++] = k;
    }
    const Affine<double>&p = answer.edge[passing[0]], &q = answer.edge[passing[1]];
    if (count == 1)
        return {centre.x + std::copysign(aside_px_, p.a), centre.y + std::copysign(aside_px_, p.b)};
    if (count != 2) return centre;
    const double at_p = answer.edge_error[passing[0]], at_q = answer.edge_error[passing[1]];
    const double turn = p.a * q.b - q.a * p.b;
    const double x = (at_p * q.b - at_q * p.b) / turn, y = (p.a * at_q - q.a * at_p) / turn;
    const double scale = aside_px_ / std::max(std::abs(x), std::abs(y));
    return scale > 0 ? Place{centre.x + scale * x, centre.y + scale * y} : centre;
}

bool Glance::is_bare(const Place& at) const {
    return std::ranges::all_of(points_.at(at.x, at.y), [](const strips::PlacesOfEight& some) {
        return some.covers == 0 && some.cuts == 0;
    });
}

/// What is certainly outside or behind hides nothing.
bool Glance::is_seen(std::size_t answer, const Place& at) const {
    bool is_inside = false, is_hidden = false;
    std::size_t first = 0;
    for (const strips::PlacesOfEight& some : points_.at(at.x, at.y)) {
        for (unsigned there = some.covers | some.cuts; there != 0; there &= there - 1) {
            const unsigned lane = unsigned(std::countr_zero(there));
            if (first + lane == answer)
                is_inside = (some.covers >> lane & 1) != 0;
            else
                is_hidden = is_hidden || !is_behind(first + lane, answer, at);
        }
        first += 8;
    }
    return is_inside && !is_hidden;
}

bool Glance::is_behind(std::size_t back, std::size_t front, const Place& at) const {
    const TriangleFilter &b = *filters_[back], &f = *filters_[front];
    return b.is_trusted && (f.nearness - b.nearness).at(at.x, at.y) > f.nearness_error + b.nearness_error;
}

}  // namespace zproof
