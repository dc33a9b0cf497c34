/// What a file of a renderer must keep to before anything of it is allocated.
#pragma once

#include <cstddef>
#include <filesystem>

#include "frame/plane.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// Of headers and of the libraries that read them.
inline constexpr std::size_t reader_memory_bytes = std::size_t{256} << 20;

/// Throws FrameError, naming both sizes.
void refuse_other_size(const std::filesystem::path& file, Resolution size, const View& view);

}  // namespace zproof::oracle
