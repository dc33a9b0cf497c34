/// 8-bit pictures for people. Nothing is ever judged from them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "frame/plane.h"

namespace zproof {

struct Rgb8 {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Rgb8&) const = default;
};

/// What a row of pixels is written as (PNG's filters None and Up); readers get the same values from both.
enum class PngRows {
    as_they_are,    ///< small where colours repeat and are otherwise unlike: ids, drawings
    less_the_upper  ///< small where colours change little from row to row: depths, shaded surfaces
};

/// Writes an sRGB PNG. Throws FrameError where the file cannot be written.
void write_png(const std::filesystem::path& file, const Plane<Rgb8>& picture,
               PngRows rows = PngRows::as_they_are);

/// The same picture with a byte per pixel: which of at most 256 colours it has.
void write_png(const std::filesystem::path& file, const Plane<std::uint8_t>& indices,
               std::span<const Rgb8> colours);

/// The PNG as bytes in memory, for pages that embed it.
std::vector<std::byte> encode_png(const Plane<Rgb8>& picture);

}  // namespace zproof
