// CGAL's tree of boxes before the judge (docs/gallery.md), package libcgal-dev.
//
//     g++ -O2 -std=c++17 -frounding-math -I examples/contract examples/gallery/cgal_render.cpp -lgmp -lmpfr
//         -o cgal_render
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <iterator>
#include <vector>

#include "zproof_contract.h"

using namespace zproof_contract;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

/// The triangles that have an area, since CGAL's tests ask for one, with the place of each in the scene.
struct Mesh {
    Triangles triangles;
    std::vector<std::size_t> places;
};

Kernel::Point_3 point(Vec3 p) { return {p.x, p.y, p.z}; }

/// Of all triangles that the ray's part between near and far meets, the nearest.
void look(Frame& frame, int x, int y, const Tree& tree, const Mesh& mesh, const Camera& camera) {
    const Ray ray = camera.ray(x, y);
    const auto end = [&](double depth) { return point(ray.origin + depth * ray.direction); };
    std::vector<Tree::Intersection_and_primitive_id<Kernel::Segment_3>::Type> hits;
    const double far = std::isfinite(camera.far) ? camera.far : 1e9;
    tree.all_intersections(Kernel::Segment_3(end(camera.near), end(far)), std::back_inserter(hits));
    double nearest = infinity;
    for (const auto& [where, triangle] : hits) {
        const auto* p = boost::get<Kernel::Point_3>(&where);
        if (!p) continue;  // seen edge-on
        const double depth = -dot(camera.back, Vec3{p->x(), p->y(), p->z()} - camera.eye);
        if (depth >= nearest) continue;
        nearest = depth;
        frame.set(x, y, mesh.places[std::size_t(triangle - mesh.triangles.begin())], depth);
    }
}

Frame render(const std::vector<Triangle>& corners, const Camera& camera) {
    Mesh mesh;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Kernel::Triangle_3 t(point(corners[i][0]), point(corners[i][1]), point(corners[i][2]));
        if (t.is_degenerate()) continue;
        mesh.triangles.push_back(t);
        mesh.places.push_back(i);
    }
    const Tree tree(mesh.triangles.cbegin(), mesh.triangles.cend());
    Frame frame(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) look(frame, x, y, tree, mesh, camera);
    return frame;
}

}  // namespace

int main(int argc, char** argv) { return run(argc, argv, render); }
