// The rasterizer writes whole cache lines of a plane at a time.
#include "frame/plane.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace zproof {
namespace {

TEST(Plane, BeginsACacheLineWhateverItsSize) {
    for (int width = 1; width < 200; width += 7) {
        const Plane<float> floats({width, 3});
        const Plane<std::uint8_t> bytes({width, 1});
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(floats.pixels().data()) % cache_line_bytes, 0u) << width;
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes.pixels().data()) % cache_line_bytes, 0u) << width;
    }
}

}  // namespace
}  // namespace zproof
