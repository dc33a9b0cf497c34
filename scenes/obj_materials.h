/// Materials of Wavefront OBJ (MTL files).
#pragma once

#include <filesystem>
#include <string>

#include "scenes/scene.h"

namespace zproof {

/// Appends the materials of an MTL file that the line at `place` names: Kd as the base colour's linear
/// factor, map_Kd as its texture where that is a PNG or JPEG. What cannot be read is noted, and white.
void read_obj_materials(const std::filesystem::path& file, const std::string& place, std::string name,
                        Scene& scene);

}  // namespace zproof
