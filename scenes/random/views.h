/// Views of random scenes: small, and seldom plain. All are judged (scenes/judged_ranges.h).
#pragma once

#include "scenes/suite/random.h"
#include "scenes/view.h"

namespace zproof::random {

/// Perspective, orthographic or oblique: fields of view from 1e-9 to 1e4, windows beside the axis, pixels
/// that are not square, rolled axes, an eye at 1e6, near from 1e-6, far up to infinity, or just behind near.
View any_view(suite::Random& dice);

/// How far from the world's origin, in scene units.
double largest_coordinate(const glm::vec3& eye_world);

/// Does float32 know where its rays pass, to 2^-10 px at the near plane? Of others each pixel may
/// show each triangle, which takes a judge long where these are many.
bool is_resolved(const View& view);

/// One whose pixel centres and corners are seen at points that float32 holds, at depths of few bits.
View aligned_view(suite::Random& dice);

}  // namespace zproof::random
