#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"

namespace zproof::suite {

namespace {

void add_table(MeshBuilder& mesh, const glm::dvec3& at) {
    add_box_between(mesh, at + glm::dvec3{-0.8, 0.7, -0.5}, at + glm::dvec3{0.8, 0.76, 0.5});
    for (const double x : {-0.75, 0.69})
        for (const double z : {-0.45, 0.39})
            add_box_between(mesh, at + glm::dvec3{x, 0, z}, at + glm::dvec3{x + 0.06, 0.69, z + 0.06});
}

/// Shelves along the wall x = -4.
void add_shelves(MeshBuilder& mesh, Random& random) {
    for (int shelf = 0; shelf < 5; ++shelf) {
        const double y = 0.4 + 0.45 * shelf;
        add_box_between(mesh, {-3.99, y - 0.03, -2.5}, {-3.6, y - 0.005, 2.5});
        double z = -2.45;
        while (z < 2.3) {  // books
            const double thickness = random.uniform(0.02, 0.08), height = random.uniform(0.2, 0.36);
            add_box_between(mesh, {-3.97, y, z}, {-3.65, y + height, z + thickness});
            z += thickness + random.uniform(0.001, 0.03);
        }
    }
}

void add_lamps(MeshBuilder& mesh) {
    for (const double x : {-2.0, 0.0, 2.0}) {
        add_sphere(mesh, {{x, 2.2, 0}, glm::dmat3(0.18)}, {.across = 32, .down = 20});
        add_box_between(mesh, {x - 0.01, 2.39, -0.01}, {x + 0.01, 2.99, 0.01});
    }
}

}  // namespace

Loaded room(ImageSize size) {
    MeshBuilder mesh("room");
    Random random(20);
    mesh.begin_part("walls", {0.8, 0.78, 0.7});
    add_box_between(mesh, {-4, 0, -3}, {4, 3, 3});
    mesh.begin_part("tables", {0.5, 0.3, 0.15});
    for (const double x : {-1.8, 1.8}) add_table(mesh, {x, 0, -0.8});
    mesh.begin_part("shelves", {0.45, 0.35, 0.3});
    add_shelves(mesh, random);
    mesh.begin_part("lamps", {0.9, 0.9, 0.6});
    add_lamps(mesh);
    mesh.begin_part("on the tables", {0.3, 0.5, 0.6});
    for (const double x : {-1.8, 1.8}) {
        add_torus(mesh, {{x - 0.3, 0.86, -0.8}, random.rotation() * 0.25}, 0.3, {.across = 40, .down = 16});
        add_sphere(mesh, {{x + 0.35, 0.92, -0.7}, glm::dmat3(0.15)}, {.across = 28, .down = 14});
    }
    const Intrinsics intrinsics{.half_height = 0.6, .near_depth = 0.05, .far_depth = 50};
    return mesh.finish(
        {perspective_view("door", size, {.eye_world = {3.6, 1.65, 2.7}, .target_world = {-1.5, 1, -1}},
                          intrinsics),
         perspective_view("floor", size, {.eye_world = {-3.2, 0.15, 2}, .target_world = {2, 0.9, -2}},
                          intrinsics)});
}

}  // namespace zproof::suite
