/// Views as the text of a view file (docs/view-file.md), exactly.
#pragma once

#include <span>
#include <string>

#include "scenes/view.h"

namespace zproof {

/// The view file that judges the glTF file `scene` (a path from the view file's folder) from these views;
/// load_view_file gives back their bits.
std::string view_document(const std::string& scene, std::span<const View> views);

}  // namespace zproof
