#include "cli/given_levels.h"

#include <filesystem>

#include "frame/frame_error.h"
#include "frame/whole_file.h"
#include "image_io/image_io.h"

namespace zproof {

namespace {

constexpr int largest_side = 1 << 15, most_levels = 16;

texture::LinearImage linear_light(const std::filesystem::path& file) {
    const Picture picture = read_picture(file);
    texture::LinearImage level{picture.size().width, picture.size().height, {}};
    for (const LinearRgb& pixel : picture.pixels())
        level.texels.emplace_back(pixel.r, pixel.g, pixel.b, 1.0f);
    return level;
}

texture::LinearImage decoded(const std::filesystem::path& file) {
    const std::string bytes = content_of(file);
    const std::vector<unsigned char> encoded(bytes.begin(), bytes.end());
    try {
        const Rgba8Image image = decode_rgba8(encoded, largest_side);
        return texture::linear_image({image.size.width, image.size.height, image.rgba});
    } catch (const std::runtime_error& e) {
        throw FrameError(file.string() + ": " + e.what());
    }
}

}  // namespace

std::shared_ptr<const std::vector<texture::LinearImage>> given_levels(const std::string& name) {
    const std::string mark = "{level}";
    const std::size_t at = name.find(mark);
    if (at == std::string::npos) return nullptr;
    std::vector<texture::LinearImage> levels;
    for (int level = 1; level <= most_levels; ++level) {
        const std::filesystem::path file = std::string{name}.replace(at, mark.size(), std::to_string(level));
        if (!std::filesystem::exists(file)) break;
        levels.push_back(file.extension() == ".exr" ? linear_light(file) : decoded(file));
    }
    if (levels.empty()) return nullptr;
    return std::make_shared<const std::vector<texture::LinearImage>>(std::move(levels));
}

}  // namespace zproof
