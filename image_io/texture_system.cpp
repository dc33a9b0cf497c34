#include "image_io/texture_system.h"

#include <cassert>
#include <stdexcept>
#include <string>
#include <utility>

#include "frame/frame_error.h"
#include "image_io/module.h"

namespace zproof::image_io {
namespace {

[[noreturn]] void refuse(const std::runtime_error& e) {
    throw FrameError(std::string("OpenImageIO's TextureSystem: ") + e.what());
}

}  // namespace

TextureSystem::TextureSystem(std::filesystem::path folder)
    : folder_(std::move(folder)), textures_(module().open_textures(), module().close_textures) {}

int TextureSystem::add(Resolution size, std::span<const float> rgb) {
    assert(rgb.size() == 3 * size.pixel_count());
    try {
        return module().add_texture(*textures_, folder_.string(), {size.width, size.height, rgb.data()});
    } catch (const std::runtime_error& e) {
        refuse(e);
    }
}

std::array<float, 3> TextureSystem::look_up(const TextureLookup& lookup) const {
    try {
        return module().look_up(*textures_, lookup);
    } catch (const std::runtime_error& e) {
        refuse(e);
    }
}

}  // namespace zproof::image_io
