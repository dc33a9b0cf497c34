#include "scenes/suite/shapes.h"

#include <tbb/parallel_for.h>

#include <utility>

#include "scenes/suite/unit_circle.h"

namespace zproof::suite {

namespace {

std::uint32_t place(MeshBuilder& mesh, const Placement& placement, const glm::dvec3& p_shape) {
    return mesh.vertex(placement.centre + placement.axes * p_shape);
}

/// Two triangles for each cell of a row, as MeshBuilder::quad() makes them. `first`: the row's first vertex,
/// `stride` before the one below it.
void write_cells(std::uint32_t first, std::uint32_t stride, std::span<glm::uvec3> triangles) {
    for (std::uint32_t a = first; !triangles.empty(); ++a, triangles = triangles.subspan(2)) {
        triangles[0] = {a, a + stride, a + stride + 1};
        triangles[1] = {a, a + stride + 1, a + 1};
    }
}

}  // namespace

void add_sheet_by_rows(MeshBuilder& mesh, Cells cells, const RowOfSheet& write_row) {
    const std::size_t across = std::size_t(cells.across), down = std::size_t(cells.down), stride = across + 1;
    const MeshBuilder::Room room = mesh.room_for(stride * (down + 1), 2 * across * down);
    tbb::parallel_for(std::size_t{0}, down + 1, [&](std::size_t row) {
        const std::span<glm::vec3> points = room.p_world.subspan(row * stride, stride);
        write_row(static_cast<int>(row), points);
        for (glm::vec3& p : points) p += 0.0f;  // never -0
        if (row == down) return;
        const std::uint32_t first = room.first_vertex + static_cast<std::uint32_t>(row * stride);
        write_cells(first, static_cast<std::uint32_t>(stride),
                    room.triangles.subspan(2 * across * row, 2 * across));
    });
}

void add_sheet(MeshBuilder& mesh, Cells cells, const PointOnSheet& point_at) {
    std::uint32_t first = 0;
    for (int row = 0; row <= cells.down; ++row)
        for (int column = 0; column <= cells.across; ++column) {
            const std::uint32_t v = mesh.vertex(
                point_at(static_cast<double>(column) / cells.across, static_cast<double>(row) / cells.down));
            if (row == 0 && column == 0) first = v;
        }
    const auto stride = static_cast<std::uint32_t>(cells.across + 1);
    for (std::uint32_t row = 0; std::cmp_less(row, cells.down); ++row)
        for (std::uint32_t column = 0; std::cmp_less(column, cells.across); ++column) {
            const std::uint32_t a = first + row * stride + column;
            mesh.quad({a, a + stride, a + stride + 1, a + 1});
        }
}

void add_sphere(MeshBuilder& mesh, const Placement& placement, Cells cells) {
    const auto across = static_cast<std::uint32_t>(cells.across);
    const auto inner_rings = static_cast<std::uint32_t>(cells.down - 1);
    const std::uint32_t top = place(mesh, placement, {0, 1, 0});
    for (int ring = 1; ring < cells.down; ++ring) {
        const glm::dvec2 polar = unit_circle(0.5 * ring / cells.down);
        for (int segment = 0; segment < cells.across; ++segment) {
            const glm::dvec2 around = unit_circle(static_cast<double>(segment) / cells.across);
            place(mesh, placement, {polar.y * around.x, polar.x, -polar.y * around.y});
        }
    }
    const std::uint32_t bottom = place(mesh, placement, {0, -1, 0});
    const auto at = [&](std::uint32_t ring, std::uint32_t segment) {
        return top + 1 + ring * across + segment % across;
    };
    for (std::uint32_t s = 0; s < across; ++s) mesh.triangle(top, at(0, s), at(0, s + 1));
    for (std::uint32_t r = 0; r + 1 < inner_rings; ++r)
        for (std::uint32_t s = 0; s < across; ++s)
            mesh.quad({at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s + 1)});
    for (std::uint32_t s = 0; s < across; ++s)
        mesh.triangle(bottom, at(inner_rings - 1, s + 1), at(inner_rings - 1, s));
}

void add_torus(MeshBuilder& mesh, const Placement& placement, double tube_radius, Cells cells) {
    std::uint32_t first = 0;
    for (int row = 0; row < cells.down; ++row) {
        const glm::dvec2 tube = tube_radius * unit_circle(static_cast<double>(row) / cells.down);
        for (int column = 0; column < cells.across; ++column) {
            const glm::dvec2 ring = (1 + tube.x) * unit_circle(static_cast<double>(column) / cells.across);
            const std::uint32_t v = place(mesh, placement, {ring.x, tube.y, -ring.y});
            if (row == 0 && column == 0) first = v;
        }
    }
    const auto across = static_cast<std::uint32_t>(cells.across);
    const auto down = static_cast<std::uint32_t>(cells.down);
    const auto at = [&](std::uint32_t r, std::uint32_t c) { return first + r % down * across + c % across; };
    for (std::uint32_t r = 0; r < down; ++r)
        for (std::uint32_t c = 0; c < across; ++c)
            mesh.quad({at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)});
}

void add_box(MeshBuilder& mesh, const Placement& placement) {
    std::array<std::uint32_t, 8> v{};
    for (std::uint32_t i = 0; i < 8; ++i)
        v[i] = place(mesh, placement, {i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
    constexpr std::array<std::array<std::size_t, 4>, 6> faces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& face : faces) mesh.quad({v[face[0]], v[face[1]], v[face[2]], v[face[3]]});
}

void add_box_between(MeshBuilder& mesh, const glm::dvec3& low, const glm::dvec3& high) {
    const glm::dvec3 half = (high - low) * 0.5;
    add_box(mesh, {low + half,
                   glm::dmat3(glm::dvec3(half.x, 0, 0), glm::dvec3(0, half.y, 0), glm::dvec3(0, 0, half.z))});
}

}  // namespace zproof::suite
