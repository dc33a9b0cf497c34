/// Vertices that lie on the borders of pixels exactly, seen by the lessons' own camera: whoever errs at all
/// loses pixels here, and the instrument says where.
#pragma once

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::study::projection {

/// The canvas from -1 to 1 at depth 1, near 0.1, 640 x 480 pixels, from the origin along -z.
View lattice_view();

/// Crossings of its pixels' borders, 5 px apart across and 15 px down, at depths from 1 to 7; no triangles.
Scene border_lattice();

}  // namespace zproof::study::projection
