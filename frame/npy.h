/// Planes as NumPy arrays: format version 1.0, little-endian, C order, shape (height, width). Bit for bit.
#pragma once

#include <cstdint>
#include <filesystem>

#include "frame/frame.h"
#include "frame/plane.h"

namespace zproof {

/// Writes '<f4' or '<u4'; ids are written as their numbers, background as 4294967295. Throws FrameError where
/// the plane is empty or the file cannot be written.
void write_npy(const std::filesystem::path& file, const Plane<float>& plane);
void write_npy(const std::filesystem::path& file, const Plane<std::uint32_t>& plane);
void write_npy(const std::filesystem::path& file, const Plane<PrimitiveId>& plane);

/// Read such a file back, from here or from NumPy. Throws FrameError, naming the file and what was expected,
/// where it is missing, cut short, longer than its shape, of another version, type or order, or not
/// two-dimensional.
Plane<float> read_npy_float32(const std::filesystem::path& file);
Plane<std::uint32_t> read_npy_uint32(const std::filesystem::path& file);

}  // namespace zproof
