/// A name for the baked scene itself, so that what was said of it can be told from what was said of another.
#pragma once

#include <string>

#include "scenes/scene.h"

namespace zproof {

/// SHA-256, 64 hexadecimal digits, of what the judge judges by: "zproof scene 1\n", the number of vertices,
/// their world positions (three float32 each, by their bits), the number of triangles, their vertex indices;
/// every number as 8 bytes, least significant first, every float and index as 4. Names, materials and
/// textures have no say in which triangle is seen, nor has the camera, and none of them is in it.
std::string sha256_of(const Scene& scene);

}  // namespace zproof
