/// Texture samplers of others, as they are: each draws the picture itself (docs/filter-peers.md).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "frame/picture.h"
#include "rasterizer/texturing.h"

namespace zproof::study {

struct OtherSampler {
    texture::Method method;             ///< name and card; it prepares no sampler of ours
    std::string (*absence)();           ///< why it cannot be asked on this machine; empty: it can
    std::vector<std::string> settings;  ///< that it heeds, as they are typed
    /// Throws OracleError.
    Picture (*paint)(const Scene& scene, const View& view, const Frame& frame,
                     const texture::FilterOptions& options);
};

/// OpenImageIO's, OpenGL's and Vulkan's.
std::span<const OtherSampler> other_samplers();

/// The sampler of this name, or null.
const OtherSampler* find_other_sampler(const std::string& name);

}  // namespace zproof::study
