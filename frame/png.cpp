#include "frame/png_kinds.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "frame/deflate.h"
#include "frame/frame_size.h"
#include "frame/whole_file.h"

namespace zproof {
namespace {

static_assert(sizeof(Rgb8) == 3, "pixels are written as packed RGB");

constexpr char filter_none = 0, filter_up = 2;  // W3C PNG, 9.2

/// What is packed at once stays in a core's own cache.
constexpr std::size_t bytes_in_piece = std::size_t{1} << 18;

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 0xFF);
    return bytes;
}

/// Length, type, content, and the CRC of type and content.
void add_chunk(Parts& png, const std::string& type, Parts content) {
    std::size_t size = 0;
    std::uint32_t crc = crc32_of(type);
    for (const std::string& part : content) size += part.size(), crc = crc32_of(part, crc);
    png.push_back(big_endian(static_cast<std::uint32_t>(size)) + type);
    std::ranges::move(content, std::back_inserter(png));
    png.push_back(big_endian(crc));
}

/// Bytes of a row, without the number of its filter. Row y is put into `row`, or lies somewhere already.
using BytesOfRow = std::function<std::string_view(int y, std::span<char> row)>;

/// Colour type: 2 for RGB, 3 for indices into `palette` (else empty).
struct Layout {
    Resolution size;
    char colour_type = 2;
    std::string_view palette;
    PngRows rows = PngRows::as_they_are;

    std::size_t stride() const {
        return static_cast<std::size_t>(size.width) * (colour_type == 2 ? sizeof(Rgb8) : 1);
    }
};

/// Some rows, each behind the number of its filter.
class FilteredRows {
  public:
    FilteredRows(const Layout& layout, const BytesOfRow& bytes_of) : layout_(layout), bytes_of_(bytes_of) {
        for (std::string& row : rows_) row.resize(layout.stride());
    }

    void append(int first, int count, std::string& room) {
        std::string_view upper;
        if (first > 0 && layout_.rows == PngRows::less_the_upper) upper = bytes_of_(first - 1, rows_[1]);
        room.resize(static_cast<std::size_t>(count) * (layout_.stride() + 1));
        char* to = room.data();
        for (int y = first; y < first + count; ++y, to += layout_.stride() + 1) {
            const std::string_view row = bytes_of_(y, rows_[static_cast<std::size_t>((y - first) % 2)]);
            filter(row, upper, to);
            if (layout_.rows == PngRows::less_the_upper) upper = row;
        }
    }

  private:
    static void filter(std::string_view row, std::string_view upper, char* to) {
        *to++ = upper.empty() ? filter_none : filter_up;
        if (upper.empty()) std::ranges::copy(row, to);
        for (std::size_t i = 0; i < upper.size(); ++i) to[i] = static_cast<char>(row[i] - upper[i]);
    }

    const Layout& layout_;
    const BytesOfRow& bytes_of_;
    std::array<std::string, 2> rows_;  ///< a row and the one above it
};

/// Rows are filtered and packed in pieces, side by side.
Parts packed_rows(const Layout& layout, const BytesOfRow& bytes_of) {
    const int rows_in_piece = std::max(1, static_cast<int>(bytes_in_piece / (layout.stride() + 1)));
    const int pieces = (layout.size.height + rows_in_piece - 1) / rows_in_piece;
    return deflated_side_by_side(static_cast<std::size_t>(pieces), [&](std::size_t i, std::string& room) {
        const int first = static_cast<int>(i) * rows_in_piece;
        FilteredRows(layout, bytes_of)
            .append(first, std::min(rows_in_piece, layout.size.height - first), room);
        return std::string_view(room);
    });
}

Parts png_of(const Layout& layout, const BytesOfRow& bytes_of, const std::string& place) {
    refuse_bad_size(layout.size, place);
    const auto [width, height] = layout.size;
    const std::string header = big_endian(static_cast<std::uint32_t>(width)) +
                               big_endian(static_cast<std::uint32_t>(height)) + '\x08' + layout.colour_type +
                               std::string(3, '\0');  // 8 bits; deflate, adaptive filters, no interlace
    Parts png{"\x89PNG\r\n\x1A\n"};
    add_chunk(png, "IHDR", {header});
    add_chunk(png, "sRGB", {std::string(1, '\0')});
    if (!layout.palette.empty()) add_chunk(png, "PLTE", {std::string(layout.palette)});
    add_chunk(png, "IDAT", packed_rows(layout, bytes_of));
    add_chunk(png, "IEND", {});
    return png;
}

/// Rows of bytes that lie one after another.
BytesOfRow rows_in(std::string_view pixels, std::size_t stride) {
    return
        [=](int y, std::span<char>) { return pixels.substr(static_cast<std::size_t>(y) * stride, stride); };
}

Parts png_of(const Plane<Rgb8>& picture, PngRows rows, const std::string& place) {
    const Layout layout{.size = picture.size(), .palette = {}, .rows = rows};
    return png_of(layout, rows_in(bytes_in(picture.pixels()), layout.stride()), place);
}

void write(const std::filesystem::path& file, const Parts& png) {
    WholeFile whole(file);
    for (const std::string& part : png) whole.append(part);
    whole.finish();
}

}  // namespace

void write_png(const std::filesystem::path& file, const Plane<Rgb8>& picture) {
    write_png(file, picture, PngRows::as_they_are);
}

void write_png(const std::filesystem::path& file, const Plane<Rgb8>& picture, PngRows rows) {
    write(file, png_of(picture, rows, file.string()));
}

void write_png(const std::filesystem::path& file, Resolution size, PngRows rows, const PaintRow& paint) {
    const auto painted = [&](int y, std::span<char> row) {
        paint(y, {reinterpret_cast<Rgb8*>(row.data()), static_cast<std::size_t>(size.width)});
        return std::string_view(row.data(), row.size());
    };
    write(file, png_of({.size = size, .palette = {}, .rows = rows}, painted, file.string()));
}

void write_png(const std::filesystem::path& file, const Plane<std::uint8_t>& indices,
               std::span<const Rgb8> colours) {
    assert(!colours.empty() && colours.size() <= 256);
    const Layout layout{.size = indices.size(), .colour_type = 3, .palette = bytes_in(colours)};
    write(file, png_of(layout, rows_in(bytes_in(indices.pixels()), layout.stride()), file.string()));
}

std::vector<std::byte> encode_png(const Plane<Rgb8>& picture) {
    const std::string bytes = joined(png_of(picture, PngRows::as_they_are, "PNG in memory"));
    const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
    return {first, first + bytes.size()};
}

}  // namespace zproof
