/// Which pixels POV-Ray is asked about where nobody asks for all: as many as a known price buys.
#pragma once

#include <cstdint>
#include <string>

#include "scenes/pixel_lattice.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

struct AffordablePixels {
    PixelLattice lattice;
    std::string fewer_because;  ///< why they are fewer than in other views; empty: they are not
    double seconds = 0;         ///< of one core, about, for reading and tracing
};

/// What POV-Ray takes to start and to end, which it mostly sleeps through.
inline constexpr double povray_start_s = 0.7;

/// About 57,600 pixels at most (320 x 180), and fewer where the view's triangles make POV-Ray slow: the
/// densest of some lattices whose estimated work is below two seconds of one core. The estimate counts the
/// triangles that its rays can meet, for reading them, and the boxes around them at every ray, for tracing.
/// It knows no clock: a view has the same lattice on every machine. Its first pixel is drawn by the seed.
/// Throws OracleError where reading the triangles alone is too much, and as povray_geometry.
AffordablePixels affordable_pixels(const Scene& scene, const View& view, std::uint64_t seed);

}  // namespace zproof::oracle
