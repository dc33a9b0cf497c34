/// Planes of a view as bytes: numbers are predicted, what the prediction misses is split into byte planes,
/// and the whole is deflated (RFC 1950). reports/viewer/src/coding.ts reads it back.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zproof::planes {

/// Numbers of 32 bits where they lie: ids, counts, or the bits of floats, which are not copied for it.
class Words {
  public:
    template <class T, std::size_t extent>
    requires(sizeof(T) == sizeof(std::uint32_t)) Words(std::span<T, extent> values)
        : Words(values.data(), values.size()) {}
    Words(const std::vector<std::uint32_t>& values) : Words(values.data(), values.size()) {}

    std::size_t size() const { return size_; }
    std::uint32_t operator[](std::size_t i) const {
        std::uint32_t word;
        std::memcpy(&word, first_ + sizeof word * i, sizeof word);
        return word;
    }
    Words part(std::size_t first, std::size_t size) const {
        return {first_ + sizeof(std::uint32_t) * first, size};
    }
    std::string_view bytes() const { return {first_, sizeof(std::uint32_t) * size_}; }

  private:
    Words(const void* first, std::size_t size) : first_(static_cast<const char*>(first)), size_(size) {}

    const char* first_;
    std::size_t size_;
};

/// What a 32-bit number is guessed to be. Differences are taken modulo 2^32 and folded so that small ones of
/// either sign are small: 0, -1, 1, -2 ... become 0, 1, 2, 3 ...
enum class Prediction {
    left,    ///< its left neighbour (0 at a row's begin)
    planar,  ///< left + upper - upper left; where one of them lies outside, the other; else 0
};

/// Row-major, values.size() a multiple of width > 0.
std::string encode(Words values, std::size_t width, Prediction prediction);

/// The guess is the number at the same place of another plane of the same size.
std::string encode(Words values, Words guess);

/// The guess is as for encode(), but only what it misses is kept: places, then values.
std::string encode_sparse(Words values, Words guess);
/// How many numbers encode_sparse keeps.
std::size_t missed_by(Words values, Words guess);

/// Bytes of which neighbours are mostly equal: of each run its length, seven bits to a byte and the lowest
/// first (all but the last have their eighth bit set), then its value.
std::string encode_runs(std::string_view values);

/// The bits of doubles, byte by byte.
std::string encode(std::span<const double> values);

}  // namespace zproof::planes
