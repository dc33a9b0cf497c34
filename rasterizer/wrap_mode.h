/// A scene's sampler in the words of the texture room.
#pragma once

#include "scenes/scene.h"
#include "texture/texels.h"

namespace zproof::rasterizer {

inline texture::Wrap wrap_of(Wrap wrap) {
    if (wrap == Wrap::clamp_to_edge) return texture::Wrap::clamp_to_edge;
    return wrap == Wrap::repeat ? texture::Wrap::repeat : texture::Wrap::mirrored_repeat;
}

inline texture::Addressing addressing_of(const Sampler& sampler) {
    return {wrap_of(sampler.wrap_u), wrap_of(sampler.wrap_v)};
}

}  // namespace zproof::rasterizer
