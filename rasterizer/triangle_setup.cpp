#include "rasterizer/triangle_setup.h"

namespace zproof::rasterizer {
namespace {

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
