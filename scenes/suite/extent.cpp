#include <cmath>

#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::suite {

Loaded far_from_origin(ImageSize size) {
    MeshBuilder mesh("far_from_origin");
    Random random(12);
    const glm::dvec3 site{786'432, 131'072, -524'288};  // float32 steps here: 1/16, 1/64, 1/16
    mesh.begin_part("ground", {0.4, 0.45, 0.3});
    add_sheet(mesh, {.across = 96, .down = 96}, [&](double s, double t) {
        const glm::dvec2 wave = unit_circle(2 * s + t);
        return site + glm::dvec3{192 * s - 96, 4 * wave.x, 192 * t - 160};
    });
    mesh.begin_part("balls", {0.7, 0.3, 0.3});
    for (int i = 0; i < 24; ++i) {
        const glm::dvec3 p = random.in_box(glm::dvec3{-60, 4, -120}, glm::dvec3{60, 40, 0});
        add_sphere(mesh, {site + p, glm::dmat3(random.uniform(3, 9))}, {.across = 48, .down = 24});
    }
    mesh.begin_part("rings", {0.3, 0.4, 0.7});
    for (int i = 0; i < 12; ++i) {
        const glm::dvec3 p = random.in_box(glm::dvec3{-60, 4, -120}, glm::dvec3{60, 40, 0});
        const glm::dmat3 axes = random.rotation();
        add_torus(mesh, {site + p, axes * 8.0}, 0.3, {.across = 48, .down = 16});
    }
    return mesh.finish(
        {perspective_view("ahead", size, {site + glm::dvec3{5, 30, 70}, site + glm::dvec3{0, 8, -40}},
                          {.half_height = 0.5, .near_depth = 1, .far_depth = 1000}),
         perspective_view("close", size, {site + glm::dvec3{-30, 20, 10}, site + glm::dvec3{0, 15, -60}},
                          {.half_height = 0.2, .near_depth = 1, .far_depth = 1000})});
}

Loaded depth_range(ImageSize size) {
    MeshBuilder mesh("depth_range");
    Random random(13);
    mesh.begin_part("floor tiles", {0.4, 0.4, 0.4});
    double depth = 0x1p-6;
    for (int k = 0; k < 23;
         ++k, depth *= 2)  // each tile is twice as far and as large: one size in the picture
        add_sheet(mesh, {.across = 2, .down = 8}, [&](double s, double t) {
            return glm::dvec3{(0.07 * (k + s) - 0.8) * depth * (1 + t), -0.45 * depth, -depth * (1 + t)};
        });
    mesh.begin_part("balls", {0.8, 0.5, 0.2});
    depth = 0x1p-6;
    for (int k = 0; k < 23; ++k, depth *= 2) {
        const glm::dvec3 toward{0.13 * (k % 12) - 0.72, k < 12 ? 0.22 : -0.12, -1};
        add_sphere(mesh, {toward * depth, glm::dmat3(0.06 * depth)}, {.across = 32, .down = 16});
    }
    mesh.begin_part("close pairs", {0.2, 0.6, 0.7});
    depth = 0x1p-6;
    for (int k = 0; k < 23; ++k, depth *= 2)
        for (const double step : {1.0, 1 + 0x1p-12}) {
            const double d = depth * step, x = 0.07 * k - 0.8, lift = (step - 1) * 0x1p8;
            mesh.lone_triangle({{{x * d, (0.3 + lift) * d, -d},
                                 {(x + 0.06) * d, (0.3 + lift) * d, -d},
                                 {(x + 0.03) * d, (0.45 + lift) * d, -d}}});
        }
    View reversed =
        perspective_view("reversed", size, {}, {.half_height = 0.5, .near_depth = 0.01, .far_depth = 1e5});
    reversed.camera.ndc_depth = NdcDepth::zero_to_one_reversed;
    return mesh.finish(
        {perspective_view("standard", size, {}, {.half_height = 0.5, .near_depth = 0.01, .far_depth = 1e5}),
         reversed});
}

}  // namespace zproof::suite
