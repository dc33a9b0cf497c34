#include "compare/hearing/square_places.h"

#include <bit>
#include <cmath>
#include <limits>

#include "compare/strips/dispatch.h"

namespace zproof {

namespace {

constexpr std::size_t side_by_side = 8;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// It misses every square.
constexpr strips::Eight nobody = [] {
    strips::Eight eight{};
    for (strips::EdgesOfEight& edges : eight.edges)
        for (double& reach : edges.reach) reach = -infinite;
    return eight;
}();

void add_all(std::vector<std::size_t>& places, std::size_t first, unsigned some) {
    for (; some != 0; some &= some - 1) places.push_back(first + std::size_t(std::countr_zero(some)));
}

}  // namespace

SquarePlaces::SquarePlaces() : kernel_(strips::widest_kernel()) {}

void SquarePlaces::turn_to(double half_side_px) {
    half_side_px_ = half_side_px;
    count_ = 0;
    eights_.clear();
}

auto SquarePlaces::next() -> Lane {
    const std::size_t lane = count_++ % side_by_side;
    if (lane == 0) eights_.push_back(nobody);
    return {eights_.back(), lane};
}

void SquarePlaces::add(const TriangleFilter& filter, bool covers_all) {
    const auto [eight, lane] = next();
    for (std::size_t k = 0; k < filter.edge.size(); ++k) {
        strips::EdgesOfEight& edges = eight.edges[k];
        const Affine<double> edge = covers_all ? Affine<double>{0, 0, 1} : filter.edge[k];
        edges.a[lane] = edge.a, edges.b[lane] = edge.b, edges.c[lane] = edge.c;
        edges.reach[lane] = half_side_px_ * std::abs(edge.a) + half_side_px_ * std::abs(edge.b) +
                            (covers_all ? 0 : filter.edge_error[k]);
    }
}

void SquarePlaces::add_unknown() {
    const auto [eight, lane] = next();
    for (strips::EdgesOfEight& edges : eight.edges) edges.reach[lane] = infinite;
}

void SquarePlaces::sort(int x, int y, std::vector<std::size_t>& covering,
                        std::vector<std::size_t>& cutting) const {
    covering.clear();
    cutting.clear();
    places_.resize(eights_.size());
    kernel_.set_places(eights_.data(), int(eights_.size()), x, y, places_.data());
    for (std::size_t i = 0; i < places_.size(); ++i) {
        add_all(covering, i * side_by_side, places_[i].covers);
        add_all(cutting, i * side_by_side, places_[i].cuts);
    }
}

}  // namespace zproof
