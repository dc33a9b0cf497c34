/// Texture samplers of others, as they are: each draws the picture itself (docs/filter-peers.md).
#pragma once

#include <span>
#include <string>

#include "frame/picture.h"
#include "rasterizer/texturing.h"

namespace zproof::study {

struct OtherSampler {
    texture::Method method;    ///< name and card; it prepares no sampler of ours
    std::string (*absence)();  ///< why it cannot be asked on this machine; empty: it can
    /// Heeds only max_anisotropy of the settings. Throws OracleError.
    Picture (*paint)(const Scene& scene, const View& view, const Frame& frame, int max_anisotropy);
};

/// oiio-trilinear, oiio-aniso, opengl-trilinear, opengl-aniso.
std::span<const OtherSampler> other_samplers();

/// The sampler of this name, or null.
const OtherSampler* find_other_sampler(const std::string& name);

}  // namespace zproof::study
