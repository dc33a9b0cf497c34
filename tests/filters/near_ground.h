/// Fixtures on which an error of a hundredth of a texel or level can be told from float32 coordinates.
#pragma once

#include "filters/selftest/filter_fixture.h"

namespace zproof {

/// The ground of noise, 256 x 256 pixels: magnified in the lower half, minified in the upper one.
selftest::FilterFixture near_ground();

/// The noise on a wall that faces the camera, 192 x 192 pixels, so many texels of it a pixel.
selftest::FilterFixture head_on_wall(double texels_per_pixel);

}  // namespace zproof
