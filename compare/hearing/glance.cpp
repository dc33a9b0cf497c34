#include "compare/hearing/glance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "compare/strips/dispatch.h"

namespace zproof {

namespace {

constexpr std::size_t eight = 8;

}  // namespace

Glance::Glance(const Scene& scene, const View& view)
    : filters_(scene, view), kernel_(strips::widest_kernel()) {}

void Glance::turn_to(std::span<const std::uint32_t> near, double aside_px) {
    near_ = near;
    aside_px_ = aside_px;
    filters_.make(near, eights_);
    places_.resize(eights_.size());
}

bool Glance::sees(PrimitiveId answer, const PixelPlace& pixel) {
    const Place centre{double(pixel.x), double(pixel.y)};
    if (answer == PrimitiveId::none) return is_bare(centre);
    const auto found = std::ranges::find(near_, std::uint32_t(answer));
    if (found == near_.end()) return false;
    const auto index = std::size_t(found - near_.begin());
    return is_seen(index, likely_place(index, centre));
}

/// Inside the edges that pass that close to the centre: of two, where their values are as their errors.
auto Glance::likely_place(std::size_t answer, const Place& centre) const -> Place {
    struct Passing {
        double a, b, error;
    };
    std::array<Passing, 3> passing{};
    std::size_t count = 0;
    const std::size_t lane = answer % eight;
    for (const strips::EdgesOfEight& edges : eights_[answer / eight].points.edges) {
        const double a = edges.a[lane], b = edges.b[lane], error = edges.reach[lane];
        const double at_centre = a * centre.x + b * centre.y + edges.c[lane];
        if (at_centre <= aside_px_ * (std::abs(a) + std::abs(b)) + error) passing[count++] = {a, b, error};
    }
    const auto& [p, q, r] = passing;
    if (count == 1)
        return {centre.x + std::copysign(aside_px_, p.a), centre.y + std::copysign(aside_px_, p.b)};
    if (count != 2) return centre;
    const double turn = p.a * q.b - q.a * p.b;
    const double x = (p.error * q.b - q.error * p.b) / turn, y = (p.a * q.error - q.a * p.error) / turn;
    const double scale = aside_px_ / std::max(std::abs(x), std::abs(y));
    return scale > 0 ? Place{centre.x + scale * x, centre.y + scale * y} : centre;
}

std::span<const strips::PlacesOfEight> Glance::who_is_at(const Place& at) {
    for (std::size_t i = 0; i < eights_.size(); ++i)
        kernel_.set_places(&eights_[i].points, 1, at.x, at.y, &places_[i]);
    return places_;
}

bool Glance::is_bare(const Place& at) {
    return std::ranges::all_of(
        who_is_at(at), [](const strips::PlacesOfEight& some) { return some.covers == 0 && some.cuts == 0; });
}

/// What is certainly outside or behind hides nothing.
bool Glance::is_seen(std::size_t answer, const Place& at) {
    bool is_inside = false, is_hidden = false;
    std::size_t first = 0;
    for (const strips::PlacesOfEight& some : who_is_at(at)) {
        for (unsigned there = some.covers | some.cuts; there != 0; there &= there - 1) {
            const auto lane = std::size_t(std::countr_zero(there));
            if (first + lane == answer)
                is_inside = (some.covers >> lane & 1) != 0;
            else
                is_hidden = is_hidden || !is_behind(first + lane, answer, at);
        }
        first += eight;
    }
    return is_inside && !is_hidden;
}

bool Glance::is_behind(std::size_t back, std::size_t front, const Place& at) const {
    const auto &b = eights_[back / eight].nearness, &f = eights_[front / eight].nearness;
    const std::size_t i = back % eight, k = front % eight;
    const Affine<double> ahead{f.a[k] - b.a[i], f.b[k] - b.b[i], f.c[k] - b.c[i]};
    return ahead.at(at.x, at.y) > f.error[k] + b.error[i];
}

}  // namespace zproof
