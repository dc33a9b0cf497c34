#include <cmath>

#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"

namespace zproof::suite {

namespace {

double smooth(double t) { return t * t * (3 - 2 * t); }

/// Value noise in [0, 1], smooth between random lattice values.
double noise(double x, double y, std::uint64_t seed) {
    const double floor_x = std::floor(x), floor_y = std::floor(y);
    const int i = static_cast<int>(floor_x), j = static_cast<int>(floor_y);
    const double s = smooth(x - floor_x), t = smooth(y - floor_y);
    const auto mix = [](double a, double b, double weight) { return a + (b - a) * weight; };
    return mix(mix(lattice_value(i, j, seed), lattice_value(i + 1, j, seed), s),
               mix(lattice_value(i, j + 1, seed), lattice_value(i + 1, j + 1, seed), s), t);
}

/// Four octaves of noise: hills of about 12 units, ridges of about 1 unit.
double terrain_height(double x, double z) {
    double height = 0, amplitude = 12, frequency = 1.0 / 32;
    for (std::uint64_t octave = 0; octave < 4; ++octave) {
        height += amplitude * noise(x * frequency, z * frequency, octave);
        amplitude *= 0.4;
        frequency *= 2.75;
    }
    return height;
}

/// A random triangle around camera depth `depth`, about 64 px across at 1080 rows for half_height 0.3.
void add_shard(MeshBuilder& mesh, Random& random, ImageSize size) {
    const double depth = random.uniform(10, 40), margin = 1.05 * 0.3, half = 0.3 * depth * 0.06;
    const double u = random.uniform(-margin, margin) * size.aspect(), v = random.uniform(-margin, margin);
    const glm::dvec3 centre{u * depth, v * depth, -depth}, reach(half);
    const glm::dvec3 a = random.in_box(centre - reach, centre + reach);
    const glm::dvec3 b = random.in_box(centre - reach, centre + reach);
    const glm::dvec3 c = random.in_box(centre - reach, centre + reach);
    mesh.lone_triangle({a, b, c});
}

}  // namespace

Loaded million_triangles(ImageSize size) {
    MeshBuilder mesh("million_triangles");
    mesh.begin_part("terrain", {0.45, 0.5, 0.3});
    add_sheet(mesh, {.across = 1000, .down = 500}, [](double s, double t) {
        const double x = 200 * s - 100, z = 100 * t - 100;
        return glm::dvec3{x, terrain_height(x, z), z};
    });
    return mesh.finish(
        {perspective_view("oblique", size, {.eye_world = {8, 62, 36}, .target_world = {-3, 4, -46}},
                          {.half_height = 0.55, .near_depth = 1, .far_depth = 400}),
         perspective_view("grazing", size, {.eye_world = {-60, 21, 6}, .target_world = {40, 6, -90}},
                          {.half_height = 0.4, .near_depth = 0.25, .far_depth = 500})});
}

Loaded deep_overdraw(ImageSize size) {
    MeshBuilder mesh("deep_overdraw");
    Random random(4);
    for (int part = 0; part < 8; ++part) {
        mesh.begin_part("shards " + std::to_string(part), random.color());
        for (int i = 0; i < 25'000; ++i) add_shard(mesh, random, size);
    }
    return mesh.finish(
        {perspective_view("through", size, {}, {.half_height = 0.3, .near_depth = 1, .far_depth = 100}),
         perspective_view("aside", size, {.eye_world = {45, 6, -20}, .target_world = {0, 0, -24}},
                          {.half_height = 0.4, .near_depth = 1, .far_depth = 100})});
}

}  // namespace zproof::suite
