#include "filters/commands/level_files.h"

#include <array>
#include <chrono>
#include <cstring>
#include <filesystem>

#include "image_io/image_io.h"
#include "image_io/module.h"
#include "oracle/isolated.h"

namespace zproof {

namespace {

using texture::LinearImage;

constexpr int largest_side = 1 << 15, most_levels = 16;
constexpr oracle::IsolationLimits reading_limits{std::size_t{8} << 30, std::chrono::minutes(10)};

struct LevelPlace {
    std::filesystem::path file;
    int mip_level;
};

/// Where {level} in the name stands for the number.
std::vector<LevelPlace> places_in_files(const std::string& name, const std::string& mark) {
    std::vector<LevelPlace> places;
    for (int level = 1; level <= most_levels; ++level) {
        const std::filesystem::path file =
            std::string{name}.replace(name.find(mark), mark.size(), std::to_string(level));
        if (!std::filesystem::exists(file)) break;
        places.push_back({file, 0});
    }
    return places;
}

std::vector<LevelPlace> places_in_file(const std::filesystem::path& file) {
    std::vector<LevelPlace> places;
    const int count = stored_image(file).mip_levels;
    for (int level = 1; level < count; ++level) places.push_back({file, level});
    return places;
}

LinearImage linear_light(const Picture& picture) {
    LinearImage level{picture.size().width, picture.size().height, {}};
    for (const LinearRgb& pixel : picture.pixels())
        level.texels.emplace_back(pixel.r, pixel.g, pixel.b, 1.0f);
    return level;
}

LinearImage read_level(const LevelPlace& place) {
    if (stored_image(place.file).is_real) return linear_light(read_picture(place.file, place.mip_level));
    const Rgba8Image image = read_rgba8(place.file, largest_side, place.mip_level);
    return texture::linear_image({image.size.width, image.size.height, image.rgba});
}

using Size = std::array<int, 2>;

void append(oracle::Bytes& bytes, const void* from, std::size_t count) {
    const auto* first = static_cast<const std::byte*>(from);
    bytes.insert(bytes.end(), first, first + count);
}

oracle::Bytes to_bytes(const LinearImage& level, oracle::Bytes bytes) {
    const Size size{level.width, level.height};
    append(bytes, size.data(), sizeof size);
    append(bytes, level.texels.data(), level.texels.size() * sizeof(glm::vec4));
    return bytes;
}

std::vector<LinearImage> from_bytes(const oracle::Bytes& bytes) {
    std::vector<LinearImage> levels;
    for (std::size_t at = 0; at < bytes.size();) {
        Size size{};
        std::memcpy(size.data(), &bytes[at], sizeof size);
        at += sizeof size;
        LinearImage& level = levels.emplace_back(LinearImage{size[0], size[1], {}});
        level.texels.resize(std::size_t(size[0]) * std::size_t(size[1]));
        std::memcpy(level.texels.data(), &bytes[at], level.texels.size() * sizeof(glm::vec4));
        at += level.texels.size() * sizeof(glm::vec4);
    }
    return levels;
}

}  // namespace

/// In a process of its own, since readers of images may crash.
std::shared_ptr<const std::vector<LinearImage>> levels_from_files(const std::string& name) {
    const std::string mark = "{level}";
    const bool is_in_files = name.find(mark) != std::string::npos;
    if (!is_in_files && !std::filesystem::exists(name)) return nullptr;
    image_io::load_module();
    std::vector<LinearImage> levels = from_bytes(oracle::isolated(name, reading_limits, [&] {
        oracle::Bytes all;
        for (const LevelPlace& place : is_in_files ? places_in_files(name, mark) : places_in_file(name))
            all = to_bytes(read_level(place), std::move(all));
        return all;
    }));
    if (levels.empty()) return nullptr;
    return std::make_shared<const std::vector<LinearImage>>(std::move(levels));
}

}  // namespace zproof
