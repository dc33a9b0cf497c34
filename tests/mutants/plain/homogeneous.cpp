#include <algorithm>

#include "tests/mutants/plain/assembly.h"
#include "tests/mutants/plain/methods.h"
#include "tests/mutants/plain/target.h"

namespace plain {
namespace {

using Point = Vec3<double>;

/// A corner as (x, y, depth) in units of the image plane; (x, y, 1) in parallel views.
struct PlaneCorner {
    Point place;
    double depth;
};

/// A triangle's edge functions n . (u, v, 1), above 0 inside.
struct EdgeNormals {
    std::array<Point, 3> normals;  ///< opposite to each corner
    double determinant;
};

PlaneCorner corner_of(const Vec3<float>& position, const Camera& camera) {
    const Point p = rounded<double>(position) - rounded<double>(camera.eye);
    const double x = dot(camera.right, p), y = dot(camera.up, p), depth = -dot(camera.back, p);
    if (camera.projection == Projection::perspective) return {{x, y, depth}, depth};
    return {{x - camera.shear_x * depth, y - camera.shear_y * depth, 1}, depth};
}

EdgeNormals normals_of(const std::array<PlaneCorner, 3>& c) {
    EdgeNormals edges{
        {cross(c[1].place, c[2].place), cross(c[2].place, c[0].place), cross(c[0].place, c[1].place)}, 0};
    edges.determinant = dot(c[0].place, edges.normals[0]);
    if (edges.determinant >= 0) return edges;
    edges.determinant = -edges.determinant;
    for (Point& n : edges.normals) n = -1.0 * n;
    return edges;
}

bool covers(const Point& n, double e) { return e > 0 || (e == 0 && (n[0] > 0 || (n[0] == 0 && n[1] < 0))); }

/// 1 / depth, or minus depth in parallel views.
double inverse_depth(const Point& e, const EdgeNormals& edges, const std::array<PlaneCorner, 3>& c,
                     Projection projection) {
    if (projection == Projection::perspective) return (e[0] + e[1] + e[2]) / edges.determinant;
    return -(e[0] * c[0].depth + e[1] * c[1].depth + e[2] * c[2].depth) / edges.determinant;
}

bool is_between_planes(double inverse, const Camera& camera) {
    if (camera.projection == Projection::parallel) return -inverse >= camera.near && -inverse <= camera.far;
    return inverse > 0 && 1 / inverse >= camera.near && 1 / inverse <= camera.far;
}

/// Of the visible part, a pixel wider on each side than it need be.
template <class Draw>
void within_bounds(const Polygon<double>& visible, const Camera& camera, Draw draw) {
    if (visible.size == 0) return;
    double x_low = camera.width, x_high = 0, y_low = camera.height, y_high = 0;
    for (int i = 0; i < visible.size; ++i) {
        const auto corner = raster_vertex(visible.corners[std::size_t(i)], camera);
        x_low = std::min(x_low, corner.x), x_high = std::max(x_high, corner.x);
        y_low = std::min(y_low, corner.y), y_high = std::max(y_high, corner.y);
    }
    const int x_last = std::min(camera.width - 1, int(x_high) + 1);
    const int y_last = std::min(camera.height - 1, int(y_high) + 1);
    for (int y = std::max(0, int(y_low) - 1); y <= y_last; ++y)
        for (int x = std::max(0, int(x_low) - 1); x <= x_last; ++x) draw(x, y);
}

void draw_triangle_by_normals(const std::array<Vec3<float>, 3>& positions, std::uint32_t id,
                              const Projector<double>& projector, const Camera& camera, Target& target) {
    std::array<PlaneCorner, 3> corners;
    Polygon<double> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = corner_of(positions[i], camera);
        triangle.add(projector(positions[i]));
    }
    const EdgeNormals edges = normals_of(corners);
    if (!(edges.determinant > 0)) return;
    within_bounds(clipped(triangle, camera), camera, [&](int x, int y) {
        const Point at{camera.u(x), camera.v(y), 1};
        const Point e{dot(edges.normals[0], at), dot(edges.normals[1], at), dot(edges.normals[2], at)};
        if (!covers(edges.normals[0], e[0]) || !covers(edges.normals[1], e[1]) ||
            !covers(edges.normals[2], e[2]))
            return;
        const double inverse = inverse_depth(e, edges, corners, camera.projection);
        if (is_between_planes(inverse, camera)) target.draw(x, y, float(inverse), id);
    });
}

}  // namespace

Picture draw_homogeneous(const Mesh& mesh, const Camera& camera) {
    Target target(camera, DepthBuffer::camera_depth);
    const Projector<double> projector(camera, DepthBuffer::camera_depth);
    std::uint32_t id = 0;
    for (const Primitive& primitive : mesh)
        for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3, ++id)
            draw_triangle_by_normals(
                {primitive.positions[primitive.indices[i]], primitive.positions[primitive.indices[i + 1]],
                 primitive.positions[primitive.indices[i + 2]]},
                id, projector, camera, target);
    return target.finished();
}

}  // namespace plain
