/// A picture by the texture sampler of a graphics API: each pixel hands over the place that it sees, and its
/// steps, in float32.
#pragma once

#include <functional>

#include "frame/frame.h"
#include "frame/picture.h"
#include "oracle/vulkan_textures.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// RGBA of each pixel. A place has 1 in z where the pixel sees the texture.
using TextureSampler = std::function<Plane<glm::vec4>(const Image&, const Sampler&, const TextureLookups&)>;

/// Base colour factor x what the sampler gives, linear, black where nothing is seen.
Picture picture_by_sampler(const Scene& scene, const View& view, const Frame& frame,
                           const TextureSampler& sample);

}  // namespace zproof::oracle
