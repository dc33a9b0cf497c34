#include <cmath>

#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::suite {

namespace {

/// A triangle of the given plane around p_world whose corners lie at least `reach` away in three directions.
void add_giant(MeshBuilder& mesh, Random& random, const glm::dvec3& p_world, double reach) {
    const glm::dmat3 axes = random.rotation();
    const double a = random.uniform(1, 3), b = random.uniform(1, 3), c = random.uniform(1, 3);
    mesh.lone_triangle({p_world + reach * a * axes[0],
                        p_world + reach * b * (-0.5 * axes[0] + 0.875 * axes[1]),
                        p_world + reach * c * (-0.5 * axes[0] - 0.875 * axes[1])});
}

/// A triangle through p_world, up to 3 reach long on either side of it and a twentieth to a tenth as wide.
void add_beam(MeshBuilder& mesh, Random& random, const glm::dvec3& p_world, double reach) {
    const glm::dmat3 axes = random.rotation();
    const double ahead = random.uniform(1, 3), behind = random.uniform(1, 3);
    mesh.lone_triangle({p_world + reach * ahead * axes[0],
                        p_world - reach * (behind * axes[0] + 0.15 * axes[1]),
                        p_world - reach * (behind * axes[0] - 0.15 * axes[1])});
}

/// A point of the border of the window |u| < aspect / 2, |v| < 1 / 2, at camera depth 1.
glm::dvec2 on_border(Random& random, ImageSize size) {
    const double u = 0.5 * size.aspect(), along = random.uniform(-1, 1);
    switch (random.integer(0, 3)) {
        case 0:
            return {-u, 0.5 * along};
        case 1:
            return {u, 0.5 * along};
        case 2:
            return {u * along, -0.5};
        default:
            return {u * along, 0.5};
    }
}

/// A blade with its tip ahead of the plane z = -1 and its root behind it, some of them behind the eye at the
/// origin; the plane cuts it within the window |x| < 0.9, |y| < 0.5.
void add_blade(MeshBuilder& mesh, Random& random) {
    const glm::dvec3 middle{random.uniform(-0.85, 0.85), random.uniform(-0.48, 0.48), -1};
    const glm::dvec3 half_cut{random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), 0};
    const double tip_depth = random.uniform(1.2, 6), root_depth = random.uniform(-6, 0.9);
    const double sideways = 0.05 * (tip_depth - 1);
    const glm::dvec3 tip{middle.x * tip_depth + random.uniform(-sideways, sideways),
                         middle.y * tip_depth + random.uniform(-sideways, sideways), -tip_depth};
    const double stretch = (tip_depth - root_depth) / (tip_depth - 1);
    mesh.lone_triangle(
        {tip, tip + stretch * (middle - half_cut - tip), tip + stretch * (middle + half_cut - tip)});
}

/// A wedge with its tip and its base 4e5 units off to either side of p_world, almost in the plane of constant
/// depth there: it stays between near and far, and its corners lie millions of pixels beside the image.
void add_wedge(MeshBuilder& mesh, Random& random, const glm::dvec3& p_world) {
    const glm::dvec2 direction = unit_circle(random.uniform(0, 1));
    const glm::dvec3 along{4e5 * direction, random.uniform(-0.2, 0.2)};
    const glm::dvec3 across{random.uniform(0.2, 2) * glm::dvec2(-direction.y, direction.x), 0};
    mesh.lone_triangle({p_world - along, p_world + along - across, p_world + along + across});
}

/// The z of a point at the next float32 depth from `depth` down whose 1 / depth lies just above half way
/// between two float32: who rounds it is wrong by a unit roundoff, and upwards. Depths lie in (4, 8), so that
/// both step evenly.
double half_way(double depth) {
    const auto step_share = [](double inverse_depth) {
        return inverse_depth * 0x1p26 - std::floor(inverse_depth * 0x1p26);
    };
    depth = std::floor(depth * 0x1p21) * 0x1p-21;
    while (step_share(1 / depth) < 0.5 || step_share(1 / depth) > 0.503) depth -= 0x1p-21;
    return -depth;
}

}  // namespace

