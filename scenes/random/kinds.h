/// The kinds of random scenes: each places at most so many triangles, at least one. Grouped by the file that
/// holds them.
#pragma once

#include "scenes/random/stage.h"

namespace zproof::random {

// loose.cpp: triangles that share nothing
void add_soup(Stage& stage, int most);
void add_slivers(Stage& stage, int most);
void add_tiny(Stage& stage, int most);
void add_clipped(Stage& stage, int most);

// shared.cpp: triangles that share edges
void add_surface(Stage& stage, int most);
void add_primitives(Stage& stage, int most);
void add_aligned(Stage& stage, int most);

// ties.cpp: triangles of one depth
void add_coplanar(Stage& stage, int most);
void add_crossing(Stage& stage, int most);
void add_stacked(Stage& stage, int most);

// degenerate.cpp: triangles without area
void add_degenerate(Stage& stage, int most);

}  // namespace zproof::random
