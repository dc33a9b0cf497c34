#include "tests/attack/fixed_edges.h"

#include <algorithm>

namespace zproof::attack {

namespace {

__extension__ using Wide = __int128;  // products of places reach 2^73

Wide side_of(const FixedPoint& a, const FixedPoint& b, const FixedPoint& p) {
    return Wide(b.x - a.x) * (p.y - a.y) - Wide(b.y - a.y) * (p.x - a.x);
}

/// Of two triangles that share an edge and lie on different sides of it, one has this.
bool owns(const FixedPoint& a, const FixedPoint& b, EdgeOwner owner) {
    if (owner == EdgeOwner::all) return true;
    const bool is_top_left = b.y < a.y || (b.y == a.y && b.x > a.x);
    return is_top_left == (owner == EdgeOwner::top_left);
}

}  // namespace

FixedPoint fixed_sample(const View& view, int x, int y) {
    const glm::dvec2 at = sampled_at(view, x, y) * double(fixed_one);
    return {std::int64_t(at.x), std::int64_t(at.y)};
}

FixedEdges::FixedEdges(const FixedTriangle& triangle, EdgeOwner owner) : corners_(triangle), owner_(owner) {
    is_turned_ = side_of(corners_[0], corners_[1], corners_[2]) < 0;
    if (is_turned_) std::swap(corners_[1], corners_[2]);
}

PixelBox FixedEdges::box(const View& view) const {
    const auto [left, right] = std::minmax({corners_[0].x, corners_[1].x, corners_[2].x});
    const auto [top, bottom] = std::minmax({corners_[0].y, corners_[1].y, corners_[2].y});
    const auto pixel = [](std::int64_t at, int size) {
        return int(std::clamp<std::int64_t>(at / fixed_one, -1, size));
    };
    return {std::max(pixel(left, view.width) - 1, 0), std::max(pixel(top, view.height) - 1, 0),
            std::min(pixel(right, view.width) + 2, view.width),
            std::min(pixel(bottom, view.height) + 2, view.height)};
}

std::optional<std::array<double, 3>> FixedEdges::weights_at(const FixedPoint& p) const {
    const Wide area = side_of(corners_[0], corners_[1], corners_[2]);
    if (area == 0) return std::nullopt;
    std::array<double, 3> weights{};
    for (std::size_t i = 0; i < 3; ++i) {
        const FixedPoint &a = corners_[(i + 1) % 3], &b = corners_[(i + 2) % 3];
        const Wide side = side_of(a, b, p);
        if (side < 0 || (side == 0 && !owns(a, b, owner_))) return std::nullopt;
        weights[i] = double(side) / double(area);
    }
    if (is_turned_) std::swap(weights[1], weights[2]);
    return weights;
}

}  // namespace zproof::attack