Loaded near_plane(ImageSize size) {
    MeshBuilder mesh("near_plane");
    Random random(1);
    mesh.begin_part("floor", {0.4, 0.4, 0.35});
    mesh.lone_quad({{{-3000, -90.4, 3000}, {3000, -30.4, 3000}, {3000, 89.6, -3000}, {-3000, 29.6, -3000}}});
    mesh.begin_part("through the near plane", {0.8, 0.3, 0.2});
    for (int i = 0; i < 14; ++i) {
        const glm::dvec3 p_world{random.uniform(-0.8, 0.8), random.uniform(-0.45, 0.45), -1};
        add_beam(mesh, random, p_world, random.uniform(0.4, 4));
    }
    mesh.begin_part("through the sides", {0.2, 0.4, 0.8});
    for (int i = 0; i < 48; ++i) {
        const double depth = random.uniform(4, 400);
        const glm::dvec2 p = depth * on_border(random, size);
        add_giant(mesh, random, {p.x, p.y, -depth}, 0.1 * depth);
    }
    mesh.begin_part("through the far plane", {0.3, 0.7, 0.3});
    for (int i = 0; i < 16; ++i)
        add_giant(mesh, random, {random.uniform(-1600, 1600), random.uniform(100, 900), -2000}, 150);
    return mesh.finish(
        {perspective_view("ahead", size, {}, {.half_height = 0.5, .near_depth = 1, .far_depth = 2000}),
         perspective_view("aside", size, {.target_world = {1, 0.1, -0.2}},
                          {.half_height = 1, .near_depth = 0.5, .far_depth = 1500})});
}

Loaded guard_band(ImageSize size) {
    MeshBuilder mesh("guard_band");
    Random random(22);
    mesh.begin_part("beyond the guard band", {0.7, 0.6, 0.2});
    for (int i = 0; i < 120; ++i) {
        const double depth = 16 * random.uniform(1, 1.02);
        add_wedge(mesh, random, {random.uniform(-12, 12), random.uniform(-7, 7), -depth});
    }
    mesh.begin_part("in the near plane", {0.3, 0.5, 0.8});
    constexpr double half = 0.15,
                     lean = 3e-6;  // of depth 1: seven float32 steps leave it by a hundred pixels
    mesh.lone_quad({{{-half, -half, -1 + lean},
                     {half, -half, -1 - lean},
                     {half, half, -1 - lean},
                     {-half, half, -1 + lean}}});
    mesh.begin_part("in float32's last step", {0.4, 0.7, 0.4});
    for (const double x : {-5.0, -2.5})
        mesh.lone_triangle(
            {{{x, 1.9, half_way(7.99)}, {x + 2, 1.9, half_way(7.9895)}, {x, 3.4, half_way(7.9893)}}});
    return mesh.finish(
        {perspective_view("ahead", size, {}, {.half_height = 0.5, .near_depth = 1, .far_depth = 100}),
         parallel_view("parallel", size, {}, {.half_height = 8, .near_depth = 1, .far_depth = 100})});
}

Loaded clip_blades(ImageSize size) {
    MeshBuilder mesh("clip_blades");
    Random random(2);
    for (const char* node : {"blades", "more blades", "still more blades"}) {
        mesh.begin_part(node, random.color());
        for (int i = 0; i < 500; ++i) add_blade(mesh, random);
    }
    return mesh.finish(
        {perspective_view("near", size, {}, {.half_height = 0.5, .near_depth = 1, .far_depth = 100}),
         perspective_view("far", size, {.eye_world = {0, 0, -12}, .target_world = {0, 0, 0}},
                          {.half_height = 0.05, .near_depth = 0.01, .far_depth = 11})});
}

}  // namespace zproof::suite
