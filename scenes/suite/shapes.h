/// The solids and sheets that the suite is built from. All share vertices by index: no cracks, no
/// T-junctions.
#pragma once

#include <functional>
#include <span>

#include "scenes/suite/mesh_builder.h"

namespace zproof::suite {

/// The place of a shape: p_world = centre + axes * p_shape. A negative determinant mirrors it.
struct Placement {
    glm::dvec3 centre{0.0};
    glm::dmat3 axes{1.0};
};

/// How finely a shape is cut: cells across and cells down, both >= 1.
struct Cells {
    int across = 1, down = 1;
};

using PointOnSheet = std::function<glm::dvec3(double s, double t)>;

/// An open sheet of cells.across x cells.down quads, from point_at(0, 0) to point_at(1, 1).
void add_sheet(MeshBuilder& mesh, Cells cells, const PointOnSheet& point_at);

/// Writes the points of row `row` (0: t = 0), from s = 0 to s = 1, on any thread.
using RowOfSheet = std::function<void(int row, std::span<glm::vec3> p_world)>;

/// Adds a sheet of many cells: rows are made side by side.
void add_sheet_by_rows(MeshBuilder& mesh, Cells cells, const RowOfSheet& write_row);

/// The closed unit sphere: across >= 3 segments, down >= 2 rings, 2 across (down - 1) triangles.
void add_sphere(MeshBuilder& mesh, const Placement& placement, Cells cells);

/// The closed torus around y with ring radius 1: across >= 3, down >= 3 cells, 2 across down triangles.
void add_torus(MeshBuilder& mesh, const Placement& placement, double tube_radius, Cells cells);

/// The closed cube [-1, 1]^3 of 8 vertices and 12 triangles, facing outwards.
void add_box(MeshBuilder& mesh, const Placement& placement);

/// An axis-aligned box between two corners.
void add_box_between(MeshBuilder& mesh, const glm::dvec3& low, const glm::dvec3& high);

}  // namespace zproof::suite
