/// PNGs of pictures whose kind is known: smaller, or sooner written, than the plain ones of frame/png.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "frame/png.h"

namespace zproof {

/// What a row of pixels is written as (PNG's filters None and Up); readers get the same values from both.
enum class PngRows {
    as_they_are,    ///< small where colours repeat and are otherwise unlike: ids, drawings
    less_the_upper  ///< small where colours change little from row to row: depths, shaded surfaces
};

/// Throws FrameError where the file cannot be written.
void write_png(const std::filesystem::path& file, const Plane<Rgb8>& picture, PngRows rows);

/// The same picture with a byte per pixel: which of at most 256 colours it has.
void write_png(const std::filesystem::path& file, const Plane<std::uint8_t>& indices,
               std::span<const Rgb8> colours);

}  // namespace zproof
