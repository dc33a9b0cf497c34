/// 8-bit pictures for people. Nothing is ever judged from them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "frame/plane.h"

namespace zproof {

struct Rgb8 {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Rgb8&) const = default;
};

/// Writes an sRGB PNG. Throws FrameError where the file cannot be written.
void write_png(const std::filesystem::path& file, const Plane<Rgb8>& picture);

/// The same PNG as bytes in memory, for pages that embed it.
std::vector<std::byte> encode_png(const Plane<Rgb8>& picture);

}  // namespace zproof
