/// Views as JSON text, exactly: view files (docs/view-file.md) and cameras (docs/renderer-contract.md).
#pragma once

#include <span>
#include <string>

#include "scenes/view.h"

namespace zproof {

/// The text with every character that a view's name may not have replaced by '_'; never empty, at most 64
/// long.
std::string view_name(const std::string& text);

/// The view file that judges the glTF file `scene` (a path from the view file's folder) from these views;
/// load_view_file gives back their bits.
std::string view_document(const std::string& scene, std::span<const View> views);

/// One view as renderers are told of it: its entry of a view file, and the matrices that follow from it, in
/// double, given by rows (p_camera = camera_from_world p_world, and so on).
std::string camera_document(const View& view);

}  // namespace zproof
