#include "rasterizer/triangle_setup.h"

#include <algorithm>
#include <utility>

namespace zproof::rasterizer {
namespace {

/// Twice the area on the grid; positive for clockwise (y down). Exact, see guard_band_px.
std::int64_t doubled_area(SnappedPoint a, SnappedPoint b, SnappedPoint c) { return edge_between(a, b).at(c); }

void append_oriented(std::vector<SnappedTriangle>& out, SnappedTriangle triangle, const ViewSetup& setup) {
    auto& v = triangle.vertex;
    const std::int64_t area = doubled_area(v[0].p, v[1].p, v[2].p);
    if (area == 0 || pixels_within(triangle, setup).is_empty()) return;
    if (area < 0) std::swap(v[1], v[2]);
    out.push_back(triangle);
}

void append_clipped(std::vector<SnappedTriangle>& out, const std::array<ClipVertex, 3>& corners,
                    const ViewSetup& setup, PrimitiveId id) {
    const ClipPolygon polygon = clip(corners, setup.volume);
    std::array<SnappedVertex, std::tuple_size_v<decltype(polygon.vertices)>> snapped;
    for (std::size_t i = 0; i < polygon.span().size(); ++i) {
        const auto vertex = setup.snap(polygon.vertices[i]);
        if (!vertex) return;
        snapped[i] = *vertex;
    }
    for (std::size_t i = 2; i < polygon.span().size(); ++i) {
        append_oriented(out, {{snapped[0], snapped[i - 1], snapped[i]}, id}, setup);
    }
}

}  // namespace

std::array<EdgeFunction, 3> edges_of(const SnappedTriangle& triangle, FillRule rule) noexcept {
    const auto& [v0, v1, v2] = triangle.vertex;
    return {edge_between(v1.p, v2.p, rule), edge_between(v2.p, v0.p, rule), edge_between(v0.p, v1.p, rule)};
}

PixelRect pixels_within(const SnappedTriangle& triangle, const ViewSetup& setup) noexcept {
    const auto& [v0, v1, v2] = triangle.vertex;
    const auto [x_min, x_max] = std::minmax({v0.p.x, v1.p.x, v2.p.x});
    const auto [y_min, y_max] = std::minmax({v0.p.y, v1.p.y, v2.p.y});
    return {.x0 = std::max(0, setup.grid.first_pixel_from(x_min)),
            .y0 = std::max(0, setup.grid.first_pixel_from(y_min)),
            .x1 = std::min(setup.size.width, setup.grid.last_pixel_until(x_max) + 1),
            .y1 = std::min(setup.size.height, setup.grid.last_pixel_until(y_max) + 1)};
}

void append_snapped(std::vector<SnappedTriangle>& out, const Scene& scene, const ProjectedVertices& projected,
                    const ViewSetup& setup, std::uint32_t triangle) {
    const glm::uvec3 index = scene.triangles[triangle];
    const std::uint8_t a = projected.outcode[index.x];
    const std::uint8_t b = projected.outcode[index.y];
    const std::uint8_t c = projected.outcode[index.z];
    if ((a | b | c) & outcode::not_finite || (a & b & c & outcode::invisible)) return;
    const PrimitiveId id{triangle};
    if ((a | b | c) & outcode::needs_clip) {
        const auto corner = [&](std::uint32_t i) {
            return setup.clip_from_world(scene.vertices.position_world[i]);
        };
        append_clipped(out, {corner(index.x), corner(index.y), corner(index.z)}, setup, id);
        return;
    }
    const auto& snapped = projected.snapped;
    append_oriented(out, {{snapped[index.x], snapped[index.y], snapped[index.z]}, id}, setup);
}

}  // namespace zproof::rasterizer
