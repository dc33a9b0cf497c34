#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"

namespace zproof::suite {

namespace {

/// World units are pixels: raster (x, y) lies at world (x - width / 2, height / 2 - y, z), exactly.
glm::dvec3 at_raster(ImageSize size, const glm::dvec2& p_raster, double z) {
    return {p_raster.x - 0.5 * size.width, 0.5 * size.height - p_raster.y, z};
}

/// Looks down -z so that at_raster holds in every bit.
View pixel_exact_view(ImageSize size) {
    View view{.name = "parallel", .camera = {}, .width = size.width, .height = size.height};
    view.camera.eye_world = {0, 0, 1024};
    view.camera.projection = Projection::parallel;
    view.camera.window = centred_window(size, 0.5 * size.height);
    view.camera.window.left = -0.5 * size.width;
    view.camera.window.right = 0.5 * size.width;
    view.camera.near_depth = 1;
    view.camera.far_depth = 4096;
    return view;
}

/// The picture in perspective, for geometry in the plane z = 0: tangents are pixels / 1024, a power of two.
View pixel_exact_perspective(ImageSize size) {
    View view = pixel_exact_view(size);
    view.name = "perspective";
    view.camera.projection = Projection::perspective;
    view.camera.window = {.left = -size.width / 2048.0,
                          .right = size.width / 2048.0,
                          .bottom = -size.height / 2048.0,
                          .top = size.height / 2048.0};
    return view;
}

/// Points around a rectangle of half extents (16 step.x, 16 step.y): 32 to a side, counterclockwise seen from
/// +z.
std::vector<glm::dvec2> rim_around(const glm::dvec2& hub, const glm::dvec2& step) {
    std::vector<glm::dvec2> rim;
    constexpr std::array<glm::dvec2, 4> corners{glm::dvec2{-16, 16}, {16, 16}, {16, -16}, {-16, -16}};
    constexpr std::array<glm::dvec2, 4> ways{glm::dvec2{1, 0}, {0, -1}, {-1, 0}, {0, 1}};
    for (std::size_t side = 0; side < 4; ++side)
        for (int i = 0; i < 32; ++i)
            rim.push_back(hub + step * (corners[side] + static_cast<double>(i) * ways[side]));
    return rim;
}

/// Fans that fill cells of 64 x 64 px; neighbours share the 8 px steps of their common border.
class FanMosaic {
  public:
    FanMosaic(MeshBuilder& mesh, ImageSize size) : mesh_(mesh), size_(size) {}

    void add_fan(int left, int top, const glm::dvec3& hub) {
        const std::uint32_t centre = mesh_.vertex(at_raster(size_, {hub.x, hub.y}, hub.z));
        std::array<std::uint32_t, 32> rim{};
        for (int i = 0; i < 8; ++i) {
            rim[static_cast<std::size_t>(i)] = border(left, top + 8 * i);
            rim[static_cast<std::size_t>(i) + 8] = border(left + 8 * i, top + 64);
            rim[static_cast<std::size_t>(i) + 16] = border(left + 64, top + 64 - 8 * i);
            rim[static_cast<std::size_t>(i) + 24] = border(left + 64 - 8 * i, top);
        }
        for (std::size_t i = 0; i < 32; ++i) mesh_.triangle(centre, rim[i], rim[(i + 1) % 32]);
    }

  private:
    /// The vertex at the centre of pixel (x, y), the same for all cells that meet there.
    std::uint32_t border(int x, int y) {
        const auto [place, is_new] = border_.try_emplace({x, y}, 0u);
        if (is_new) place->second = mesh_.vertex(at_raster(size_, {x + 0.5, y + 0.5}, 0));
        return place->second;
    }

