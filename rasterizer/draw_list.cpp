#include "rasterizer/draw_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "math/rounding.h"
#include "rasterizer/projection.h"

namespace zproof::rasterizer {
namespace {

constexpr std::uint32_t chunk_length = 1024;

bool is_finite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

Chunk chunk_of(const Scene& scene, IndexRange triangles) {
    const auto& p = scene.vertices.position_world;
    const std::uint32_t any = scene.triangles[triangles.begin].x;
    Chunk chunk{triangles, {any, any + 1}, p[any], p[any], is_finite(p[any])};
    for (std::uint32_t t = triangles.begin; t < triangles.end; ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t v = scene.triangles[t][k];
            chunk.vertices = {std::min(chunk.vertices.begin, v), std::max(chunk.vertices.end, v + 1)};
            chunk.low = glm::min(chunk.low, p[v]);
            chunk.high = glm::max(chunk.high, p[v]);
            chunk.is_finite = chunk.is_finite && is_finite(p[v]);
        }
    return chunk;
}

std::array<glm::vec3, 8> corners_of(const Chunk& chunk) {
    std::array<glm::vec3, 8> corners;
    for (unsigned i = 0; i < 8; ++i)
        corners[i] = {i & 1 ? chunk.high.x : chunk.low.x, i & 2 ? chunk.high.y : chunk.low.y,
                      i & 4 ? chunk.high.z : chunk.low.z};
    return corners;
}

/// A plane as a function of position that is positive outside, and the sum of its terms' magnitudes.
struct Outside {
    glm::dvec4 row{0};

    double at(const glm::vec3& p) const { return row.x * p.x + row.y * p.y + row.z * p.z + row.w; }
    double size_at(const glm::vec3& p) const {
        return std::abs(row.x * p.x) + std::abs(row.y * p.y) + std::abs(row.z * p.z) + std::abs(row.w);
    }
    /// All of the box, by more than 16 roundings of the largest sum (as bounds.md has it: 13 of the transform
    /// and 3 of the comparison with w).
    bool holds(const std::array<glm::vec3, 8>& corners) const {
        double least = at(corners[0]), size = 0;
        for (const glm::vec3& p : corners) {
            least = std::min(least, at(p));
            size = std::max(size, size_at(p));
        }
        return least > gamma(16, unit_roundoff_float64) * size;
    }
};

glm::dvec4 row_of(const glm::dmat4& m, int i) { return {m[0][i], m[1][i], m[2][i], m[3][i]}; }

/// -x - w > 0 is left of the window, and so on; near and far in camera depth.
std::vector<Outside> planes_of(const Camera& camera) {
    const glm::dmat4 from_world = camera_from_world(camera);
    const glm::dmat4 clip = clip_from_camera(camera) * from_world;
    const glm::dvec4 depth = -row_of(from_world, 2), x = row_of(clip, 0), y = row_of(clip, 1);
    const glm::dvec4 w = camera.projection == Projection::perspective ? depth : glm::dvec4{0, 0, 0, 1};
    std::vector<Outside> planes{{-x - w}, {x - w}, {-y - w}, {y - w}};
    planes.push_back({glm::dvec4{0, 0, 0, camera.near_depth} - depth});
    if (std::isfinite(camera.far_depth)) planes.push_back({depth - glm::dvec4{0, 0, 0, camera.far_depth}});
    return planes;
}

bool is_outside(const Chunk& chunk, const std::vector<Outside>& planes) {
    if (!chunk.is_finite) return false;
    const auto corners = corners_of(chunk);
    return std::ranges::any_of(planes, [&](const Outside& plane) { return plane.holds(corners); });
}

double nearest_depth(const Chunk& chunk, const glm::dvec4& depth) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::vec3& p : corners_of(chunk)) nearest = std::min(nearest, Outside{depth}.at(p));
    return nearest;
}

/// Rising, overlaps made one.
std::vector<IndexRange> united(std::vector<IndexRange> ranges) {
    std::ranges::sort(ranges, {}, &IndexRange::begin);
    std::vector<IndexRange> whole;
    for (const IndexRange& range : ranges) {
        if (!whole.empty() && range.begin <= whole.back().end)
            whole.back().end = std::max(whole.back().end, range.end);
        else
            whole.push_back(range);
    }
    return whole;
}

}  // namespace

std::vector<Chunk> chunks_of(const Scene& scene) {
    std::vector<Chunk> chunks;
    const auto add = [&](std::uint32_t begin, std::uint32_t end) {
        for (; begin < end; begin += chunk_length)
            chunks.push_back(chunk_of(scene, {begin, std::min(end, begin + chunk_length)}));
    };
    for (const Part& part : scene.parts) add(part.first_triangle, part.first_triangle + part.triangle_count);
    if (scene.parts.empty()) add(0, std::uint32_t(scene.triangles.size()));
    return chunks;
}

bool need_chunks(const Optimizations& optimizations) {
    return optimizations.frustum_culling == FrustumCulling::chunks ||
           optimizations.order == DrawOrder::chunks_front_to_back;
}

DrawList draw_list(const std::vector<Chunk>& chunks, const View& view, const Optimizations& optimizations) {
    std::vector<const Chunk*> kept;
    const std::vector<Outside> planes = planes_of(view.camera);
    for (const Chunk& chunk : chunks)
        if (optimizations.frustum_culling == FrustumCulling::triangles || !is_outside(chunk, planes))
            kept.push_back(&chunk);
    if (optimizations.order == DrawOrder::chunks_front_to_back) {
        const glm::dvec4 depth = -row_of(camera_from_world(view.camera), 2);
        std::vector<std::pair<double, const Chunk*>> by_depth;
        for (const Chunk* chunk : kept) by_depth.push_back({nearest_depth(*chunk, depth), chunk});
        std::ranges::stable_sort(by_depth, {}, &std::pair<double, const Chunk*>::first);
        std::ranges::transform(by_depth, kept.begin(), &std::pair<double, const Chunk*>::second);
    }
    DrawList list;
    list.culled = chunks.size() - kept.size();
    for (const Chunk* chunk : kept) {
        list.triangles.push_back(chunk->triangles);
        list.vertices.push_back(chunk->vertices);
    }
    list.vertices = united(std::move(list.vertices));
    return list;
}

}  // namespace zproof::rasterizer
