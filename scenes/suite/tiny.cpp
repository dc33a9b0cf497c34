#include <cmath>

#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::suite {

namespace {

constexpr double window_half_height = 0.5;

/// The length of one pixel of a 1080-row image at camera depth 1.
constexpr double pixel = 2 * window_half_height / 1080;

/// A point of the frustum of an eye at the origin that looks down -z.
glm::dvec3 in_frustum(Random& random, ImageSize size, double depth) {
    const double u = random.uniform(-window_half_height, window_half_height) * size.aspect();
    const double v = random.uniform(-window_half_height, window_half_height);
    return {u * depth, v * depth, -depth};
}

/// 2^4 to 2^11 px long, 2^-7 to 2^1 px wide, at any angle and in any plane.
void add_needle(MeshBuilder& mesh, Random& random, ImageSize size) {
    const double depth = random.uniform(4, 40);
    const glm::dvec3 p = in_frustum(random, size, depth);
    const double length = random.binade(4, 10) * pixel * depth, width = random.binade(-7, 0) * pixel * depth;
    const glm::dmat3 axes = random.rotation();
    const double lean = random.uniform(-1, 1);
    mesh.lone_triangle({p - length / 2 * axes[0], p + length / 2 * axes[0],
                        p + lean * length / 2 * axes[0] + width * axes[1]});
}

/// 1440 slivers around one hub: each is 1/1440 turn wide.
void add_rosette(MeshBuilder& mesh, const glm::dvec3& hub, double radius) {
    constexpr std::uint32_t spokes = 1440;
    const std::uint32_t centre = mesh.vertex(hub);
    for (std::uint32_t i = 0; i < spokes; ++i) {
        const glm::dvec2 rim = radius * unit_circle(static_cast<double>(i) / spokes);
        mesh.vertex(hub + glm::dvec3{rim.x, rim.y, 0.25 * rim.x});
    }
    for (std::uint32_t i = 0; i < spokes; ++i)
        mesh.triangle(centre, centre + 1 + i, centre + 1 + (i + 1) % spokes);
}

enum class Flaw {
    repeated_index,     ///< a a b
    repeated_position,  ///< three vertices, two at one point
    point,              ///< three vertices at one point
    collinear,          ///< on one line, exactly
    nearly_collinear,   ///< on one line but for the rounding to float32
    sub_pixel,          ///< 2^-6 to 1/2 px across
    microscopic,        ///< 2^-12 to 2^-6 px across: a few steps of float32
};
constexpr int flaw_count = 7;

/// p rounded to multiples of 2^-10, so that sums of it with short dyadic numbers are exact in float32.
glm::dvec3 dyadic(const glm::dvec3& p) { return glm::floor(p * 0x1p10) * 0x1p-10; }

void add_flawed(MeshBuilder& mesh, Random& random, Flaw flaw, const glm::dvec3& p_any) {
    const glm::dvec3 p = dyadic(p_any), step = dyadic(0.3 * random.direction());
    const double at_pixel = -p.z * pixel;
    const auto cluster = [&](double radius) {
        const glm::dvec3 a = random.direction(), b = random.direction(), c = random.direction();
        mesh.lone_triangle({p + radius * a, p + radius * b, p + radius * c});
    };
    switch (flaw) {
        case Flaw::repeated_index: {
            const std::uint32_t a = mesh.vertex(p), b = mesh.vertex(p + step);
            return mesh.triangle(a, a, b);
        }
        case Flaw::repeated_position:
            return mesh.lone_triangle({p, p + step, p});
        case Flaw::point:
            return mesh.lone_triangle({p, p, p});
        case Flaw::collinear:
            return mesh.lone_triangle({p, p + step, p + 3.0 * step});
        case Flaw::nearly_collinear:
            return mesh.lone_triangle({p, p + 0.3 * step, p + 0.7 * step});
        case Flaw::sub_pixel:
            return cluster(0.5 * at_pixel * random.binade(-6, -2));
        case Flaw::microscopic:
            return cluster(0.5 * at_pixel * random.binade(-12, -7));
    }
}

}  // namespace

Loaded slivers(ImageSize size) {
    MeshBuilder mesh("slivers");
    Random random(5);
    mesh.begin_part("blind", {0.6, 0.6, 0.6});
    add_sheet(mesh, {.across = 1, .down = 1500}, [](double s, double t) {
        return glm::dvec3{100 * s - 50, 60 * t - 30 + 2 * s, -44 - 8 * s};
    });
    mesh.begin_part("rosettes", {0.2, 0.5, 0.6});
    for (int i = 0; i < 4; ++i) add_rosette(mesh, in_frustum(random, size, 30), 5);
    mesh.begin_part("needles", {0.7, 0.4, 0.2});
    for (int i = 0; i < 20'000; ++i) add_needle(mesh, random, size);
    return mesh.finish(
        {perspective_view("ahead", size, {},
                          {.half_height = window_half_height, .near_depth = 0.5, .far_depth = 100}),
         perspective_view("rolled", size,
                          {.eye_world = {1, 2, 3}, .target_world = {0, 0, -40}, .up_world = {0.3, 1, 0}},
                          {.half_height = window_half_height, .near_depth = 0.5, .far_depth = 100})});
}

Loaded degenerate(ImageSize size) {
    MeshBuilder mesh("degenerate");
    Random random(6);
    mesh.begin_part("wall", {0.5, 0.5, 0.55});
    add_sheet(mesh, {.across = 40, .down = 24}, [](double s, double t) {
        return glm::dvec3{64 * s - 32, 36 * t - 18, -32};
    });
    for (int flaw = 0; flaw < flaw_count; ++flaw) {
        mesh.begin_part("flaw " + std::to_string(flaw), random.color());
        for (int i = 0; i < 6000; ++i) {
            const double depth = random.uniform(4, 31);
            add_flawed(mesh, random, static_cast<Flaw>(flaw), in_frustum(random, size, depth));
        }
    }
    return mesh.finish({perspective_view(
        "ahead", size, {}, {.half_height = window_half_height, .near_depth = 0.5, .far_depth = 100})});
}

}  // namespace zproof::suite
