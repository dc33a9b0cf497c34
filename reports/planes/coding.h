/// Planes of a view as bytes: numbers are predicted, what the prediction misses is split into byte planes,
/// and the whole is deflated (RFC 1950). reports/viewer/src/coding.ts reads it back.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zproof::planes {

/// How hard zlib tries.
enum class Effort { fast, thorough };

/// What a 32-bit number is guessed to be. Differences are taken modulo 2^32 and folded so that small ones of
/// either sign are small: 0, -1, 1, -2 ... become 0, 1, 2, 3 ...
enum class Prediction {
    left,    ///< its left neighbour (0 at a row's begin)
    planar,  ///< left + upper - upper left; where one of them lies outside, the other; else 0
};

/// Row-major, values.size() a multiple of width > 0.
std::string encode(std::span<const std::uint32_t> values, std::size_t width, Prediction prediction,
                   Effort effort);
std::vector<std::uint32_t> decode(std::string_view bytes, std::size_t count, std::size_t width,
                                  Prediction prediction);

/// Guessed to be the number at the same place of another plane of the same size.
std::string encode(std::span<const std::uint32_t> values, std::span<const std::uint32_t> guess,
                   Effort effort);
std::vector<std::uint32_t> decode(std::string_view bytes, std::span<const std::uint32_t> guess);

/// Guessed likewise, and only what the guess misses is kept: places, then values.
std::string encode_sparse(std::span<const std::uint32_t> values, std::span<const std::uint32_t> guess);
std::vector<std::uint32_t> decode_sparse(std::string_view bytes, std::size_t count,
                                         std::span<const std::uint32_t> guess);
/// How many numbers encode_sparse keeps.
std::size_t missed_by(std::span<const std::uint32_t> values, std::span<const std::uint32_t> guess);

/// The bits of doubles, byte by byte.
std::string encode(std::span<const double> values);
std::vector<double> decode_doubles(std::string_view bytes, std::size_t count);

/// Bytes as they are.
std::string deflated(std::string_view bytes, Effort effort);
/// At most `most` bytes must come out. Throws ReportError where the bytes are damaged.
std::string inflated(std::string_view bytes, std::size_t most);

/// CRC-32 of zlib and PNG.
std::uint32_t checksum(std::string_view bytes);

/// The bytes that numbers occupy, in this machine's order, which is little-endian.
template <class T>
std::string_view as_bytes(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace zproof::planes
