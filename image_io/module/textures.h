/// The part of ModuleTable that is about textures.
#pragma once

#include "image_io/module_table.h"

namespace zproof::image_io {

Textures* open_textures();
void close_textures(Textures* textures);
int add_texture(Textures& textures, const std::string& folder, const Texels& texels);
std::array<float, 3> look_up(const Textures& textures, const TextureLookup& lookup);

}  // namespace zproof::image_io
