#include "rasterizer/triangle_setup.h"

#include <algorithm>
#include <utility>

namespace zproof::rasterizer {
namespace {

/// Twice the area on the grid; positive for clockwise (y down). Exact, see guard_band_px.
std::int64_t doubled_area(SnappedPoint a, SnappedPoint b, SnappedPoint c) {
    return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
           (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

PixelRect pixels_within(const Corners& v, const ViewSetup& setup) {
    const auto [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
    return {.x0 = std::max(0, setup.grid.first_pixel_from(x_min)),
            .y0 = std::max(0, setup.grid.first_pixel_from(y_min)),
            .x1 = std::min(setup.size.width, setup.grid.last_pixel_until(x_max) + 1),
            .y1 = std::min(setup.size.height, setup.grid.last_pixel_until(y_max) + 1)};
}

void append_clipped(std::vector<SnappedPiece>& out, const std::array<ClipVertex, 3>& corners,
                    const ViewSetup& setup, PrimitiveId id) {
    const ClipPolygon polygon = clip(corners, setup.volume);
    std::array<SnappedVertex, std::tuple_size_v<decltype(polygon.vertices)>> snapped;
    for (std::size_t i = 0; i < polygon.span().size(); ++i) {
        const auto vertex = setup.snap(polygon.vertices[i]);
        if (!vertex) return;
        snapped[i] = *vertex;
    }
    for (std::size_t i = 2; i < polygon.span().size(); ++i) {
        out.push_back({{snapped[0], snapped[i - 1], snapped[i]}, id});
    }
}

}  // namespace

std::array<EdgeFunction, 3> edges_of(const Corners& v, FillRule rule) noexcept {
    return {edge_between(v[1], v[2], rule), edge_between(v[2], v[0], rule), edge_between(v[0], v[1], rule)};
}

std::optional<Placed> placed(const Corners& corners, const ViewSetup& setup) noexcept {
    const std::int64_t area = doubled_area(corners[0], corners[1], corners[2]);
    const PixelRect pixels = pixels_within(corners, setup);
    if (area == 0 || pixels.is_empty()) return std::nullopt;
    if (setup.facing == Facing::front && area > 0) return std::nullopt;
    Placed triangle{corners, pixels, area < 0};
    if (area < 0) std::swap(triangle.corners[1], triangle.corners[2]);
    return triangle;
}

Remains remains_of(const glm::uvec3& corners, const ProjectedVertices& projected) noexcept {
    const std::uint8_t a = projected.outcode[corners.x];
    const std::uint8_t b = projected.outcode[corners.y];
    const std::uint8_t c = projected.outcode[corners.z];
    if ((a | b | c) & outcode::not_finite || (a & b & c & outcode::invisible)) return Remains::nothing;
    return (a | b | c) & outcode::needs_clip ? Remains::cut : Remains::whole;
}

void append_pieces(std::vector<SnappedPiece>& out, const Scene& scene, const ViewSetup& setup,
                   std::uint32_t triangle) {
    const glm::uvec3 index = scene.triangles[triangle];
    const PrimitiveId id{triangle};
    const auto corner = [&](std::uint32_t i) {
        return setup.clip_from_world(scene.vertices.position_world[i]);
    };
    append_clipped(out, {corner(index.x), corner(index.y), corner(index.z)}, setup, id);
}

}  // namespace zproof::rasterizer
