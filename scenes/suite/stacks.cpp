#include <array>
#include <string>

#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::suite {

namespace {

constexpr int tile_px = 16;

/// A book with `pages` pages to either side of its spine. All have the spine's two ends, and so one bounding
/// box and one middle of it: no split by boxes tells them apart. Each shows along its rim.
void add_book(MeshBuilder& mesh, int pages) {
    const glm::dvec3 spine{1, 1, 0.5}, across{0.75, -0.75, 0};
    mesh.begin_part("book", {0.8, 0.7, 0.5});
    const std::uint32_t low = mesh.vertex(-spine), high = mesh.vertex(spine);
    for (int page = 1; page <= pages; ++page)
        for (const double side : {-1.0, 1.0}) {
            const double reach = double(page) / pages;
            mesh.triangle(low, high,
                          mesh.vertex(side * reach * across - glm::dvec3{0, 0, 0.4375 * reach * reach}));
        }
    const glm::dvec3 ahead{0, 0, 0.0625}, wide = 0.0625 * across;  // the spine itself is a tie of all pages
    mesh.begin_part("back", {0.3, 0.2, 0.2});
    mesh.lone_quad(
        {{ahead - spine - wide, ahead - spine + wide, ahead + spine + wide, ahead + spine - wide}});
}

/// Triangles of about four pixels within one tile, each `step` before all that came earlier.
struct Pile {
    int count;
    double step;
};

void add_pile(MeshBuilder& mesh, const glm::dvec2& corner_world, Pile pile) {
    Random random(35);
    const auto corner = [&](const glm::dvec2& middle, double z) {
        const glm::dvec2 p = glm::clamp(middle + glm::dvec2{random.uniform(-2, 2), random.uniform(-2, 2)},
                                        0.0, double(tile_px));
        return glm::dvec3{corner_world.x + p.x, corner_world.y - p.y, z};
    };
    for (int i = 0; i < pile.count; ++i) {
        const glm::dvec2 middle{random.uniform(0, tile_px), random.uniform(0, tile_px)};
        const double z = i * pile.step;
        const glm::dvec3 a = corner(middle, z), b = corner(middle, z), c = corner(middle, z);
        mesh.lone_triangle({a, b, c});
    }
}

/// The pile in the tile at the picture's middle, before a wall of waves.
Loaded pile_before_wall(const std::string& name, ImageSize size, Pile pile) {
    const int left = size.width / (2 * tile_px) * tile_px, top = size.height / (2 * tile_px) * tile_px;
    MeshBuilder mesh(name);
    mesh.begin_part("pile", {0.6, 0.4, 0.4});
    add_pile(mesh, {left - 0.5 * size.width, 0.5 * size.height - top}, pile);
    mesh.begin_part("wall", {0.5, 0.5, 0.6});
    add_sheet(mesh, {.across = 48, .down = 32}, [&](double s, double t) {
        const glm::dvec2 wave = unit_circle(3 * s + 2 * t);
        return glm::dvec3{(1.25 * s - 0.625) * size.width + 9 * wave.y,
                          (0.625 - 1.25 * t) * size.height + 5 * wave.x, 200 * wave.x - 400};
    });
    return mesh.finish(
        {parallel_view("ahead", size, {.eye_world = {0, 0, 1024}, .target_world = {0, 0, 0}},
                       {.half_height = 0.5 * size.height, .near_depth = 1, .far_depth = 4096})});
}

}  // namespace

Loaded one_box(ImageSize size) {
    MeshBuilder mesh("one_box");
    add_book(mesh, 100);
    mesh.begin_part("copies", {0.4, 0.5, 0.7});
    const std::uint32_t a = mesh.vertex({1.25, 0.5, 0}), b = mesh.vertex({1.3125, 0.5, 0}),
                        c = mesh.vertex({1.28125, 0.5625, 0.125});
    for (int i = 0; i < 1000; ++i) mesh.triangle(a, b, c);
    return mesh.finish({perspective_view("ahead", size, {.eye_world = {0, 0, 2.5}},
                                         {.half_height = 0.5, .near_depth = 0.5, .far_depth = 100})});
}

Loaded one_tile(ImageSize size) {
    return pile_before_wall("one_tile", size, {.count = 100'000, .step = 0x1p-7});
}

Loaded pile_of_a_million(ImageSize) {
    return pile_before_wall("pile_of_a_million", {.width = 480, .height = 270},
                            {.count = (1 << 20) + (1 << 16), .step = 0x1p-11});
}

}  // namespace zproof::suite
