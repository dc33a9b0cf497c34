// The format: numpy.lib.format in numpy's manual, versions 1.0 to 3.0.
#include "image_io/npy_array.h"

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "frame/frame_error.h"
#include "image_io/samples.h"

namespace zproof::image_io {
namespace {

static_assert(std::endian::native == std::endian::little, "samples are taken as they lie in the file");

constexpr std::size_t longest_header = 1024;  // numpy's of four sides are below 128

[[noreturn]] void refuse_array(const std::filesystem::path& file, const std::string& why) {
    throw FrameError(file.string() + ": " + why);
}

std::string read_bytes(std::ifstream& in, std::size_t count, const std::filesystem::path& file) {
    std::string bytes(count, '\0');
    if (!in.read(bytes.data(), std::streamsize(count)))
        refuse_array(file, "the file ends within its .npy header");
    return bytes;
}

std::size_t little_endian(const std::string& bytes) {
    std::size_t number = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) number = number << 8 | std::uint8_t(bytes[i]);
    return number;
}

/// The header's text: a Python dict in a line.
std::string header_of(std::ifstream& in, const std::filesystem::path& file) {
    const std::string begin = read_bytes(in, 8, file);
    const int version = begin[6];
    if (version < 1 || version > 3)
        refuse_array(file, ".npy of version " + std::to_string(version) + "; expected 1, 2 or 3");
    const std::size_t length = little_endian(read_bytes(in, version == 1 ? 2 : 4, file));
    if (length > longest_header)
        refuse_array(file,
                     ".npy header of " + std::to_string(length) + " bytes; expected one array of numbers");
    return read_bytes(in, length, file);
}

Sample sample_of(const std::string& type, const std::filesystem::path& file) {
    constexpr std::pair<const char*, Sample> known[] = {
        {"|u1", Sample::uint8}, {"<u2", Sample::uint16}, {"<u4", Sample::uint32},  {"<i4", Sample::int32},
        {"<i8", Sample::int64}, {"<f2", Sample::half},   {"<f4", Sample::float32}, {"<f8", Sample::float64},
    };
    for (const auto& [name, sample] : known)
        if (type == name) return sample;
    refuse_array(
        file, "samples of numpy's type '" + type +
                  "'; expected |u1, <u2, <u4, <i4, <i8, <f2, <f4 or <f8: array.astype('<f4') makes them so");
}

std::vector<int> sides_of(const std::string& shape) {
    std::vector<int> sides;
    static const std::regex side{"[0-9]+"};
    for (std::sregex_iterator i{shape.begin(), shape.end(), side}, end; i != end; ++i)
        sides.push_back(i->length() > 8 ? 99'999'999 : std::stoi(i->str()));
    return sides;
}

/// Height, width and number of channels.
std::array<int, 3> image_sides(const std::string& shape, const std::filesystem::path& file) {
    std::vector<int> sides = sides_of(shape);
    if (sides.size() == 4 && sides[0] == 1) sides.erase(sides.begin());
    if (sides.size() == 2) sides.push_back(1);
    constexpr int most_channels = 1024;
    if (sides.size() != 3 || sides[2] < 1 || sides[2] > most_channels)
        refuse_array(
            file, "an array of shape (" + shape +
                      "); expected (height, width), (height, width, channels) or one such image in a batch");
    refuse_bad_size({sides[1], sides[0]}, file.string());
    return {sides[0], sides[1], sides[2]};
}

Part part_of(const std::string& header, const std::filesystem::path& file) {
    static const std::regex form{R"(\{\s*'descr':\s*'([^']*)',\s*'fortran_order':\s*(True|False),\s*)"
                                 R"('shape':\s*\(([0-9, ]*)\),?\s*\}\s*)"};
    std::smatch found;
    if (!std::regex_match(header, found, form))
        refuse_array(file,
                     "its .npy header is not understood; expected what numpy.save writes of one plain array");
    if (found[2] == "True")
        refuse_array(file,
                     "samples in Fortran order; expected rows: numpy.ascontiguousarray(array) makes them so");
    const Sample sample = sample_of(found[1], file);
    const auto [height, width, channels] = image_sides(found[3], file);
    Part part{.name = "", .data = {0, 0, width, height}, .display = {0, 0, width, height}, .channels = {}};
    for (int c = 0; c < channels; ++c) part.channels.push_back({std::to_string(c), sample});
    return part;
}

std::size_t bytes_per_pixel(const Part& part) {
    return part.channels.size() * bytes_of(part.channels.front().sample);
}

}  // namespace

NpyArray::NpyArray(const std::filesystem::path& file) : file_(file) {
    std::ifstream in(file, std::ios::binary);
    part_ = part_of(header_of(in, file), file);
    first_sample_ = std::uint64_t(in.tellg());
    const std::uint64_t found = std::filesystem::file_size(file) - first_sample_;
    const std::uint64_t expected =
        std::uint64_t(part_.data.width) * std::uint64_t(part_.data.height) * bytes_per_pixel(part_);
    if (found != expected)
        refuse_array(
            file, std::to_string(found) + " bytes of samples; its header says " + std::to_string(expected));
}

void NpyArray::read(const Block& block, std::span<std::byte> to) const {
    const std::size_t pixel = bytes_per_pixel(part_), sample = bytes_of(part_.channels.front().sample);
    const std::size_t row = std::size_t(part_.data.width) * pixel;
    const std::size_t wanted = std::size_t(block.channel_count) * sample;
    std::vector<char> rows(row * std::size_t(block.row_count));
    std::ifstream in(file_, std::ios::binary);
    in.seekg(std::streamoff(first_sample_ + std::uint64_t(block.first_row) * row));
    if (!in.read(rows.data(), std::streamsize(rows.size())))
        refuse_array(file_, "cannot be read, in the rows from " + std::to_string(block.first_row) + " on");
    const char* from = rows.data() + std::size_t(block.first_channel) * sample;
    for (std::size_t i = 0; i < rows.size() / pixel; ++i)
        std::memcpy(to.data() + i * wanted, from + i * pixel, wanted);
}

}  // namespace zproof::image_io
