/// Samples of files as values: every conversion here is exact.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "frame/frame.h"
#include "image_io/image_file.h"

namespace zproof::image_io {

inline bool is_unsigned(Sample sample) {
    return sample == Sample::uint8 || sample == Sample::uint16 || sample == Sample::uint32;
}
inline bool is_real(Sample sample) { return sample == Sample::half || sample == Sample::float32; }

/// OpenEXR's words for its own types.
inline std::string name_of(Sample sample) {
    constexpr const char* names[] = {"uint8", "uint16", "uint",   "half",   "float",
                                     "int32", "int64",  "double", "unknown"};
    return names[std::size_t(sample)];
}

inline std::size_t bytes_of(Sample sample) {
    switch (sample) {
        case Sample::uint8:
            return 1;
        case Sample::uint16:
        case Sample::half:
            return 2;
        case Sample::uint32:
        case Sample::float32:
        case Sample::int32:
            return 4;
        case Sample::int64:
        case Sample::float64:
            return 8;
        case Sample::other:
            break;
    }
    return 8;  // no type of OpenImageIO is longer
}

/// IEEE binary16 as binary32: every value, and the payloads of NaN.
inline float float_of_half(std::uint16_t half) {
    const std::uint32_t sign = std::uint32_t(half & 0x8000u) << 16, magnitude = half & 0x7FFFu;
    if (magnitude >= 0x7C00u) return std::bit_cast<float>(sign | 0x7F80'0000u | (magnitude & 0x3FFu) << 13);
    if (magnitude >= 0x0400u) return std::bit_cast<float>(sign | ((magnitude << 13) + (112u << 23)));
    const float denormal = float(magnitude) * 0x1p-24f;
    return sign == 0 ? denormal : -denormal;
}

/// convert(sample) of every sample of a row, whose type in memory is Stored.
template <class Stored, class To, class Convert>
void spread(const SampleRow& row, std::span<To> to, const Convert& convert) {
    for (int i = 0; i < row.count; ++i) {
        Stored stored;
        std::memcpy(&stored, row.first + std::size_t(i) * row.stride, sizeof stored);
        to[std::size_t(i)] = convert(stored);
    }
}

/// Unsigned samples as ids. The largest value of the type is background.
inline void spread_ids(const SampleRow& row, std::span<PrimitiveId> to) {
    const auto id_of = []<class T>(T value) {
        return value == std::numeric_limits<T>::max() ? PrimitiveId::none : PrimitiveId{value};
    };
    if (row.sample == Sample::uint8) return spread<std::uint8_t>(row, to, id_of);
    if (row.sample == Sample::uint16) return spread<std::uint16_t>(row, to, id_of);
    if (row.sample == Sample::uint32) return spread<std::uint32_t>(row, to, id_of);
    throw std::logic_error{"ids of a type that is no unsigned integer"};
}

/// Half or float32 samples, bit for bit: no floating-point register may quieten a NaN.
template <class To, class Store>
void spread_reals(const SampleRow& row, std::span<To> to, const Store& store) {
    for (int i = 0; i < row.count; ++i) {
        float value = 0;
        const std::byte* from = row.first + std::size_t(i) * row.stride;
        if (row.sample == Sample::float32) {
            std::memcpy(&value, from, sizeof value);
        } else {
            std::uint16_t half = 0;
            std::memcpy(&half, from, sizeof half);
            value = float_of_half(half);
        }
        store(to[std::size_t(i)], value);
    }
}

}  // namespace zproof::image_io
