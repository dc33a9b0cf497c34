#include <cmath>

#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"

namespace zproof::suite {

namespace {

/// A plane: p = origin + x * across + y * up.
struct Sheet {
    glm::dvec3 origin, across, up;
    glm::dvec3 at(double x, double y) const { return origin + x * across + y * up; }
};

void add_poster(MeshBuilder& mesh, const Sheet& sheet, const glm::dvec2& low, const glm::dvec2& high) {
    mesh.lone_quad(
        {sheet.at(low.x, low.y), sheet.at(high.x, low.y), sheet.at(high.x, high.y), sheet.at(low.x, high.y)});
}

/// Posters that overlap one another and the wall, all in one plane.
void add_posters(MeshBuilder& mesh, Random& random, const Sheet& sheet, const std::string& node) {
    mesh.begin_part(node, random.color());
    add_poster(mesh, sheet, {-8, -4}, {8, 4});
    for (int part = 0; part < 3; ++part) {
        mesh.begin_part(node + " posters " + std::to_string(part), random.color());
        for (int i = 0; i < 12; ++i) {
            const glm::dvec2 low{random.uniform(-7, 5), random.uniform(-3.5, 2)};
            const glm::dvec2 extent{random.uniform(0.5, 3), random.uniform(0.5, 2)};
            add_poster(mesh, sheet, low, low + extent);
        }
    }
}

/// A sheet and another that crosses it in a vertical line at an angle of slope 2^-k.
void add_crossing(MeshBuilder& mesh, const Sheet& flat, int k) {
    add_poster(mesh, flat, {-1, -1}, {1, 1});
    const Sheet turned{flat.origin, flat.across + glm::dvec3{0, 0, std::ldexp(1.0, -k)}, flat.up};
    add_poster(mesh, turned, {-0.9, -0.9}, {0.9, 0.9});
}

}  // namespace

Loaded coplanar(ImageSize size) {
    MeshBuilder mesh("coplanar");
    Random random(7);
    add_posters(mesh, random, {{0, 3, -16}, {1, 0, 0}, {0, 1, 0}}, "wall");
    add_posters(mesh, random, {{0, -4, -10}, {1, 0.03, 0.1}, {0.05, 0.15, -1.4}}, "ramp");
    mesh.begin_part("twice", {0.8, 0.8, 0.2});
    for (int i = 0; i < 2; ++i)
        add_sheet(mesh, {.across = 12, .down = 12}, [](double s, double t) {
            return glm::dvec3{3 * s + 4, 3 * t - 2, -9 - 2 * s * t};
        });
    return mesh.finish(
        {perspective_view("ahead", size, {}, {.half_height = 0.5, .near_depth = 0.5, .far_depth = 100}),
         perspective_view("aside", size, {.eye_world = {-9, 2.5, 1}, .target_world = {1, 0, -13}},
                          {.half_height = 0.5, .near_depth = 0.5, .far_depth = 100})});
}

Loaded interpenetrating(ImageSize size) {
    MeshBuilder mesh("interpenetrating");
    Random random(9);
    mesh.begin_part("pairs", {0.75, 0.7, 0.5});
    for (int k = 0; k < 24; ++k) {
        const int column = k % 8, row = k / 8;
        add_crossing(mesh, {{2.5 * column - 8.75, 2.5 * row - 2.5, -14}, {1, 0, 0.25}, {0, 1, 0.125}}, k);
    }
    for (int part = 0; part < 4; ++part) {
        mesh.begin_part("knot " + std::to_string(part), random.color());
        for (int i = 0; i < 60; ++i) {
            const glm::dvec3 hub = random.in_box(glm::dvec3{-14, -8, -32}, glm::dvec3{14, 8, -18});
            const glm::dvec3 a = 6.0 * random.direction(), b = 6.0 * random.direction();
            mesh.lone_triangle({hub + a, hub + b, hub - a - b});
        }
    }
    mesh.begin_part("linked rings", {0.6, 0.2, 0.3});
    for (int i = 0; i < 6; ++i) {
        const glm::dmat3 axes = random.rotation();
        add_torus(mesh, {{3.0 * i - 7.5, 0.3 * i, -17}, axes * 2.0}, 0.25, {.across = 96, .down = 24});
    }
    mesh.begin_part("facing pairs", {0.4, 0.7, 0.5});
    for (int i = 0; i < 8; ++i) add_crossing(mesh, {{2.5 * i - 8.75, 5, -14}, {1, 0, 0}, {0, 1, 0}}, 12 + i);
    return mesh.finish(
        {perspective_view("ahead", size, {}, {.half_height = 0.45, .near_depth = 0.5, .far_depth = 100}),
         perspective_view("aside", size, {.eye_world = {18, 7, -2}, .target_world = {0, 0, -20}},
                          {.half_height = 0.45, .near_depth = 0.5, .far_depth = 100})});
}

}  // namespace zproof::suite
