/// The area in the world that each texel covers of a scene's surfaces, derived from the scene's floats by
/// halving the texture plane until a piece is one texel, or wholly covered.
#pragma once

#include <vector>

#include "math/interval_functions.h"
#include "scenes/scene.h"

namespace zproof::oracle::filter_reference {

/// Row by row, as shares of the largest, multiples of 2^-24; a share that may round to several has them all.
/// Empty where nothing is covered.
std::vector<Interval> area_shares(const Scene& scene, int image);

}  // namespace zproof::oracle::filter_reference
