#include <array>
#include <limits>

#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"

namespace zproof::suite {

namespace {

/// A sheet that leans from depth d to 2 d; its place and size in the picture do not depend on d.
void add_leaning_sheet(MeshBuilder& mesh, double depth, double u) {
    add_sheet(mesh, {.across = 2, .down = 4}, [&](double s, double t) {
        const double d = depth * (1 + t);
        return glm::dvec3{(u + 0.055 * s) * d, (0.35 - 0.7 * t) * d, -d};
    });
}

/// A card that leans through camera depth `depth` of a view along -z from the origin.
void add_leaning_card(MeshBuilder& mesh, double x, double depth) {
    mesh.lone_quad(
        {{{x, -14, -depth + 12}, {x + 4, -14, -depth}, {x + 4, 14, -depth - 12}, {x, 14, -depth}}});
}

/// A square at exactly that camera depth.
void add_square(MeshBuilder& mesh, double x, double depth) {
    mesh.lone_quad({{{x, -1, -depth}, {x + 2, -1, -depth}, {x + 2, 1, -depth}, {x, 1, -depth}}});
}

View axis_parallel_view(const char* name, ImageSize size, double near_depth, double far_depth) {
    return parallel_view(name, size, {},
                         {.half_height = 16, .near_depth = near_depth, .far_depth = far_depth});
}

}  // namespace

Loaded far_at_infinity(ImageSize size) {
    MeshBuilder mesh("far_at_infinity");
    mesh.begin_part("leaning sheets", {0.5, 0.4, 0.6});
    double depth = 0x1p-6;
    for (int k = 0; k < 26; ++k, depth *= 2) add_leaning_sheet(mesh, depth, 0.065 * k - 0.85);
    mesh.begin_part("sky", {0.3, 0.5, 0.8});
    mesh.lone_triangle({{{-1.9e6, -4e5, -1e6}, {1.9e6, -4e5, -2e6}, {0, 1.5e6, -1.5e6}}});
    const double infinity = std::numeric_limits<double>::infinity();
    View standard = perspective_view("standard", size, {},
                                     {.half_height = 0.5, .near_depth = 0.01, .far_depth = infinity});
    View reversed = standard;
    reversed.name = "reversed";
    reversed.camera.ndc_depth = NdcDepth::zero_to_one_reversed;
    return mesh.finish({standard, reversed});
}

Loaded parallel_planes(ImageSize size) {
    MeshBuilder mesh("parallel_planes");
    mesh.begin_part("leaning cards", {0.7, 0.5, 0.3});
    for (int i = 0; i < 13; ++i) add_leaning_card(mesh, 4 * i - 26, 10 * i - 60);
    mesh.begin_part("in the planes", {0.3, 0.6, 0.5});
    for (const double depth : {-45.0, -35.0, -15.0, 20.0, 45.0, 50.0})
        add_square(mesh, 0.5 * depth - 1, depth);
    View oblique = axis_parallel_view("oblique", size, -35, 45);
    oblique.camera.shear = {0.125, -0.25};
    return mesh.finish({axis_parallel_view("around-the-eye", size, -35, 45),
                        axis_parallel_view("behind-the-eye", size, -45, -15),
                        axis_parallel_view("short-of-far", size, 20, 50), oblique});
}

}  // namespace zproof::suite
