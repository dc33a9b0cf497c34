/// Attributes over the triangles that a frame shows.
#pragma once

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// How values are blended between the corners.
enum class Interpolation {
    perspective_correct,
    affine,  ///< in the image, as if depth did not matter: wrong for perspectives
};

/// Barycentrics, world positions and, where the scene has them, texture coordinates at the pixels' centres,
/// in double and rounded once. Zeros where the frame shows background.
Attributes attributes_of(const Scene& scene, const View& view, const Frame& frame,
                         Interpolation interpolation = Interpolation::perspective_correct);

}  // namespace zproof::rasterizer
