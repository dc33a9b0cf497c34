#include "frame/npy.h"

#include <bit>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frame/frame_error.h"
#include "frame/frame_size.h"
#include "frame/whole_file.h"

namespace zproof {
namespace {

static_assert(std::endian::native == std::endian::little, "values are copied as they lie in memory");

/// Magic, version 1.0, then the header's length as 16 bits, little-endian.
constexpr std::string_view magic_and_version("\x93NUMPY\x01\x00", 8);
constexpr std::size_t preamble_size = magic_and_version.size() + 2;
constexpr std::size_t alignment = 64;  ///< of the first value, as NumPy asks

/// `descr` is NumPy's name of the type: '<f4' or '<u4'.
std::string preamble_and_header(const std::string& descr, Resolution size) {
    std::string header = "{'descr': '" + descr + "', 'fortran_order': False, 'shape': (" +
                         std::to_string(size.height) + ", " + std::to_string(size.width) + "), }";
    const std::size_t unpadded = preamble_size + header.size() + 1;
    header.append((alignment - unpadded % alignment) % alignment, ' ');
    header += '\n';
    const auto length = static_cast<std::uint16_t>(header.size());
    std::string bytes(magic_and_version);
    bytes += static_cast<char>(length & 0xFF);
    bytes += static_cast<char>(length >> 8);
    return bytes + header;
}

template <class T>
void write_as(const std::filesystem::path& file, const Plane<T>& plane, const std::string& descr) {
    static_assert(sizeof(T) == 4);
    refuse_bad_size(plane.size(), file.string());
    const std::string header = preamble_and_header(descr, plane.size());
    const std::span<const std::byte> values = std::as_bytes(plane.pixels());
    std::vector<std::byte> bytes(header.size() + values.size());
    std::memcpy(bytes.data(), header.data(), header.size());
    std::memcpy(bytes.data() + header.size(), values.data(), values.size());
    write_whole_file(file, bytes);
}

std::string contents(const std::filesystem::path& file) {
    if (!std::filesystem::is_regular_file(file)) {
        throw FrameError(file.string() + ": no such file; expected a NumPy array");
    }
    std::string bytes(std::filesystem::file_size(file), '\0');
    std::ifstream in(file, std::ios::binary);
    if (!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
        throw FrameError(file.string() + ": cannot be read; expected a NumPy array");
    }
    return bytes;
}

/// The two halves of a file: what is said about the values, and the values.
struct Parts {
    std::string header;
    std::string_view values;
};

Parts split(std::string_view bytes, const std::string& name) {
    if (bytes.size() < preamble_size || !bytes.starts_with(magic_and_version)) {
        throw FrameError(name + ": not a NumPy array of format version 1.0; save it with numpy.save");
    }
    const std::size_t length =
        static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
    if (bytes.size() < preamble_size + length) throw FrameError(name + ": the NumPy header is cut short");
    return {std::string(bytes.substr(preamble_size, length)), bytes.substr(preamble_size + length)};
}

/// The value of one key of the header's dictionary without its spaces, a tuple with its parentheses, a string
/// with its quotes; "missing" where the key is.
std::string entry(std::string header, const std::string& key) {
    std::erase_if(header, [](char c) { return c == ' ' || c == '\n'; });
    const std::string before = "'" + key + "':";
    const std::size_t found = header.find(before);
    if (found == std::string::npos) return "missing";
    const std::size_t first = found + before.size();
    const bool is_tuple = header.substr(first, 1) == "(";
    const std::size_t end = is_tuple ? header.find(')', first) + 1 : header.find_first_of(",}", first);
    return header.substr(first, end - first);
}

void expect_entry(const Parts& parts, const std::string& key, const std::string& expected,
                  const std::string& name) {
    const std::string found = entry(parts.header, key);
    if (found == expected) return;
    throw FrameError(name + ": '" + key + "' is " + found + "; expected " + expected);
}

/// The whole of `text` as a number that is not negative; none where it is anything else.
std::optional<int> number(std::string_view text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [last, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || last != end || text.starts_with('-')) return std::nullopt;
    return value;
}

Resolution shape(const Parts& parts, const std::string& name) {
    const std::string text = entry(parts.header, "shape");
    const std::size_t comma = text.find(',');
    if (text.size() >= 2 && comma != std::string::npos) {
        const std::string_view inside(text);
        const auto height = number(inside.substr(1, comma - 1));
        const auto width = number(inside.substr(comma + 1, text.size() - comma - 2));
        if (height && width) {
            const Resolution size{*width, *height};
            refuse_bad_size(size, name);
            return size;
        }
    }
    throw FrameError(name + ": 'shape' is " + text + "; expected (height, width)");
}

template <class T>
Plane<T> read_as(const std::filesystem::path& file, const std::string& descr) {
    const std::string name = file.string(), bytes = contents(file);
    const Parts parts = split(bytes, name);
    expect_entry(parts, "descr", "'" + descr + "'", name);
    expect_entry(parts, "fortran_order", "False", name);
    const Resolution size = shape(parts, name);
    if (parts.values.size() != size.pixel_count() * sizeof(T)) {
        throw FrameError(name + ": " + std::to_string(parts.values.size()) + " bytes of values; expected " +
                         std::to_string(size.pixel_count() * sizeof(T)) + ", as 'shape' says");
    }
    Plane<T> plane(size);
    std::memcpy(plane.pixels().data(), parts.values.data(), parts.values.size());
    return plane;
}

}  // namespace

void write_npy(const std::filesystem::path& file, const Plane<float>& plane) { write_as(file, plane, "<f4"); }
void write_npy(const std::filesystem::path& file, const Plane<std::uint32_t>& plane) {
    write_as(file, plane, "<u4");
}
void write_npy(const std::filesystem::path& file, const Plane<PrimitiveId>& plane) {
    write_as(file, plane, "<u4");
}

Plane<float> read_npy_float32(const std::filesystem::path& file) { return read_as<float>(file, "<f4"); }
Plane<std::uint32_t> read_npy_uint32(const std::filesystem::path& file) {
    return read_as<std::uint32_t>(file, "<u4");
}

}  // namespace zproof
