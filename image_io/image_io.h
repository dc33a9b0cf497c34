/// Every image file in and out. OpenImageIO does the work, in a module that is loaded when the first image is
/// read or written (image_io/module.h). Files are known by their first bytes, not by their names. Every
/// function throws FrameError, which names the file, what is wrong and what was expected.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "frame/frame.h"
#include "frame/picture.h"

namespace zproof {

/// Has a frame ids? Where they are absent, depths alone are read, and every id is PrimitiveId::none.
enum class IdChannel { present, absent };

/// Reads ids and depths, each value as the file has it: NaN and stray ids pass through. `file` is an OpenEXR,
/// TIFF, PNG or PFM file, or two of them, "IDS+DEPTHS". docs/images.md says which channels and types are
/// read. The frame is the display window; where the file has no data, it is background. Attributes are read
/// from the channels that the file of the depths has (frame/attributes.h).
Frame read_frame(const std::filesystem::path& file, IdChannel ids = IdChannel::present);
/// The size of that frame, from the headers alone.
Resolution frame_size(const std::filesystem::path& file, IdChannel ids = IdChannel::present);
/// OpenEXR with the channels `id` (uint32), `Z` and those of the attributes (float32), bit for bit. The same
/// frame gives the same bytes.
void write_frame(const std::filesystem::path& file, const Frame& frame);

/// Linear light: the channels R, G and B as half or float32. Black where the file has no data.
Picture read_picture(const std::filesystem::path& file, int mip_level = 0);
/// The size of that picture, from the headers alone.
Resolution picture_size(const std::filesystem::path& file);
/// What is said of a file within it: names and values, OpenEXR's string attributes.
using FileFacts = std::vector<std::pair<std::string, std::string>>;
/// OpenEXR with the channels R, G and B (float32), bit for bit.
void write_picture(const std::filesystem::path& file, const Picture& picture, const FileFacts& facts = {});

/// A channel of an OpenEXR file, float32 or uint32. The plane must outlive it.
struct NamedPlane {
    std::string name;
    std::variant<const Plane<float>*, const Plane<std::uint32_t>*> values;
};
/// OpenEXR with these channels, bit for bit; at least one, all of one size.
void write_planes(const std::filesystem::path& file, std::span<const NamedPlane> planes,
                  const FileFacts& facts);

/// An sRGB PNG. The same picture gives the same bytes.
void write_png(const std::filesystem::path& file, const Plane<Rgb8>& picture);
/// A lossy sRGB WebP, for pages of many pictures.
void write_webp(const std::filesystem::path& file, const Plane<Rgb8>& picture);
/// A lossy sRGB JPEG, in a twentieth of a WebP's time.
void write_jpeg(const std::filesystem::path& file, const Plane<Rgb8>& picture);
/// The PNG of write_png() in memory, for pages that embed it.
std::vector<std::byte> encode_png(const Plane<Rgb8>& picture);

/// An image of a texture: 4 bytes per texel, alpha not multiplied in.
struct Rgba8Image {
    Resolution size;
    std::vector<std::uint8_t> rgba;
};
/// Decodes a PNG or JPEG file in memory, of at most `largest_side` texels on either side. 16-bit channels are
/// rounded to 8 bits, grey becomes three equal channels, missing alpha is 255.
Rgba8Image decode_rgba8(std::span<const unsigned char> bytes, int largest_side);
/// Reads a file, be it OpenEXR, TIFF or DDS, and one of its mip levels.
Rgba8Image read_rgba8(const std::filesystem::path& file, int largest_side, int mip_level = 0);

/// How an image lies in its file.
struct StoredImage {
    int mip_levels = 1;  ///< OpenEXR, TIFF and DDS may have more than one
    bool is_real;  ///< half or float32 samples, which are linear light; otherwise integers, which are sRGB
    bool is_of_bytes;  ///< 8-bit samples
};
/// By the headers alone.
StoredImage stored_image(const std::filesystem::path& file);

/// A PNG with 8-bit RGBA, the same texels.
std::vector<std::byte> encode_png(Resolution size, std::span<const std::uint8_t> rgba);

/// 65535 is 1.
using Rgb16 = std::array<std::uint16_t, 3>;
/// Reads a picture with 16-bit R, G and B of exactly this size, as the file has them.
Plane<Rgb16> read_rgb16(const std::filesystem::path& file, Resolution size);
/// A PNG with these values, which are linear light.
std::vector<std::byte> encode_png(const Plane<Rgb16>& picture);

}  // namespace zproof
