/// The second pass where much is open: tiles in which many pixels show different triangles, as surfaces in
/// one plane do, are ruled on tile by tile.
#pragma once

#include <span>

#include "compare/class_map.h"
#include "compare/first_pass/open_tiles.h"
#include "compare/witness.h"

namespace zproof {

/// Decides those of the open pixels that it can, as the admissible set does, and leaves the others; writes
/// classes, which it counts, and findings, in the same bits, where there is a place for each open pixel:
/// `findings` may be empty, or else `open` is numbered. `classes` has the view's size and all tiles open that
/// have open pixels. Runs on all threads.
ClassCounts settle_layers(const Comparands& of, OpenTiles& open, ClassMap& classes,
                          std::span<Finding> findings);

}  // namespace zproof
