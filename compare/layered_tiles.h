/// The second pass where much is open: tiles in which many pixels show different triangles, as surfaces in
/// one plane do, are ruled on row by row.
#pragma once

#include <span>
#include <vector>

#include "compare/agreement.h"

namespace zproof {

/// What came of it.
struct LayeredFindings {
    std::vector<std::uint32_t> left;  ///< places among the open pixels, ascending: still open
    ClassCounts counts{};             ///< of the others
};

/// What is compared.
struct Comparands {
    const Scene& scene;
    const View& view;
    const Witness &candidate, &reference;
};

/// Writes findings and classes of the open pixels that it can decide: what the admissible set says, in the
/// same bits. `open` is in raster order, and verdict.findings has a place for each; verdict.classes has the
/// view's size. Runs on all threads.
LayeredFindings settle_layers(const Comparands& of, std::span<const PixelPlace> open, Verdict& verdict);

}  // namespace zproof
