#include "reports/planes/coding.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <memory>

#include "frame/deflate.h"
#include "reports/report_error.h"

namespace zproof::planes {

static_assert(std::endian::native == std::endian::little, "planes are stored as they lie in memory");

namespace {

const Bytef* zlib_bytes(std::string_view bytes) { return reinterpret_cast<const Bytef*>(bytes.data()); }

std::uint32_t folded(std::uint32_t difference) { return (difference << 1) ^ (0u - (difference >> 31)); }
std::uint32_t unfolded(std::uint32_t folded) { return (folded >> 1) ^ (0u - (folded & 1)); }

/// Memory that is written before it is read.
template <class T>
std::span<T> unwritten(std::unique_ptr<T[]>& memory, std::size_t count) {
    memory = std::make_unique_for_overwrite<T[]>(count);
    return {memory.get(), count};
}

/// The lowest byte of every number once it is shifted.
[[gnu::target_clones("default", "avx2", "avx512f")]] void take_bytes(const std::uint32_t* values,
                                                                     std::size_t count, int shift, char* to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = char(values[i] >> shift);
}
void take_bytes(const std::uint64_t* values, std::size_t count, int shift, char* to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = char(values[i] >> shift);
}

/// Byte k of every number, for k = 0, 1, ... until the rest is zero.
template <class T>
std::string deflated_byte_planes(std::span<const T> values) {
    T any = 0;
    for (const T value : values) any |= value;
    const std::size_t count = (std::size_t(std::bit_width(any)) + 7) / 8;
    std::unique_ptr<char[]> memory;
    const std::span<char> bytes = unwritten(memory, count * values.size());
    for (std::size_t k = 0; k < count; ++k)
        take_bytes(values.data(), values.size(), int(8 * k), bytes.data() + k * values.size());
    return deflated({bytes.data(), bytes.size()});
}

template <class T>
std::vector<T> from_byte_planes(std::string_view deflated_bytes, std::size_t count) {
    const std::string bytes = inflated(deflated_bytes, sizeof(T) * count);
    if (count == 0 ? !bytes.empty() : bytes.size() % count != 0)
        throw ReportError("planes: a block is damaged: not a whole number of byte planes; run zproof again");
    std::vector<T> values(count);
    for (std::size_t at = 0; at < bytes.size(); ++at)
        values[at % count] |= T(std::uint8_t(bytes[at])) << (8 * (at / count));
    return values;
}

std::uint32_t guess_for(const std::uint32_t* values, std::size_t i, std::size_t width,
                        Prediction prediction) {
    const bool has_left = i % width > 0, has_upper = i >= width;
    if (prediction == Prediction::left) return has_left ? values[i - 1] : 0;
    if (has_left && has_upper) return values[i - 1] + values[i - width] - values[i - width - 1];
    return has_left ? values[i - 1] : has_upper ? values[i - width] : 0;
}

/// What left prediction misses of a row.
void miss_left(Words row, std::span<std::uint32_t> missed) {
    missed[0] = folded(row[0]);
    for (std::size_t i = 1; i < row.size(); ++i) missed[i] = folded(row[i] - row[i - 1]);
}

void miss_planar(Words upper, Words row, std::span<std::uint32_t> missed) {
    missed[0] = folded(row[0] - upper[0]);
    for (std::size_t i = 1; i < row.size(); ++i)
        missed[i] = folded(row[i] - row[i - 1] - (upper[i] - upper[i - 1]));
}

}  // namespace

std::string encode(Words values, std::size_t width, Prediction prediction) {
    assert(width > 0 && values.size() % width == 0);
    std::unique_ptr<std::uint32_t[]> memory;
    const std::span<std::uint32_t> missed = unwritten(memory, values.size());
    for (std::size_t at = 0; at < values.size(); at += width) {
        const auto row = values.part(at, width);
        const auto to = missed.subspan(at, width);
        if (prediction == Prediction::left || at == 0)
            miss_left(row, to);
        else
            miss_planar(values.part(at - width, width), row, to);
    }
    return deflated_byte_planes<std::uint32_t>(missed);
}

std::vector<std::uint32_t> decode(std::string_view bytes, std::size_t count, std::size_t width,
                                  Prediction prediction) {
    std::vector<std::uint32_t> values = from_byte_planes<std::uint32_t>(bytes, count);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = unfolded(values[i]) + guess_for(values.data(), i, width, prediction);
    return values;
}

std::string encode(Words values, Words guess) {
    assert(values.size() == guess.size());
    std::unique_ptr<std::uint32_t[]> memory;
    const std::span<std::uint32_t> missed = unwritten(memory, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) missed[i] = folded(values[i] - guess[i]);
    return deflated_byte_planes<std::uint32_t>(missed);
}

std::vector<std::uint32_t> decode(std::string_view bytes, std::span<const std::uint32_t> guess) {
    std::vector<std::uint32_t> values = from_byte_planes<std::uint32_t>(bytes, guess.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = unfolded(values[i]) + guess[i];
    return values;
}

std::string encode_sparse(Words values, Words guess) {
    assert(values.size() == guess.size());
    std::vector<std::uint32_t> places, kept;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] == guess[i]) continue;
        places.push_back(std::uint32_t(i));
        kept.push_back(values[i]);
    }
    const std::size_t width = std::max<std::size_t>(places.size(), 1);
    places.insert(places.end(), kept.begin(), kept.end());
    return encode(places, width, Prediction::left);
}

std::vector<std::uint32_t> decode_sparse(std::string_view bytes, std::size_t count,
                                         std::span<const std::uint32_t> guess) {
    const std::vector<std::uint32_t> words =
        decode(bytes, 2 * count, std::max<std::size_t>(count, 1), Prediction::left);
    std::vector<std::uint32_t> values(guess.begin(), guess.end());
    for (std::size_t i = 0; i < count; ++i) values.at(words[i]) = words[count + i];
    return values;
}

std::size_t missed_by(Words values, Words guess) {
    std::size_t missed = 0;
    for (std::size_t i = 0; i < values.size(); ++i) missed += values[i] != guess[i];
    return missed;
}

std::string encode(std::span<const double> values) {
    std::vector<std::uint64_t> bits;
    for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
    return deflated_byte_planes<std::uint64_t>(bits);
}

std::vector<double> decode_doubles(std::string_view bytes, std::size_t count) {
    std::vector<double> values;
    for (const std::uint64_t bits : from_byte_planes<std::uint64_t>(bytes, count))
        values.push_back(std::bit_cast<double>(bits));
    return values;
}

std::string inflated(std::string_view bytes, std::size_t most) {
    std::string plain(most + 1, '\0');  // zlib refuses to write nothing into nothing
    uLongf size = plain.size();
    if (uncompress(reinterpret_cast<Bytef*>(plain.data()), &size, zlib_bytes(bytes), bytes.size()) != Z_OK ||
        size > most)
        throw ReportError("planes: a block is damaged: expected at most " + std::to_string(most) +
                          " bytes of deflated content; run zproof again");
    plain.resize(size);
    return plain;
}

}  // namespace zproof::planes
