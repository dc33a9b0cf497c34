/// Colours of 8-bit pictures for people. Nothing is ever judged from them.
#pragma once

#include <cstdint>

namespace zproof {

/// sRGB.
struct Rgb8 {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Rgb8&) const = default;
};

}  // namespace zproof
