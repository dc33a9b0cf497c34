#include <map>
#include <tuple>
#include <vector>

#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"

namespace zproof::suite {

namespace {

/// A wall of squares of many sizes, in steps of 1/8, that share corners but not edges: a long edge of one
/// meets several short edges of its neighbours. Corners are exact in float32 and so lie on the long edges
/// exactly.
class SplitWall {
  public:
    SplitWall(MeshBuilder& mesh, Random& random) : mesh_(mesh), random_(random) {}

    /// The square [x, x + extent] x [y, y + extent] of the wall, in eighths; extent is a power of two.
    void add(int x, int y, int extent) {
        if (extent > 16 || (extent > 2 && random_.uniform(0, 1) < 0.6)) {
            const int half = extent / 2;
            for (const auto& [i, j] : {std::pair{0, 0}, {half, 0}, {0, half}, {half, half}})
                add(x + i, y + j, half);
            return;
        }
        mesh_.quad(
            {corner(x, y), corner(x + extent, y), corner(x + extent, y + extent), corner(x, y + extent)});
    }

  private:
    std::uint32_t corner(int x, int y) {
        const auto [place, is_new] = corners_.try_emplace({x, y}, 0u);
        if (is_new) place->second = mesh_.vertex({x / 8.0, y / 8.0, (3 * x - 5 * y) / 128.0});
        return place->second;
    }

    MeshBuilder& mesh_;
    Random& random_;
    std::map<std::pair<int, int>, std::uint32_t> corners_;
};

/// A point of the plane z = x / 8 + y / 16 on the line of slope 5/64 number `line`: exact in float32 for x in
/// multiples of 2^-8 below 2^6, because y needs 19 bits and z 22.
glm::dvec3 on_line(int line, double x) {
    const double y = line / 16.0 + x * 5 / 64;
    return {x, y, x / 8 + y / 16};
}

/// Breaks the line between x = -24 and 24 anywhere: every strip has breaks of its own.
std::vector<double> breaks(Random& random, int count) {
    std::vector<double> x;
    for (int i = 0; i <= count; ++i)
        x.push_back(-24 + (48.0 * 256 * i / count + random.integer(-60, 60)) / 256);
    for (double& value : x) value = static_cast<double>(static_cast<int>(value * 256)) / 256;
    return x;
}

/// The strip between two neighbouring lines, of vertices that no other strip has.
void add_strip(MeshBuilder& mesh, Random& random, int line) {
    constexpr std::size_t count = 56;
    const std::vector<double> lower = breaks(random, count), upper = breaks(random, count);
    std::vector<std::uint32_t> v;
    for (std::size_t i = 0; i <= count; ++i) {
        v.push_back(mesh.vertex(on_line(line, lower[i])));
        v.push_back(mesh.vertex(on_line(line + 1, upper[i])));
    }
    for (std::size_t i = 0; i < 2 * count; i += 2) mesh.quad({v[i], v[i + 2], v[i + 3], v[i + 1]});
}

void add_backdrop(MeshBuilder& mesh) {
    mesh.begin_part("backdrop", {0.9, 0.1, 0.8});
    mesh.lone_triangle({{{-400, -200, -30}, {400, -200, -30}, {0, 600, -30}}});
}

}  // namespace

Loaded t_junctions(ImageSize size) {
    MeshBuilder mesh("t_junctions");
    Random random(10);
    mesh.begin_part("wall", {0.5, 0.6, 0.4});
    SplitWall wall(mesh, random);
    for (int y = -128; y < 128; y += 64)
        for (int x = -192; x < 192; x += 64) wall.add(x, y, 64);
    add_backdrop(mesh);
    return mesh.finish(
        {perspective_view("ahead", size, {.eye_world = {1.3, 0.7, 25}, .target_world = {0.2, -0.1, 0}},
                          {.half_height = 0.5, .near_depth = 0.5, .far_depth = 200}),
         perspective_view("aside", size,
                          {.eye_world = {-21, 9, 14}, .target_world = {0, 0, 0}, .up_world = {0.2, 1, 0.1}},
                          {.half_height = 0.45, .near_depth = 0.5, .far_depth = 200})});
}

Loaded abutting_strips(ImageSize size) {
    MeshBuilder mesh("abutting_strips");
    Random random(11);
    for (const int odd : {0, 1}) {
        mesh.begin_part(odd == 0 ? "even strips" : "odd strips", {0.3 + 0.3 * odd, 0.6, 0.5});
        for (int line = -240 + odd; line < 240; line += 2) add_strip(mesh, random, line);
    }
    add_backdrop(mesh);
    return mesh.finish(
        {perspective_view("ahead", size, {.eye_world = {3.1, 2.3, 25}, .target_world = {0.2, 0.4, 0}},
                          {.half_height = 0.4, .near_depth = 0.5, .far_depth = 200}),
         perspective_view(
             "rolled", size,
             {.eye_world = {-6.7, -3.9, 19}, .target_world = {0, 0, 0}, .up_world = {-0.7, 1, 0}},
             {.half_height = 0.4, .near_depth = 0.5, .far_depth = 200})});
}

}  // namespace zproof::suite
