/// The second pass where much is open: tiles in which many pixels show different triangles, as surfaces in
/// one plane do, are ruled on tile by tile.
#pragma once

#include <span>
#include <vector>

#include "compare/class_map.h"
#include "compare/first_pass/open_tiles.h"
#include "compare/witness.h"

namespace zproof {

/// What came of it.
struct LayeredFindings {
    std::vector<PixelPlace> left;       ///< still open, in raster order
    std::vector<std::uint32_t> places;  ///< theirs among all that were open
    ClassCounts counts{};               ///< of the others
};

/// Decides those of the open pixels that it can, as the admissible set does, and writes their classes; and
/// their findings, in the same bits, where there is a place for each open pixel; `findings` may be empty.
/// `classes` has the view's size and all tiles open that have open pixels; `open` is numbered. Runs on all
/// threads.
LayeredFindings settle_layers(const Comparands& of, const OpenTiles& open, ClassMap& classes,
                              std::span<Finding> findings);

}  // namespace zproof
