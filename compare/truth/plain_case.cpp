#include "compare/truth/plain_case.h"

#include <algorithm>
#include <cmath>

namespace zproof {

namespace {

enum class Place { misses, covers, unknown };

double reach(const Affine<double>& f, double half_side) {
    return half_side * (std::abs(f.a) + std::abs(f.b));
}

/// Where the square lies as seen from the triangle.
Place place_of(const Neighbour& n, double half_side) {
    if (!n.image) return Place::unknown;
    const auto& edges = n.image->edge;
    if (std::ranges::any_of(edges,
                            [&](const auto& e) { return e.c + reach(e, half_side) < -2 * n.edge_error; }))
        return Place::misses;
    const bool covers = std::ranges::all_of(
        edges, [&](const auto& e) { return e.c - reach(e, half_side) > 2 * n.edge_error; });
    return covers ? Place::covers : Place::unknown;
}

bool is_between_the_planes(const Camera& c, const Neighbour& n) {
    return n.nearest > c.near_depth + n.near_slack && n.farthest < c.far_depth - n.far_slack;
}

/// What an occluder does to an answer's triangle when both cover the square.
enum class Hiding { none, by_tie, for_certain, unknown };

/// The rules of AdmissibleSet::is_in_front and true_cover, by ranges first and then by the planes themselves.
Hiding hiding_of(const Neighbour& front, const Neighbour& back, double half_side, CoplanarMemory& memory) {
    if (front.least_nearness > back.greatest_nearness) return Hiding::for_certain;
    const double slope = half_side * (front.gradient + back.gradient);
    if (front.greatest_nearness + slope < back.least_nearness) return Hiding::none;
    if (front.greatest_nearness < back.least_nearness) return Hiding::unknown;
    if (memory(front.of_scene(), back.of_scene())) return Hiding::by_tie;
    const Affine<double> ahead = front.image->nearness - back.image->nearness;
    const double unsure = 2 * (front.plane_error + back.plane_error) + reach(ahead, half_side);
    if (ahead.c > unsure) return Hiding::by_tie;
    return ahead.c < -unsure ? Hiding::none : Hiding::unknown;
}

}  // namespace

std::optional<Standing> standing_without_edges(const Neighbourhood& around, PrimitiveId answer,
                                               CoplanarMemory& memory) {
    constexpr double most_eps_px = 1;  // where the errors of an image in double hold
    const std::optional<size_t> index = around.index_of(answer);
    if (!index || around.eps_px > most_eps_px) return std::nullopt;
    const Neighbour& seen = around.neighbours[*index];
    if (place_of(seen, around.eps_px) != Place::covers) return std::nullopt;
    Standing standing = Standing::visible;
    for (const Neighbour& n : around.neighbours) {
        const Place place = place_of(n, around.eps_px);
        if (place == Place::misses) continue;
        if (place == Place::unknown || !is_between_the_planes(around.view.camera, n)) return std::nullopt;
        const Hiding hiding = &n == &seen ? Hiding::none : hiding_of(n, seen, around.eps_px, memory);
        if (hiding == Hiding::unknown || hiding == Hiding::for_certain) return std::nullopt;
        if (hiding == Hiding::by_tie) standing = Standing::tied;
    }
    return standing;
}

}  // namespace zproof
