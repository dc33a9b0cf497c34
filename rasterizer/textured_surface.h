/// The surfaces of a scene that show an image, in the words of the texture room.
#pragma once

#include "scenes/scene.h"
#include "texture/method.h"
#include "texture/texels.h"

namespace zproof::rasterizer {

/// Every triangle whose base colour shows the image, whatever its material's wraps. The scene must outlive
/// it.
texture::Surface surface_of(const Scene& scene, int image);

/// With what the scene knows of a texture: its wraps, and its surface.
texture::FilterOptions options_for(const Scene& scene, const Texture& texture,
                                   texture::FilterOptions options);

inline texture::Wrap wrap_of(Wrap wrap) {
    if (wrap == Wrap::clamp_to_edge) return texture::Wrap::clamp_to_edge;
    return wrap == Wrap::repeat ? texture::Wrap::repeat : texture::Wrap::mirrored_repeat;
}

inline texture::Addressing addressing_of(const Sampler& sampler) {
    return {wrap_of(sampler.wrap_u), wrap_of(sampler.wrap_v)};
}

}  // namespace zproof::rasterizer
