/// Frames with wrong answers in them.
#pragma once

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"
#include "tests/frozen/random_numbers.h"

namespace zproof::frozen {

/// One renderer's answer at one pixel.
struct Shown {
    PrimitiveId primitive = PrimitiveId::none;
    float depth = background_depth;
};

/// One that is no answer: NaN, a negative depth, an id out of range, background with a depth, and the like.
Shown nonsense(Shown right, std::uint32_t triangle_count, RandomNumbers& numbers);

/// A depth that is wrong by a factor between 1 +- 2^-30 and 2.
float wrong_depth(float right, RandomNumbers& numbers);

/// The frame with some answers replaced, at pixels and in ways that the seed chooses: what a neighbouring
/// pixel shows, any triangle of the scene, background, a wrong depth, nonsense.
Frame with_planted_answers(const Scene& scene, const View& view, const Frame& good, std::uint32_t seed);

}  // namespace zproof::frozen
