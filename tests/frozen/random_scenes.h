/// Small scenes from a seed, of the kinds that have led judges astray before.
#pragma once

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"
#include "tests/frozen/random_numbers.h"

namespace zproof::frozen {

/// A scene and a view of it of up to 16 x 16 pixels, perspective or parallel, plain (one unit is one pixel)
/// or turned and off its axis.
struct RandomScene {
    Scene scene;
    View view;
};

/// Seed after seed the next kind: triangles in one plane; occluders that abut along a line on which their
/// corners differ; slivers; many edges that meet in one corner; triangles, and sheets, cut by near and far;
/// planes seen edge-on; planes that cross; and two of these in one scene.
RandomScene random_scene(std::uint32_t seed);

/// Answers for every pixel of it: mostly what is seen near the pixel's centre, some from anywhere, some
/// depths wrong, a few no answers at all.
Frame random_answers(const RandomScene& of, RandomNumbers& numbers);

}  // namespace zproof::frozen
