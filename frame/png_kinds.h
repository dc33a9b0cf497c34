/// PNGs of pictures whose kind is known: smaller, or sooner written, than the plain ones of frame/png.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
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

/// Paints row y, as often as it is asked to, on any thread.
using PaintRow = std::function<void(int y, std::span<Rgb8> row)>;

/// A picture that is painted while it is written, on the threads of the surrounding tbb::task_arena. The same
/// bytes as if it had been painted before. Throws FrameError where the file cannot be written.
void write_png(const std::filesystem::path& file, Resolution size, PngRows rows, const PaintRow& paint);

/// The same picture with a byte per pixel: which of at most 256 colours it has.
void write_png(const std::filesystem::path& file, const Plane<std::uint8_t>& indices,
               std::span<const Rgb8> colours);

}  // namespace zproof
