#include "scenes/png_encoder.h"

#include <zlib.h>

#include <new>

#include "scenes/scene_error.h"

namespace zproof {

namespace {

std::string big_endian(std::uint32_t value) {
    std::string bytes(4, '\0');
    for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> (24 - 8 * i) & 0xFF);
    return bytes;
}

const Bytef* as_bytes(const std::string& text) { return reinterpret_cast<const Bytef*>(text.data()); }

/// Length, type, data, and the CRC of type and data.
std::string chunk(const std::string& type, const std::string& data) {
    const std::string typed = type + data;
    const auto checksum = static_cast<std::uint32_t>(crc32_z(0, as_bytes(typed), typed.size()));
    return big_endian(static_cast<std::uint32_t>(data.size())) + typed + big_endian(checksum);
}

std::string deflated(const std::string& plain) {
    uLongf size = compressBound(plain.size());
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, as_bytes(plain), plain.size(), 6) != Z_OK)
        throw std::bad_alloc();
    packed.resize(size);
    return packed;
}

/// Every row starts with the number of its filter: 0, none.
std::string scanlines(const Image& image) {
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(image.width);
    std::string rows;
    rows.reserve((row_bytes + 1) * static_cast<std::size_t>(image.height));
    for (auto row = image.texels.begin(); row != image.texels.end();
         row += static_cast<std::ptrdiff_t>(row_bytes)) {
        rows.push_back('\0');
        rows.append(row, row + static_cast<std::ptrdiff_t>(row_bytes));
    }
    return rows;
}

}  // namespace

std::string encode_png(const Image& image) {
    if (image.width < 1 || image.height < 1 ||
        image.texels.size() !=
            4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
        throw SceneError("image '" + image.name + "': " + std::to_string(image.texels.size()) +
                         " bytes of texels, expected 4 x " + std::to_string(image.width) + " x " +
                         std::to_string(image.height));
    const std::string eight_bit_rgba{8, 6, 0, 0,
                                     0};  // depth, colour type, deflate, adaptive filters, no interlace
    return "\x89PNG\r\n\x1A\n" +
           chunk("IHDR", big_endian(static_cast<std::uint32_t>(image.width)) +
                             big_endian(static_cast<std::uint32_t>(image.height)) + eight_bit_rgba) +
           chunk("IDAT", deflated(scanlines(image))) + chunk("IEND", "");
}

}  // namespace zproof
