#include "compare/square_places.h"

#include <algorithm>
#include <limits>

namespace zproof {

void SquarePlaces::turn_to(double half_side_px) {
    half_side_px_ = half_side_px;
    count_ = 0;
    groups_.clear();
}

auto SquarePlaces::group_of_next() -> Group& {
    if (count_ % four_count == 0) groups_.emplace_back();
    return groups_.back();
}

void SquarePlaces::add(const TriangleFilter& filter, bool covers_all) {
    Group& group = group_of_next();
    const std::size_t lane = count_++ % four_count;
    for (std::size_t k = 0; k < group.size(); ++k) {
        Edges& edges = group[k];
        const Affine<double> edge = covers_all ? Affine<double>{0, 0, 1} : filter.edge[k];
        edges.a[lane] = edge.a, edges.b[lane] = edge.b, edges.c[lane] = edge.c;
        edges.reach[lane] = half_side_px_ * std::abs(edge.a) + half_side_px_ * std::abs(edge.b) +
                            (covers_all ? 0 : filter.edge_error);
    }
}

void SquarePlaces::add_unknown() {
    Group& group = group_of_next();
    const std::size_t lane = count_++ % four_count;
    for (Edges& edges : group) edges.reach[lane] = std::numeric_limits<double>::infinity();
}

[[gnu::target_clones("default", "avx2")]] void SquarePlaces::sort(int x, int y,
                                                                  std::vector<std::size_t>& covering,
                                                                  std::vector<std::size_t>& cutting) const {
    covering.clear();
    cutting.clear();
    using Lanes = decltype(Four{} < Four{});
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        Lanes misses{}, covers = ~misses;
        for (const Edges& edges : groups_[g]) {
            const Four middle = edges.a * double(x) + edges.b * double(y) + edges.c;
            misses |= middle + edges.reach < 0.0;
            covers &= middle - edges.reach > 0.0;
        }
        if (holds_in_all(misses)) continue;
        const std::size_t from = g * four_count, end = std::min(from + four_count, count_);
        for (std::size_t i = from; i < end; ++i)
            if (!misses[i - from]) (covers[i - from] ? covering : cutting).push_back(i);
    }
}

}  // namespace zproof
