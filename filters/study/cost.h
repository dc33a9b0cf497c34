/// What a method costs: counted by its own taps, timed on one thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "filters/study/results.h"
#include "filters/study/surface_map.h"
#include "rasterizer/texturing.h"
#include "texture/linear_image.h"

namespace zproof::study {

/// A scene's textures, decoded once for all methods.
struct SourceTexture {
    texture::LinearImage image;
    texture::Addressing addressing;
    texture::Surface surface{};

    texture::FilterOptions with(texture::FilterOptions options) const {
        options.addressing = addressing;
        options.surface = surface;
        return options;
    }
};
using SourceTextures = std::vector<std::optional<SourceTexture>>;  ///< by material

/// The scene must outlive them.
SourceTextures source_textures(const Scene& scene);

/// "512 x 512, 640 x 427": each size once.
std::string sizes_of(const SourceTextures& textures);

/// Counts are the same every time; times are not.
Cost cost_of(const rasterizer::Texturing& texturing, const SourceTextures& textures,
             std::span<const Lookup> lookups);

}  // namespace zproof::study