    MeshBuilder& mesh_;
    ImageSize size_;
    std::map<std::pair<int, int>, std::uint32_t> border_;
};

/// Integers p and q without a common factor, and r, s with p s - q r = 1 on the other side of the origin.
struct ClosePair {
    std::int64_t p, q, r, s;
};

ClosePair close_pair(Random& random) {
    for (;;) {
        const std::int64_t p = random.integer(20'000, 60'000), q = random.integer(20'000, 60'000);
        std::int64_t a = p, b = q, of_a = 1, of_b = 0;  // Euclid: a = of_a p (modulo q)
        while (b != 0) {
            const std::int64_t times = a / b;
            a = std::exchange(b, a - times * b);
            of_a = std::exchange(of_b, of_a - times * of_b);
        }
        if (a != 1) continue;
        const std::int64_t s = of_a, r = (p * s - 1) / q, turns = s > 0 ? s / q + 1 : 0;
        return {p, q, r - turns * p, s - turns * q};
    }
}

/// Two triangles whose common edge passes a pixel's centre at a distance below 2^-29 px.
void add_beside(MeshBuilder& mesh, Random& random, ImageSize size, const glm::dvec2& centre) {
    constexpr double unit = 0x1p-15;  // of a pixel; float32 holds it up to 256 px from the origin
    const ClosePair pair = close_pair(random);
    const auto vertex = [&](double x, double y) {
        return mesh.vertex(at_raster(size, centre + glm::dvec2{x, -y}, 0));
    };
    const std::uint32_t a = vertex(unit * double(pair.p), unit * double(pair.q)),
                        b = vertex(unit * double(pair.r), unit * double(pair.s));
    const double first = random.integer(0, 1) == 0 ? 1.5 : -1.5;
    for (const double aside : {first, -first}) mesh.triangle(a, b, vertex(aside, -aside));
}

}  // namespace

Loaded beside_pixel_centres(ImageSize size) {
    MeshBuilder mesh("beside_pixel_centres");
    Random random(36);
    mesh.begin_part("triangles", {0.5, 0.4, 0.7});
    for (int row = -10; row < 10; ++row)
        for (int column = -20; column < 20; ++column)
            add_beside(mesh, random, size,
                       {size.width / 2 + 6 * column + 0.5, size.height / 2 + 6 * row + 0.5});
    return mesh.finish({pixel_exact_view(size)});
}

Loaded fan_at_pixel_centre(ImageSize size) {
    MeshBuilder mesh("fan_at_pixel_centre");
    mesh.begin_part("fan", {0.7, 0.5, 0.3});
    const int column = size.width / 2, row = size.height / 2;
    const glm::dvec2 hub{column + 0.5, row + 0.5};
    const glm::dvec2 step{size.width / 44, size.height / 44}, outer_step{size.width, size.height};
    const std::uint32_t centre = mesh.vertex(at_raster(size, hub, 0));
    for (const glm::dvec2& p : rim_around(hub, step)) mesh.vertex(at_raster(size, p, 0));
    for (const glm::dvec2& p : rim_around(hub, outer_step)) mesh.vertex(at_raster(size, p, 0));
    constexpr std::uint32_t count = 128;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = centre + 1 + i, b = centre + 1 + (i + 1) % count;
        mesh.triangle(centre, a, b);
        mesh.quad({a, a + count, b + count, b});
    }
    return mesh.finish({pixel_exact_view(size), pixel_exact_perspective(size)});
}

Loaded shared_edges(ImageSize size) {
    MeshBuilder mesh("shared_edges");
    Random random(8);
    mesh.begin_part("mosaic", {0.35, 0.55, 0.6});
    FanMosaic mosaic(mesh, size);
    for (int top = -64; top < size.height + 64; top += 64)
        for (int left = -64; left < size.width + 64; left += 64) {
            const double x = left + 0.5 + random.integer(8, 56), y = top + 0.5 + random.integer(8, 56);
            const double sixteenths_x = random.integer(-8, 8) / 16.0,
                         sixteenths_y = random.integer(-8, 8) / 16.0;
            const bool on_centre = random.integer(0, 1) == 0;
            const glm::dvec2 offset = on_centre ? glm::dvec2{0, 0} : glm::dvec2{sixteenths_x, sixteenths_y};
            mosaic.add_fan(left, top, {x + offset.x, y + offset.y, random.integer(0, 40)});
        }
    const double depth = 0.9 * size.height;
    return mesh.finish(
        {pixel_exact_view(size), perspective_view("tilted", size,
                                                  {.eye_world = {0.2 * depth, -0.4 * depth, 0.8 * depth},
                                                   .target_world = {10, -20, 0},
                                                   .up_world = {0.37, 1, 0}},
                                                  {.half_height = 0.5, .near_depth = 1, .far_depth = 8192})});
}

}  // namespace zproof::suite
