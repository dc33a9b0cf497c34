/// The three scenes on which rasterizers are timed.
#pragma once

#include <string>
#include <vector>

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::bench {

struct TimedScene {
    std::string name;
    Scene scene;
    View view;  ///< 1920 x 1080
};

/// A room seen from inside, with balls in it: 12 k triangles, walls around and behind the eye.
TimedScene room();

/// A rippled sheet that fills the view, two triangles per cell: a million of two pixels each where nothing is
/// said.
TimedScene ripples(int columns = 1000, int rows = 500);

/// 200 k triangles everywhere, some 210 pixels each: more than 20 lie behind each other at a pixel.
TimedScene soup();

}  // namespace zproof::bench
