#include <algorithm>
#include <vector>

#include "scenes/shrink/attempts.h"

namespace zproof::shrinking {
namespace {

constexpr std::uint32_t unused = 0xFFFF'FFFF;

/// Vertices that triangles use, in their order.
void drop_unused_vertices(Scene& scene) {
    const Positions old = std::move(scene.vertices.position_world);
    std::vector<std::uint32_t> place(old.size(), unused);
    for (const glm::uvec3& corners : scene.triangles)
        for (int i = 0; i < 3; ++i) place[corners[i]] = 0;
    Positions kept;
    for (std::size_t v = 0; v < old.size(); ++v)
        if (place[v] != unused) {
            place[v] = std::uint32_t(kept.size());
            kept.push_back(old[v]);
        }
    for (glm::uvec3& corners : scene.triangles)
        for (int i = 0; i < 3; ++i) corners[i] = place[corners[i]];
    scene.vertices.position_world = std::move(kept);
}

/// Without the triangles [first, first + count), and without parts that have none.
Scene without_triangles(const Scene& scene, std::uint32_t first, std::uint32_t count) {
    Scene rest = scene;
    const auto begin = rest.triangles.begin() + first;
    rest.triangles.erase(begin, begin + count);
    for (Part& part : rest.parts) {
        const std::uint32_t end = part.first_triangle + part.triangle_count;
        const auto moved = [&](std::uint32_t at) {
            return at <= first ? at : std::max(first, at > first + count ? at - count : first);
        };
        part.triangle_count = moved(end) - moved(part.first_triangle);
        part.first_triangle = moved(part.first_triangle);
    }
    std::erase_if(rest.parts, [](const Part& part) { return part.triangle_count == 0; });
    drop_unused_vertices(rest);
    return rest;
}

}  // namespace

/// Half of them, a quarter, and so on, then one by one (delta debugging, Zeller and Hildebrandt 2002, without
/// its complements: what is left out once stays out).
void drop_triangles(Attempts& attempts) {
    const auto count = [&] { return std::uint32_t(attempts.least().scene.triangles.size()); };
    for (std::uint32_t share = std::max(1u, count() / 2); share >= 1; share /= 2)
        for (std::uint32_t first = 0; first < count() && count() > 1 && !attempts.are_over();) {
            const std::uint32_t dropped = std::min({share, count() - first, count() - 1});
            const Scene& scene = attempts.least().scene;
            if (!attempts.keep({without_triangles(scene, first, dropped), attempts.least().view}))
                first += share;
        }
}

}  // namespace zproof::shrinking
