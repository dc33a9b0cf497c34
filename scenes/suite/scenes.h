/// The suite's scenes, one function each; the manifest says why each is there. Grouped by the file that
/// builds them.
#pragma once

#include "scenes/loaded.h"
#include "scenes/suite/views.h"

namespace zproof::suite {

// near_plane.cpp
Loaded near_plane(ImageSize size);
Loaded clip_blades(ImageSize size);
Loaded guard_band(ImageSize size);

// density.cpp
Loaded million_triangles(ImageSize size);
Loaded deep_overdraw(ImageSize size);

// tiny.cpp
Loaded slivers(ImageSize size);
Loaded degenerate(ImageSize size);

// fill_rule.cpp
Loaded fan_at_pixel_centre(ImageSize size);
Loaded shared_edges(ImageSize size);
Loaded beside_pixel_centres(ImageSize size);

// ties.cpp
Loaded coplanar(ImageSize size);
Loaded interpenetrating(ImageSize size);

// cracks.cpp
Loaded t_junctions(ImageSize size);
Loaded abutting_strips(ImageSize size);

// extent.cpp
Loaded far_from_origin(ImageSize size);
Loaded depth_range(ImageSize size);

// facing.cpp
Loaded back_faces(ImageSize size);
Loaded closed_surfaces(ImageSize size);

// projections.cpp
Loaded off_axis(ImageSize size);
Loaded orthographic(ImageSize size);
Loaded oblique(ImageSize size);
Loaded odd_cameras(ImageSize size);

// sizes.cpp
Loaded picture_sizes(ImageSize size);

// planes.cpp
Loaded far_at_infinity(ImageSize size);
Loaded parallel_planes(ImageSize size);

// cuts.cpp
Loaded frustum_cuts(ImageSize size);
Loaded clipped_tips(ImageSize size);

// indices.cpp
Loaded high_ids(ImageSize size);
Loaded ids_beyond_float(ImageSize size);
Loaded far_indices(ImageSize size);
Loaded many_primitives(ImageSize size);

// stacks.cpp
Loaded one_box(ImageSize size);
Loaded one_tile(ImageSize size);
Loaded pile_of_a_million(ImageSize size);

// textured_ground.cpp
Loaded textured_ground(ImageSize size);

// room.cpp
Loaded room(ImageSize size);

}  // namespace zproof::suite
