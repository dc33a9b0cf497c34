#include "oracle/ppm.h"

#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "oracle/oracle_error.h"

namespace zproof::oracle {
namespace {

/// The next word of the header; a # begins a comment up to the end of its line.
std::string next_word(std::istream& in) {
    std::string word;
    while (in >> word && word.starts_with('#')) in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    return word;
}

std::string header_of(std::istream& in) {
    std::string header = next_word(in);
    for (int i = 0; i < 3; ++i) header.append(" ").append(next_word(in));
    in.get();
    return header;
}

}  // namespace

Plane<std::array<std::uint16_t, 3>> read_ppm16(const std::filesystem::path& file, Resolution size) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw OracleError(file.string() + ": expected a picture, and there is no such file");
    const std::string expected =
        "P6 " + std::to_string(size.width) + " " + std::to_string(size.height) + " 65535";
    const std::string header = header_of(in);
    if (header != expected)
        throw OracleError(file.string() + ": its header is '" + header + "', expected '" + expected + "'");
    std::vector<unsigned char> bytes(size.pixel_count() * 6);
    in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    if (std::size_t(in.gcount()) != bytes.size())
        throw OracleError(file.string() + ": it ends after " + std::to_string(in.gcount()) +
                          " bytes of pixels, expected " + std::to_string(bytes.size()));
    Plane<std::array<std::uint16_t, 3>> picture(size);
    std::size_t at = 0;
    for (auto& pixel : picture.pixels())
        for (auto& channel : pixel) {
            channel = std::uint16_t(bytes[at] << 8 | bytes[at + 1]);
            at += 2;
        }
    return picture;
}

}  // namespace zproof::oracle
