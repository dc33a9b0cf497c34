#include "compare/class_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace zproof {
namespace {

/// Less than a tile, one, and more, whole or not.
constexpr Resolution sizes[] = {{1, 1}, {15, 40}, {16, 16}, {33, 17}, {150, 70}};

TEST(ClassMap, AgreesUntilSomethingElseIsSaid) {
    for (const Resolution size : sizes) {
        ClassMap map(size);
        map.open(0, 0);
        EXPECT_EQ(map.size(), size);
        EXPECT_EQ(map.at(size.width - 1, size.height - 1), PixelClass::agree);
        const Plane<PixelClass> plane = map.plane();
        EXPECT_EQ(plane.size(), size);
        EXPECT_EQ(std::ranges::count(plane.pixels(), PixelClass::agree), std::ptrdiff_t(size.pixel_count()));
    }
}

TEST(ClassMap, HoldsWhatAPlaneHolds) {
    std::mt19937 random(1);
    for (const Resolution size : sizes)
        for (int round = 0; round < 50; ++round) {
            ClassMap map(size);
            Plane<PixelClass> plane(size, PixelClass::agree);
            for (auto left = random() % 100; left > 0; --left) {
                const int x = int(random() % std::uint32_t(size.width)),
                          y = int(random() % std::uint32_t(size.height));
                const auto c = PixelClass(random() % pixel_class_count);
                map.set(x, y, c);
                plane.at(x, y) = c;
            }
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) ASSERT_EQ(map.at(x, y), plane.at(x, y));
            ASSERT_TRUE(std::ranges::equal(map.plane().pixels(), plane.pixels()));
        }
}

TEST(ClassMap, KeepsWhatWasSaidWhenATileIsOpenedAgain) {
    ClassMap map({40, 40});
    map.set(17, 3, PixelClass::hole);
    map.open(1, 0);
    EXPECT_EQ(map.at(17, 3), PixelClass::hole);
}

}  // namespace
}  // namespace zproof
