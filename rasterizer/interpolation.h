/// Attributes over the triangles that a frame shows.
#pragma once

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// The attributes that the scene has, perspective-correct at the pixels' centres, in double and rounded once.
/// Normals are brought to unit length, but for those of length 0. Zeros where the frame shows background.
Attributes attributes_of(const Scene& scene, const View& view, const Frame& frame);

}  // namespace zproof::rasterizer
