#include "lessons/projection/wireframe.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace zproof::study::projection {

namespace {

using Place = std::array<std::uint32_t, 3>;

/// -0 is 0, so that equal places have equal bits.
Place bits_of(const glm::vec3& p) {
    return {std::bit_cast<std::uint32_t>(p.x + 0.0f), std::bit_cast<std::uint32_t>(p.y + 0.0f),
            std::bit_cast<std::uint32_t>(p.z + 0.0f)};
}

/// The first vertex at each vertex's place.
std::vector<std::uint32_t> representatives(const Positions& positions) {
    std::vector<std::uint32_t> order(positions.size()), first(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return bits_of(positions[i]); });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool is_same = k > 0 && bits_of(positions[order[k]]) == bits_of(positions[order[k - 1]]);
        first[order[k]] = is_same ? first[order[k - 1]] : order[k];
    }
    return first;
}

/// One side of one triangle, its ends in order.
struct DirectedEdge {
    std::uint32_t low, high, triangle;
    auto operator<=>(const DirectedEdge&) const = default;
};

std::vector<DirectedEdge> sides_of(const Scene& scene) {
    const std::vector<std::uint32_t> first = representatives(scene.vertices.position_world);
    std::vector<DirectedEdge> sides;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = first[scene.triangles[t][i]], b = first[scene.triangles[t][(i + 1) % 3]];
            if (a != b) sides.push_back({std::min(a, b), std::max(a, b), std::uint32_t(t)});
        }
    std::ranges::sort(sides);
    return sides;
}

bool is_named_around(const Plane<PrimitiveId>& ids, const glm::dvec2& p, const SceneEdge& edge) {
    const int x = int(std::floor(p.x)), y = int(std::floor(p.y));
    const auto [width, height] = ids.size();
    for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i)
            if (std::ranges::binary_search(edge.triangles, std::uint32_t(ids.at(i, j)))) return true;
    return false;
}

/// The line's pieces, neighbours of one kind joined.
void tell_apart(const WireLine& line, const SceneEdge& edge, const Plane<PrimitiveId>& ids,
                std::vector<WireLine>& told) {
    const int pieces = std::max(1, int(std::ceil(length_of(line.segment))));
    const glm::dvec2 step = (line.segment.b - line.segment.a) / double(pieces);
    for (int i = 0; i < pieces; ++i) {
        const glm::dvec2 from = line.segment.a + double(i) * step, to = from + step;
        const Visibility visibility =
            is_named_around(ids, from + 0.5 * step, edge) ? Visibility::seen : Visibility::hidden;
        if (i > 0 && told.back().visibility == visibility)
            told.back().segment.b = to;
        else
            told.push_back({{from, to}, line.edge, visibility});
    }
}

}  // namespace

std::vector<SceneEdge> edges_of(const Scene& scene) {
    std::vector<SceneEdge> edges;
    for (const DirectedEdge& side : sides_of(scene)) {
        if (edges.empty() || edges.back().from != side.low || edges.back().to != side.high)
            edges.push_back({side.low, side.high, {}});
        std::vector<std::uint32_t>& triangles = edges.back().triangles;
        if (triangles.empty() || triangles.back() != side.triangle) triangles.push_back(side.triangle);
    }
    std::ranges::stable_sort(edges, {}, [](const SceneEdge& edge) { return edge.triangles.front(); });
    return edges;
}

Wireframe wireframe_of(const Scene& scene, const View& view) {
    const Outliner outliner{scene, view};
    const Positions& p = scene.vertices.position_world;
    Wireframe wireframe{edges_of(scene), {}};
    for (std::size_t i = 0; i < wireframe.edges.size(); ++i) {
        const auto whole = outliner.line(p[wireframe.edges[i].from], p[wireframe.edges[i].to]);
        if (!whole) continue;
        if (const auto shown = within(*whole, {0, 0}, {view.width, view.height}))
            wireframe.lines.push_back({*shown, std::uint32_t(i), Visibility::unknown});
    }
    return wireframe;
}

Wireframe split_by_visibility(const Wireframe& wireframe, const Plane<PrimitiveId>& ids) {
    Wireframe told{wireframe.edges, {}};
    for (const WireLine& line : wireframe.lines)
        tell_apart(line, wireframe.edges[line.edge], ids, told.lines);
    return told;
}

}  // namespace zproof::study::projection
