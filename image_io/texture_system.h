/// OpenImageIO's TextureSystem as it is: its own mip chains, its own filters.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <span>

#include "frame/plane.h"
#include "image_io/module_table.h"

namespace zproof::image_io {

class TextureSystem {
  public:
    /// Keeps its textures as files in this folder, which must outlive the object. Throws FrameError as
    /// module().
    explicit TextureSystem(std::filesystem::path folder);

    /// Makes a texture of float32 R, G and B, linear light, with a chain of means; how many were made before.
    /// Throws FrameError in OpenImageIO's words.
    int add(Resolution size, std::span<const float> rgb);
    /// May be asked from many threads. Throws FrameError in OpenImageIO's words.
    std::array<float, 3> look_up(const TextureLookup& lookup) const;

  private:
    std::filesystem::path folder_;
    std::unique_ptr<Textures, void (*)(Textures*)> textures_;
};

}  // namespace zproof::image_io
