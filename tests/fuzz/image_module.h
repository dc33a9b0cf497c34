/// Loads OpenImageIO before the first input, which is not to be charged for it.
#pragma once

#include "image_io/module.h"

namespace zproof::fuzz {

inline const bool image_module_is_loaded = (image_io::load_module(), true);

}  // namespace zproof::fuzz
