// The rasterizer writes whole cache lines of a plane at a time.
#include "frame/plane.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

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

TEST(Plane, OfLentMemoryIsThatMemory) {
    std::vector<float> values{1, 2, 3, 4, 5, 6};
    const Plane<float> lent = Plane<float>::lent({3, 2}, values.data());
    EXPECT_EQ(lent.pixels().data(), values.data());
    EXPECT_EQ(lent.at(2, 1), 6);
    values[5] = 7;
    EXPECT_EQ(lent.at(2, 1), 7);
}

TEST(Plane, MovedIsStillTheLentMemoryAndCopiedIsNot) {
    const std::vector<float> values{1, 2, 3, 4};
    Plane<float> moved;
    moved = Plane<float>::lent({2, 2}, values.data());
    EXPECT_EQ(moved.pixels().data(), values.data());
    const Plane<float> copied = moved;
    EXPECT_NE(copied.pixels().data(), values.data());
    EXPECT_EQ(copied.at(1, 1), 4);
    Plane<float> assigned({1, 1});
    assigned = moved;
    EXPECT_NE(assigned.pixels().data(), values.data());
    EXPECT_EQ(assigned.at(0, 1), 3);
}

}  // namespace
}  // namespace zproof
