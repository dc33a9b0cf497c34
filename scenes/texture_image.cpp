#include "scenes/texture_image.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "frame/number_text.h"
#include "image_io/image_io.h"
#include "image_io/module.h"
#include "math/srgb.h"
#include "scenes/limits.h"

namespace zproof {
namespace {

using Span = std::span<const unsigned char>;

constexpr std::array<unsigned char, 8> png_magic{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

std::uint64_t big_endian(Span bytes, std::size_t at, std::size_t length) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < length; ++i) value = value << 8 | bytes[at + i];
    return value;
}

bool is_png(Span bytes) {
    return bytes.size() >= 33 && std::equal(png_magic.begin(), png_magic.end(), bytes.begin());
}

bool is_jpeg(Span bytes) {
    return bytes.size() >= 4 && bytes[0] == 0xFF && bytes[1] == 0xD8 && bytes[2] == 0xFF;
}

/// Start-of-frame markers: C0 to CF but for DHT (C4), JPG (C8) and DAC (CC).
bool is_frame(unsigned char marker) {
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

/// Height and width stand 3 bytes behind the length of the start-of-frame segment.
std::optional<ImageExtent> jpeg_extent(Span bytes) {
    std::size_t at = 2;
    while (at + 9 <= bytes.size() && bytes[at] == 0xFF) {
        const unsigned char marker = bytes[at + 1];
        if (is_frame(marker))
            return ImageExtent{ImageExtent::Format::jpeg, big_endian(bytes, at + 7, 2),
                               big_endian(bytes, at + 5, 2)};
        at += marker == 0xFF ? 1 : 2 + big_endian(bytes, at + 2, 2);
    }
    return std::nullopt;
}

std::optional<ImageExtent> extent_of(Span bytes) {
    if (is_png(bytes))
        return ImageExtent{ImageExtent::Format::png, big_endian(bytes, 16, 4), big_endian(bytes, 20, 4)};
    return is_jpeg(bytes) ? jpeg_extent(bytes) : std::nullopt;
}

/// Compressed bytes of a PNG. Deflate never needs more than 0.1 % above the raw size, so a surplus is no
/// image.
std::uint64_t png_data_bytes(Span bytes) {
    std::uint64_t sum = 0;
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        const std::uint64_t length = big_endian(bytes, at, 4);
        if (big_endian(bytes, at + 4, 4) == 0x49444154) sum += length;
        at += 12 + length;
    }
    return sum;
}

int jpeg_scan_count(Span bytes) {
    int scans = 0;
    for (std::size_t i = 0; i + 1 < bytes.size(); ++i) scans += bytes[i] == 0xFF && bytes[i + 1] == 0xDA;
    return scans;
}

}  // namespace

std::string image_fault(Span bytes) {
    const std::optional<ImageExtent> extent = extent_of(bytes);
    if (!extent) return "expected a PNG or JPEG image; convert it";
    const auto [format, width, height] = *extent;
    const std::string size = size_text(width, height);
    if (width == 0 || height == 0)
        return "the image is " + size + " texels, expected one at least; export it again";
    if (width > limits::image_side || height > limits::image_side || width * height > limits::image_texels)
        return "the image claims " + size + " texels; at most " + std::to_string(limits::image_side) +
               " per side and " + std::to_string(limits::image_texels) + " in all: scale it down";
    if (format == ImageExtent::Format::png && png_data_bytes(bytes) > width * height * 8 + height + (1 << 16))
        return "the PNG holds more data than " + size + " texels need; export it again";
    if (format == ImageExtent::Format::jpeg && jpeg_scan_count(bytes) > limits::jpeg_scans)
        return "the JPEG has more than " + std::to_string(limits::jpeg_scans) +
               " scans; save it as a baseline JPEG";
    return {};
}

ImageExtent image_extent(Span bytes) { return extent_of(bytes).value(); }

namespace {

constexpr const char* broken = "the image's data is broken or cut short; export it again";

/// libpng would print its complaint on stderr, without a file's name.
std::string png_chunk_fault(Span bytes) {
    constexpr std::uint64_t end_chunk = 0x49454E44;  // IEND
    for (std::size_t at = png_magic.size(); at + 12 <= bytes.size();) {
        const std::uint64_t length = big_endian(bytes, at, 4), type = big_endian(bytes, at + 4, 4);
        if (length > bytes.size() - at - 12) break;
        const bool is_critical = (bytes[at + 4] & 0x20) == 0;
        const auto sum = crc32_z(0, bytes.data() + at + 4, length + 4);
        if (is_critical && sum != big_endian(bytes, at + 8 + length, 4)) return "a chunk's sum is wrong";
        if (type == end_chunk) return "";
        at += 12 + length;
    }
    return "the PNG ends too early";
}

}  // namespace

namespace {

/// What has no number of codes is beyond their range.
std::uint8_t code_of(float light) { return std::uint8_t(std::lround(255 * encoded_srgb(double{light}))); }

Image image_of_light(const Picture& picture) {
    Image image{{}, picture.size().width, picture.size().height, {}, {}};
    for (const LinearRgb& c : picture.pixels()) {
        if (!std::isfinite(c.r + c.g + c.b))
            throw std::runtime_error("a texel is no finite number; paint it over");
        image.light.emplace_back(c.r, c.g, c.b, 1.0f);
        for (const float channel : {c.r, c.g, c.b}) image.texels.push_back(code_of(channel));
        image.texels.push_back(255);
    }
    return image;
}

}  // namespace

bool is_texture_of_floats(const std::filesystem::path& file) {
    return stored_image(file).is_real;
}

Image texture_in(const std::filesystem::path& file) {
    if (is_texture_of_floats(file)) return image_of_light(read_picture(file));
    Rgba8Image image = read_rgba8(file, limits::image_side);
    return {{}, image.size.width, image.size.height, std::move(image.rgba), {}};
}

Image decode_image(Span bytes) {
    image_io::module();  // what it lacks is no fault of the image
    try {
        if (const std::string fault = is_png(bytes) ? png_chunk_fault(bytes) : ""; !fault.empty())
            throw std::runtime_error(fault);
        Rgba8Image decoded = decode_rgba8(bytes, limits::image_side);
        return {{}, decoded.size.width, decoded.size.height, std::move(decoded.rgba), {}};
    } catch (const std::runtime_error& e) {
        throw std::runtime_error(std::string(broken) + " (" + e.what() + ")");
    }
}

}  // namespace zproof
