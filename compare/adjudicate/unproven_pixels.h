/// Where does the reference promise less of a triangle than the candidate? There it proves nothing that both
/// name the same triangle; nor anywhere, where both frames are one (docs/truth.md, "What agreement proves").
#pragma once

#include <array>
#include <cstdint>

#include "compare/rendered_frame.h"
#include "math/affine.h"

namespace zproof {

/// 1 where the reference may see another triangle at the pixel's centre than is there, and the candidate may
/// not; 1 everywhere in two frames of the same bits; 0 elsewhere. Runs on all threads.
Plane<std::uint8_t> find_unproven_pixels(const FramePair& frames);

/// How far beyond its corners a triangle may be shown by edges that are moved outwards so far.
double beyond_corners_px(const std::array<Affine<double>, 3>& edges, double moved_px);

}  // namespace zproof
