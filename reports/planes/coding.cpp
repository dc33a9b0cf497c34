#include "reports/planes/coding.h"

#include <zlib.h>

#include <bit>
#include <cassert>
#include <cstring>
#include <new>

#include "reports/report_error.h"

namespace zproof::planes {

static_assert(std::endian::native == std::endian::little, "planes are stored as they lie in memory");

namespace {

const Bytef* zlib_bytes(std::string_view bytes) { return reinterpret_cast<const Bytef*>(bytes.data()); }

std::uint32_t folded(std::uint32_t difference) { return (difference << 1) ^ (0u - (difference >> 31)); }
std::uint32_t unfolded(std::uint32_t folded) { return (folded >> 1) ^ (0u - (folded & 1)); }

/// Byte k of every number, for k = 0, 1, ...
template <class T>
std::string byte_planes(std::span<const T> values) {
    std::string bytes(values.size_bytes(), '\0');
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t k = 0; k < sizeof(T); ++k)
            bytes[k * values.size() + i] = char(values[i] >> (8 * k) & 0xFF);
    return bytes;
}

template <class T>
std::vector<T> from_byte_planes(std::string_view bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t k = 0; k < sizeof(T); ++k)
            values[i] |= T(std::uint8_t(bytes[k * values.size() + i])) << (8 * k);
    return values;
}

std::uint32_t guess_for(const std::uint32_t* values, std::size_t i, std::size_t width,
                        Prediction prediction) {
    const bool has_left = i % width > 0, has_upper = i >= width;
    if (prediction == Prediction::left) return has_left ? values[i - 1] : 0;
    if (has_left && has_upper) return values[i - 1] + values[i - width] - values[i - width - 1];
    return has_left ? values[i - 1] : has_upper ? values[i - width] : 0;
}

}  // namespace

std::string encode(std::span<const std::uint32_t> values, std::size_t width, Prediction prediction,
                   Effort effort) {
    assert(width > 0 && values.size() % width == 0);
    std::vector<std::uint32_t> missed(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        missed[i] = folded(values[i] - guess_for(values.data(), i, width, prediction));
    return deflated(byte_planes(std::span<const std::uint32_t>(missed)), effort);
}

std::vector<std::uint32_t> decode(std::string_view bytes, std::size_t count, std::size_t width,
                                  Prediction prediction) {
    std::vector<std::uint32_t> values = from_byte_planes<std::uint32_t>(inflated(bytes, 4 * count));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = unfolded(values[i]) + guess_for(values.data(), i, width, prediction);
    return values;
}

std::string encode(std::span<const std::uint32_t> values, std::span<const std::uint32_t> guess,
                   Effort effort) {
    assert(values.size() == guess.size());
    std::vector<std::uint32_t> missed(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) missed[i] = folded(values[i] - guess[i]);
    return deflated(byte_planes(std::span<const std::uint32_t>(missed)), effort);
}

std::vector<std::uint32_t> decode(std::string_view bytes, std::span<const std::uint32_t> guess) {
    std::vector<std::uint32_t> values = from_byte_planes<std::uint32_t>(inflated(bytes, 4 * guess.size()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = unfolded(values[i]) + guess[i];
    return values;
}

std::string encode(std::span<const double> values) {
    std::vector<std::uint64_t> bits;
    for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
    return deflated(byte_planes(std::span<const std::uint64_t>(bits)), Effort::thorough);
}

std::vector<double> decode_doubles(std::string_view bytes, std::size_t count) {
    std::vector<double> values;
    for (const std::uint64_t bits : from_byte_planes<std::uint64_t>(inflated(bytes, 8 * count)))
        values.push_back(std::bit_cast<double>(bits));
    return values;
}

std::string deflated(std::string_view bytes, Effort effort) {
    uLongf size = compressBound(bytes.size());
    std::string packed(size, '\0');
    const int level = effort == Effort::fast ? 1 : 6;
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, zlib_bytes(bytes), bytes.size(), level) !=
        Z_OK)
        throw std::bad_alloc();
    packed.resize(size);
    return packed;
}

std::string inflated(std::string_view bytes, std::size_t count) {
    std::string plain(count, '\0');
    uLongf size = count;
    if (uncompress(reinterpret_cast<Bytef*>(plain.data()), &size, zlib_bytes(bytes), bytes.size()) != Z_OK ||
        size != count)
        throw ReportError("planes: a block is damaged: expected " + std::to_string(count) +
                          " bytes of deflated content; run zproof again");
    return plain;
}

std::uint32_t checksum(std::string_view bytes) {
    return std::uint32_t(crc32_z(0, zlib_bytes(bytes), bytes.size()));
}

}  // namespace zproof::planes
