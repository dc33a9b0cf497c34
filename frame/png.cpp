#include "frame/png_kinds.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <string>
#include <string_view>

#include "frame/deflate.h"
#include "frame/frame_size.h"
#include "frame/whole_file.h"

namespace zproof {
namespace {

static_assert(sizeof(Rgb8) == 3, "pixels are written as packed RGB");

constexpr char filter_none = 0, filter_up = 2;  // W3C PNG, 9.2

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 0xFF);
    return bytes;
}

/// Length, type, content, and the CRC of type and content.
void add_chunk(std::string& png, std::string_view type, std::string_view content) {
    png += big_endian(static_cast<std::uint32_t>(content.size()));
    png.append(type).append(content);
    png += big_endian(crc32_of(content, crc32_of(type)));
}

/// Rows of `stride` bytes, each behind the number of its filter.
struct FilteredRows {
    std::unique_ptr<char[]> bytes;
    std::size_t size;
};

FilteredRows filtered(std::string_view pixels, std::size_t stride, PngRows how) {
    const std::size_t height = pixels.size() / stride, size = (stride + 1) * height;
    FilteredRows rows{std::make_unique_for_overwrite<char[]>(size), size};
    for (std::size_t y = 0; y < height; ++y) {
        const char* from = pixels.data() + y * stride;
        char* to = rows.bytes.get() + y * (stride + 1);
        const bool has_upper = y > 0 && how == PngRows::less_the_upper;
        *to++ = has_upper ? filter_up : filter_none;
        for (std::size_t i = 0; has_upper && i < stride; ++i)
            to[i] = static_cast<char>(from[i] - (from - stride)[i]);
        if (!has_upper) std::copy_n(from, stride, to);
    }
    return rows;
}

/// Colour type: 2 for RGB, 3 for indices into `palette` (else empty).
struct Layout {
    Resolution size;
    char colour_type = 2;
    std::string_view palette;
    PngRows rows = PngRows::as_they_are;
};

std::string png_of(const Layout& layout, std::string_view pixels, const std::string& place) {
    refuse_bad_size(layout.size, place);
    const auto [width, height] = layout.size;
    const std::string header = big_endian(static_cast<std::uint32_t>(width)) +
                               big_endian(static_cast<std::uint32_t>(height)) + '\x08' + layout.colour_type +
                               std::string(3, '\0');  // 8 bits; deflate, adaptive filters, no interlace
    const FilteredRows rows = filtered(pixels, pixels.size() / static_cast<std::size_t>(height), layout.rows);
    std::string png = "\x89PNG\r\n\x1A\n";
    add_chunk(png, "IHDR", header);
    add_chunk(png, "sRGB", std::string(1, '\0'));
    if (!layout.palette.empty()) add_chunk(png, "PLTE", layout.palette);
    add_chunk(png, "IDAT", deflated({rows.bytes.get(), rows.size}));
    add_chunk(png, "IEND", "");
    return png;
}

std::string png_of(const Plane<Rgb8>& picture, PngRows rows, const std::string& place) {
    return png_of({.size = picture.size(), .palette = {}, .rows = rows}, bytes_in(picture.pixels()), place);
}

}  // namespace

void write_png(const std::filesystem::path& file, const Plane<Rgb8>& picture) {
    write_png(file, picture, PngRows::as_they_are);
}

void write_png(const std::filesystem::path& file, const Plane<Rgb8>& picture, PngRows rows) {
    write_whole_file(file, png_of(picture, rows, file.string()));
}

void write_png(const std::filesystem::path& file, const Plane<std::uint8_t>& indices,
               std::span<const Rgb8> colours) {
    assert(!colours.empty() && colours.size() <= 256);
    const Layout layout{.size = indices.size(), .colour_type = 3, .palette = bytes_in(colours)};
    write_whole_file(file, png_of(layout, bytes_in(indices.pixels()), file.string()));
}

std::vector<std::byte> encode_png(const Plane<Rgb8>& picture) {
    const std::string bytes = png_of(picture, PngRows::as_they_are, "PNG in memory");
    const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
    return {first, first + bytes.size()};
}

}  // namespace zproof
