#include "lessons/cost/experiments.h"

#include <array>
#include <cmath>

#include "math/processor.h"
#include "rasterizer/pipeline.h"
#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/views.h"

namespace zproof::study::cost {
namespace {

/// One unit of the plane at depth 1 is one pixel; (0, 0, -1) is seen in the middle of the image.
View view_of(int side_px) {
    View view;
    view.name = "ahead";
    view.width = view.height = side_px;
    const double half = side_px / 2.0;
    view.camera.window = {.left = -half, .right = half, .bottom = -half, .top = half};
    view.camera.near_depth = 0.5;
    view.camera.far_depth = 1000;
    return view;
}

/// Adds both triangles of a layer over the whole image.
void add_layer(suite::MeshBuilder& mesh, int side_px, double depth) {
    const double r = 0.51 * side_px * depth;
    mesh.lone_quad({glm::dvec3{-r, -r, -depth}, {r, -r, -depth}, {r, r, -depth}, {-r, r, -depth}});
}

Loaded finished(suite::MeshBuilder& mesh, int side_px) { return mesh.finish({view_of(side_px)}); }

Loaded many_vertices(double count) {
    suite::MeshBuilder mesh("vertices");
    mesh.begin_part("idle", {1, 1, 1});
    for (int i = 0; i < int(count) - 4; ++i)
        mesh.vertex({(i % 211) - 105.0, (i / 211 % 211) - 105.0, -1 - 1e-6 * i});
    add_layer(mesh, 64, 2);
    return finished(mesh, 64);
}

constexpr int most_triangles = 240'000, triangle_side_px = 512;

/// Adds a triangle in pixel i of the image, left and above of its centre: the box around it holds the centre,
/// the triangle does not.
void add_miss(suite::MeshBuilder& mesh, int i) {
    const double half = triangle_side_px / 2.0;
    const double x = i % triangle_side_px - half, y = half - i / triangle_side_px % triangle_side_px;
    mesh.lone_triangle({glm::dvec3{x + 0.1, y - 0.1, -1}, {x + 0.1, y - 0.85, -1}, {x + 0.85, y - 0.1, -1}});
}

/// The number of vertices stays the same.
Loaded many_triangles(double count) {
    suite::MeshBuilder mesh("triangles");
    mesh.begin_part("misses", {1, 1, 1});
    for (int i = 0; i < int(count); ++i) add_miss(mesh, i);
    for (int i = 3 * int(count); i < 3 * most_triangles; ++i) mesh.vertex({0, 0, -2});
    return finished(mesh, triangle_side_px);
}

Loaded many_layers(double count) {
    suite::MeshBuilder mesh("layers");
    mesh.begin_part("layers", {1, 1, 1});
    for (int i = 0; i < int(count); ++i) add_layer(mesh, 512, 100 - i);
    return finished(mesh, 512);
}

Loaded many_pixels(double count) {
    const int side = int(std::lround(std::sqrt(count)));
    suite::MeshBuilder mesh("pixels");
    mesh.begin_part("layer", {1, 1, 1});
    add_layer(mesh, side, 2);
    return finished(mesh, side);
}

}  // namespace

std::vector<Experiment> experiments() {
    constexpr Stages::Set geometry = Stages::bus | Stages::transform | Stages::shade;
    const std::vector<Stages::Set> apart{Stages::bus,   Stages::transform,
                                         Stages::shade, Stages::bus | Stages::transform,
                                         geometry,      Stages::all};
    const std::vector<Stages::Set> drawn{Stages::transform | Stages::raster, Stages::all};
    return {{"vertices", {1e4, 3e4, 1e5, 3e5, 1e6}, many_vertices, apart},
            {"triangles", {1e4, 3e4, 6e4, 12e4, double(most_triangles)}, many_triangles, drawn},
            {"depth complexity", {1, 2, 4, 8, 16, 32}, many_layers, drawn},
            {"pixels", {128. * 128, 256. * 256, 512. * 512, 1024. * 1024, 2048. * 2048}, many_pixels, drawn}};
}

std::vector<std::string> constant_names() {
    return {"k_bus", "k_xform", "k_shade", "k_setup", "k_fragment", "k_pixel", "k_run"};
}

std::string constant_meaning(const std::string& name) {
    const std::array meanings{"a vertex copied, 24 bytes",
                              "a vertex transformed, divided and snapped",
                              "a vertex shaded",
                              "a triangle set up, put into tiles and scanned where it covers nothing",
                              "a covered pixel of a triangle: depth test and write",
                              "a pixel of the image, covered or not: cleared and written",
                              "a run, whatever it draws"};
    const std::vector<std::string> names = constant_names();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return meanings[i];
    return "";
}

Quantities quantities_of(const Scene& scene, const View& view) {
    const rasterizer::Optimizations plain{.hierarchical_z = rasterizer::HierarchicalZ::none};
    const rasterizer::Work work =
        rasterizer::Pipeline(rasterizer::correct_rules, widest_of(rasterizer::kernels), plain)
            .count_work(scene, view);
    return {double(work.vertices), double(work.bins.set_up), double(work.tally.fragments),
            double(work.pixels), double(work.tally.blocks)};
}

std::vector<double> factors_of(const Quantities& q, Stages::Set stages) {
    const auto where = [&](Stages::Set stage, double quantity) { return stages & stage ? quantity : 0; };
    return {where(Stages::bus, q.vertices),
            where(Stages::transform, q.vertices),
            where(Stages::shade, q.vertices),
            where(Stages::raster, q.triangles),
            where(Stages::raster, q.fragments),
            where(Stages::raster, q.pixels),
            1};
}

Run measured(const Loaded& loaded, Stages::Set stages, const std::string& varied, int repeats) {
    const View& view = loaded.views.front();
    LecturePipeline pipeline(loaded.scene, view);
    Run run{varied, stages, quantities_of(loaded.scene, view), {}};
    run.timing = timed(repeats, [&] { pipeline.run(stages); });
    return run;
}

}  // namespace zproof::study::cost
