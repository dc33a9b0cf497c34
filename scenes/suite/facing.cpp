#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::suite {

namespace {

/// An open bowl: the lower three quarters of the unit sphere, seen from inside and outside.
void add_bowl(MeshBuilder& mesh, const Placement& placement) {
    add_sheet(mesh, {.across = 48, .down = 16}, [&](double s, double t) {
        const glm::dvec2 around = unit_circle(s), polar = unit_circle(0.125 + 0.37 * t);
        return placement.centre +
               placement.axes * glm::dvec3{polar.y * around.x, polar.x, -polar.y * around.y};
    });
}

}  // namespace

Loaded back_faces(ImageSize size) {
    MeshBuilder mesh("back_faces");
    Random random(14);
    const glm::dmat3 mirror(glm::dvec3{-1, 0, 0}, glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1});
    for (int i = 0; i < 12; ++i) {
        const glm::dmat3 axes = random.rotation();
        const int column = i % 6, row = i / 6;
        const double x = 2.4 * column - 6, y = 2.6 * row - 2.6;
        mesh.begin_part("bowl " + std::to_string(i), random.color());
        add_bowl(mesh, {{x, y, -11}, axes});
        mesh.begin_part("mirrored bowl " + std::to_string(i), random.color());
        add_bowl(mesh, {{-x, y + 0.4, -14}, axes * mirror});
    }
    mesh.begin_part("cards", {0.7, 0.7, 0.3});
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 p = random.in_box(glm::dvec3{-9, -5, -17}, glm::dvec3{9, 5, -8});
        const glm::dmat3 axes = random.rotation();
        mesh.lone_triangle({p + axes[0], p - 0.5 * axes[0] + axes[1], p - 0.5 * axes[0] - axes[1]});
    }
    return mesh.finish(
        {perspective_view("ahead", size, {}, {.half_height = 0.45, .near_depth = 0.5, .far_depth = 100}),
         perspective_view("behind", size, {.eye_world = {1, 2, -26}, .target_world = {0, 0, -12}},
                          {.half_height = 0.45, .near_depth = 0.5, .far_depth = 100})});
}

Loaded closed_surfaces(ImageSize size) {
    MeshBuilder mesh("closed_surfaces");
    Random random(15);
    mesh.begin_part("balls", {0.8, 0.75, 0.7});
    for (int i = 0; i < 24; ++i) {
        const glm::dvec3 p = random.in_box(glm::dvec3{-12, -7, -30}, glm::dvec3{12, 7, -12});
        const glm::dmat3 axes = random.rotation();
        const double radius = random.uniform(0.5, 2.5);
        add_sphere(mesh, {p, axes * radius}, {.across = 8 + 6 * i, .down = 4 + 3 * i});
    }
    mesh.begin_part("rings", {0.5, 0.6, 0.8});
    for (int i = 0; i < 16; ++i) {
        const glm::dvec3 p = random.in_box(glm::dvec3{-10, -6, -28}, glm::dvec3{10, 6, -12});
        const glm::dmat3 axes = random.rotation();
        add_torus(mesh, {p, axes * 2.0}, random.uniform(0.05, 0.6),
                  {.across = 12 + 12 * i, .down = 6 + 3 * i});
    }
    mesh.begin_part("blocks", {0.5, 0.7, 0.5});
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 p = random.in_box(glm::dvec3{-12, -7, -30}, glm::dvec3{12, 7, -12});
        add_box(mesh, {p, random.rotation() * 0.5});
    }
    return mesh.finish(
        {perspective_view("ahead", size, {}, {.half_height = 0.42, .near_depth = 0.5, .far_depth = 100}),
         perspective_view("above", size,
                          {.eye_world = {2, 24, -14}, .target_world = {0, 0, -20}, .up_world = {0, 0.2, -1}},
                          {.half_height = 0.42, .near_depth = 0.5, .far_depth = 100})});
}

}  // namespace zproof::suite
