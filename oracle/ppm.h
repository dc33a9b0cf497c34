/// Binary PPM with 16 bits per channel, as programs write it for us.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>

#include "frame/plane.h"

namespace zproof::oracle {

/// Reads a P6 file whose largest value is 65535. Throws OracleError, naming the file and what was expected,
/// where it is missing, of another kind or size, or cut short.
Plane<std::array<std::uint16_t, 3>> read_ppm16(const std::filesystem::path& file, Resolution size);

}  // namespace zproof::oracle
