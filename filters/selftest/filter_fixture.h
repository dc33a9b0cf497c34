/// The fixtures that filter faults are injected into: a textured ground seen to the horizon.
#pragma once

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::selftest {

/// What lies on the ground.
enum class Ground {
    noise,      ///< 128 x 128 texels of coloured noise, repeated
    odd_sizes,  ///< 107 x 61 texels of coloured noise: no level's size is the half of the one before
    mirrored,   ///< the noise, mirrored in u and clamped in v
    turned,     ///< the noise, turned by 30 degrees by its texture transform
};

/// A scene, its view of 120 x 96 pixels, and what its pixels see.
struct FilterFixture {
    Scene scene;
    View view;
    Frame frame;
};

/// The ground from a height of one unit, pitched down by 20 degrees; the footprints' longer axes are 0.2 to
/// several hundred texels long.
FilterFixture filter_fixture(Ground ground);

}  // namespace zproof::selftest
