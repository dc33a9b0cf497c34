/// The module with OpenImageIO in it, loaded when it is first asked for. A program that reads no image never
/// pays for OpenImageIO's 260 shared libraries.
#pragma once

#include <filesystem>

#include "image_io/module_table.h"

namespace zproof::image_io {

/// Loads the module on the first call. It is the file that the environment variable ZPROOF_IMAGE_IO names, or
/// else zproof_image_io.so where the program's run path leads (cmake/zproof_install.cmake). Throws
/// FrameError, with the loader's words, where it cannot be loaded.
const ModuleTable& module();

/// Loads it beforehand, for copies of this process. Leaves errors to whoever needs it.
void load_module();
/// The same, where an image in this file, or in one of two of a frame, needs it.
void load_module_for(const std::filesystem::path& image);

}  // namespace zproof::image_io
