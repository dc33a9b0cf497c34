/// From primitives to triangles: indices, ids, the vertex cache, clipping.
#pragma once

#include "tests/mutants/plain/clip.h"
#include "tests/mutants/plain/vertex_cache.h"

namespace plain {

/// draw(a, b, c, id) gets each piece that clipping leaves, in pixels.
template <class Real, class Draw>
void draw_polygon(const Polygon<Real>& polygon, const Camera& camera, std::uint32_t id, Draw draw) {
    for (int i = 2; i < polygon.size; ++i)
        draw(raster_vertex(polygon.corners[0], camera),
             raster_vertex(polygon.corners[std::size_t(i - 1)], camera),
             raster_vertex(polygon.corners[std::size_t(i)], camera), id);
}

template <class Real, class Draw>
void assemble(const Mesh& mesh, const Camera& camera, DepthBuffer buffer, Draw draw) {
    const Projector<Real> projector(camera, buffer);
    std::uint32_t id = 0;
    for (const Primitive& primitive : mesh) {
        VertexCache<Real> vertices(primitive.positions, projector);
        for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3, ++id) {
            Polygon<Real> triangle;
            for (std::size_t k = 0; k < 3; ++k) triangle.add(vertices[primitive.indices[i + k]]);
            draw_polygon(clipped(triangle, camera), camera, id, draw);
        }
    }
}

}  // namespace plain
