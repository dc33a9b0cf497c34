/// The textures of a frame, filtered: what is seen is known already, here is its base colour.
#pragma once

#include "frame/frame.h"
#include "frame/picture.h"
#include "rasterizer/texel_map.h"
#include "texture/method.h"

namespace zproof::rasterizer {

/// How textures are read.
struct Texturing {
    texture::Method method;
    texture::FilterOptions options{};  ///< `addressing` and `surface` are the scene's own
    texture::Derivatives derivatives = texture::Derivatives::analytic;
    UvInterpolation uv = UvInterpolation::perspective;
};

/// Every pixel's base colour without light: factor x filtered texture, linear; no vertex colours, no alpha.
/// Background is black; what has no texture shows its factor. The footprint is that of the plane of the seen
/// triangle. On the threads of the surrounding tbb::task_arena; ids must be triangles of the scene, or none.
Picture filtered(const Scene& scene, const View& view, const Frame& frame, const Texturing& texturing);

}  // namespace zproof::rasterizer
