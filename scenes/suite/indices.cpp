#include <cstdint>
#include <string>
#include <vector>

#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::suite {

namespace {

/// For each bit from `first` to `last`: the ids just around 2^bit, and some with random bits below it.
/// Ascending.
std::vector<std::uint32_t> ids_of_every_bit(int first, int last, std::uint32_t end) {
    std::vector<std::uint32_t> ids;
    Random random(33);
    for (int bit = first; bit <= last; ++bit) {
        const std::uint32_t power = std::uint32_t{1} << bit, room = std::min(power, end - power);
        for (const std::uint32_t id : {power - 1, power, power + 1}) ids.push_back(id);
        for (std::uint32_t i = 0; i < 40; ++i)
            ids.push_back(power + 2 + std::uint32_t((i + random.uniform(0, 1)) / 40 * (room - 3)));
    }
    return ids;
}

/// `end` triangles in one part. Those with these ids are cards side by side at depth 4 of a view along -z;
/// all others are a point far behind them: who sorts by depth has the cards last.
void add_visible_ids(MeshBuilder& mesh, const std::vector<std::uint32_t>& ids, std::uint32_t end) {
    constexpr int columns = 20;
    mesh.begin_part("ids", {0.6, 0.6, 0.3});
    const MeshBuilder::Room room = mesh.room_for(3 * ids.size() + 1, end);
    const std::uint32_t nowhere = room.first_vertex + std::uint32_t(3 * ids.size());
    std::ranges::fill(room.triangles, glm::uvec3(nowhere));
    room.p_world[3 * ids.size()] = {0, 0, -200};
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const double x = 0.34 * double(i % columns) - 3.4, y = 1.7 - 0.25 * double(i / columns);
        const std::array<glm::vec3, 3> corners{
            glm::vec3{x, y, -4}, {x + 0.3, y, -4.125}, {x + 0.125, y - 0.22, -4}};
        std::ranges::copy(corners, room.p_world.begin() + std::ptrdiff_t(3 * i));
        const std::uint32_t first = room.first_vertex + std::uint32_t(3 * i);
        room.triangles[ids[i]] = {first, first + 1, first + 2};
    }
}

View facing_cards(const char* name, ImageSize size) {
    return perspective_view(name, size, {}, {.half_height = 0.5, .near_depth = 1, .far_depth = 100});
}

}  // namespace

Loaded high_ids(ImageSize size) {
    constexpr std::uint32_t end = (1u << 20) + 256;
    MeshBuilder mesh("high_ids");
    add_visible_ids(mesh, ids_of_every_bit(16, 20, end), end);
    return mesh.finish({facing_cards("ahead", size)});
}

Loaded ids_beyond_float(ImageSize) {
    constexpr std::uint32_t end = (1u << 24) + 256;
    MeshBuilder mesh("ids_beyond_float");
    add_visible_ids(mesh, ids_of_every_bit(20, 24, end), end);
    return mesh.finish({facing_cards("ahead", {.width = 640, .height = 360})});
}

Loaded far_indices(ImageSize size) {
    constexpr int columns = 512, rows = 640;
    constexpr std::uint32_t jump = 0x10000;
    MeshBuilder mesh("far_indices");
    mesh.begin_part("cells", {0.4, 0.5, 0.7});
    std::uint32_t first = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const glm::dvec2 wave = unit_circle(column / 64.0 + row / 96.0);
            const std::uint32_t v = mesh.vertex({column / 64.0 - 4, 2.5 - row / 128.0, -5 + 0.25 * wave.x});
            if (row == 0 && column == 0) first = v;
        }
    const auto add_cell = [&](std::uint32_t corner) {
        mesh.quad({corner, corner + columns, corner + columns + 1, corner + 1});
    };
    for (std::uint32_t corner = 0; corner < jump; corner += 2)
        for (std::uint32_t k = 0; k < columns * rows / jump && corner / columns % 2 == 0; ++k)
            add_cell(first + corner + k * jump);
    return mesh.finish({facing_cards("ahead", size)});
}

Loaded many_primitives(ImageSize size) {
    constexpr int columns = 24, rows = 14;
    MeshBuilder mesh("many_primitives");
    Random random(34);
    for (int i = 0; i < columns * rows; ++i) {
        mesh.begin_part("plaque " + std::to_string(i), random.color());
        const double x = 0.3 * (i % columns) - 3.6, y = 1.9 - 0.28 * (i / columns),
                     lean = random.uniform(-0.5, 0.5);
        add_sheet(mesh, {.across = 1 + i % 3, .down = 1 + i % 2}, [&](double s, double t) {
            return glm::dvec3{x + 0.26 * s, y - 0.24 * t, -4 + lean * s};
        });
    }
    return mesh.finish({facing_cards("ahead", size)});
}

}  // namespace zproof::suite
