/// What the module offers to the program. Only this header is shared by both: the program knows nothing of
/// OpenImageIO, and the module knows no other room. Functions throw std::runtime_error with OpenImageIO's
/// words.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace zproof::image_io {

enum class Format { unknown, exr, tiff, png, jpeg, pfm, dds, npy };

/// Type of a sample as it lies in the file; `other` is none that zproof reads.
enum class Sample { uint8, uint16, uint32, half, float32, int32, int64, float64, other };

struct Channel {
    std::string name;
    Sample sample = Sample::other;
};

/// Pixels x to x + width - 1, rows y to y + height - 1.
struct Window {
    int x = 0, y = 0, width = 0, height = 0;
};

enum class Samples { flat, deep };

/// The header of one image of a file: a part of OpenEXR, a page of TIFF.
struct Part {
    std::string name;  ///< empty where it has none
    Window data, display;
    Samples samples = Samples::flat;
    int rows_at_once = 1;  ///< reads begin at a multiple of it, counted from the data window's top
    std::vector<Channel> channels;
    int mip_levels = 1;   ///< at most most_mip_levels are counted
    int scaled_bits = 0;  ///< of a sample in the file, where reading scales it to its type; else 0
};
inline constexpr int most_mip_levels = 32;

/// A file, or its bytes where there are any.
struct Source {
    Format format = Format::unknown;
    std::string path;
    std::span<const unsigned char> bytes;
    int mip_level = 0;  ///< that headers and samples are asked of
};

/// Rows of the data window, counted from its top, and neighbouring channels.
struct Block {
    int part = 0;
    int first_row = 0, row_count = 0;
    int first_channel = 0, channel_count = 0;
};

enum class Light { linear, srgb };

/// One flat image with its pixels, packed: row by row, pixel by pixel, channel by channel.
struct Raster {
    Format format = Format::exr;
    Light light = Light::linear;
    int width = 0, height = 0;
    std::vector<Channel> channels;
    const void* pixels = nullptr;
    std::vector<std::pair<std::string, std::string>>
        facts{};  ///< of OpenEXR files: attributes and their values
};

class OpenFile;  ///< the module's own

/// Float32 R, G and B, row by row.
struct Texels {
    int width = 0, height = 0;
    const float* rgb = nullptr;
};

enum class Repeat { repeat, clamp, mirror };
enum class MipMode { none, trilinear, anisotropic };

/// A place in a texture, where the image is the unit square, and the steps to the neighbouring pixels.
struct TextureLookup {
    int texture = 0;
    Repeat along_s = Repeat::repeat, along_t = Repeat::repeat;
    MipMode mip = MipMode::none;
    int max_anisotropy = 16;
    float s = 0, t = 0, ds_per_x = 0, dt_per_x = 0, ds_per_y = 0, dt_per_y = 0;
    /// In [0, 1): it chooses one level and one probe instead of all. Negative: all are read.
    float random = -1;
};

class Textures;  ///< the module's own

/// An interface of another number is not used.
inline constexpr int interface_number = 7;

struct ModuleTable {
    int interface = interface_number;
    OpenFile* (*open)(const Source& source) = nullptr;
    void (*close)(OpenFile* file) = nullptr;
    /// The headers of all images in the file that have the mip level.
    std::vector<Part> (*parts)(OpenFile& file) = nullptr;
    /// The samples of a block in their own types, packed as in Raster.
    void (*read)(OpenFile& file, const Block& block, void* to) = nullptr;
    /// The bytes of a file.
    std::vector<unsigned char> (*encode)(const Raster& raster) = nullptr;

    /// OpenImageIO's TextureSystem (image_io/texture_system.h).
    Textures* (*open_textures)() = nullptr;
    void (*close_textures)(Textures* textures) = nullptr;
    int (*add_texture)(Textures& textures, const std::string& folder, const Texels& texels) = nullptr;
    std::array<float, 3> (*look_up)(const Textures& textures, const TextureLookup& lookup) = nullptr;
};

/// The module's only symbol, extern "C".
using TableFunction = const ModuleTable* (*)();
inline constexpr const char* table_function_name = "zproof_image_io";

}  // namespace zproof::image_io
