/// The surfaces of a scene that show an image, in the words of the texture room.
#pragma once

#include "scenes/scene.h"
#include "texture/method.h"

namespace zproof::rasterizer {

/// Every triangle whose base colour shows the image, whatever its material's wraps. The scene must outlive
/// it.
texture::Surface surface_of(const Scene& scene, int image);

/// With what the scene knows of a texture: its wraps, and its surface.
texture::FilterOptions options_for(const Scene& scene, const Texture& texture,
                                   texture::FilterOptions options);

}  // namespace zproof::rasterizer
