// A lattice's view has the pixel centres of the whole image, and its frame the values there.
#include "scenes/pixel_lattice.h"

#include <gtest/gtest.h>

#include <random>

namespace zproof {
namespace {

/// Where the ray of a pixel's centre meets the plane of the window.
glm::dvec2 centre_in_window(const View& view, int x, int y) {
    const Window& w = view.camera.window;
    return {w.left + (w.right - w.left) * (x + 0.5) / view.width,
            w.top - (w.top - w.bottom) * (y + 0.5) / view.height};
}

TEST(PixelLattice, ItsViewHasThePixelCentresOfTheImage) {
    std::mt19937 engine(7);
    const auto drawn = [&](int low, int high) { return low + int(engine() % unsigned(high - low + 1)); };
    for (int round = 0; round < 500; ++round) {
        View view{.name = "v", .camera = {}, .width = drawn(1, 70), .height = drawn(1, 70)};
        view.camera.window = {-1.0 / drawn(1, 9), 2.0 / drawn(1, 9), -3.0 / drawn(1, 9), 1.0 / drawn(1, 9)};
        const int stride = drawn(1, 80);
        const PixelLattice lattice{stride, drawn(0, std::min(stride, view.width) - 1),
                                   drawn(0, std::min(stride, view.height) - 1)};
        const View some = view_of(lattice, view);
        ASSERT_GE(some.width, 1);
        ASSERT_GE(some.height, 1);
        const int last_x = lattice.first_x + stride * (some.width - 1);
        const int last_y = lattice.first_y + stride * (some.height - 1);
        EXPECT_LT(last_x, view.width);
        EXPECT_LT(last_y, view.height);
        EXPECT_GE(last_x + stride, view.width);  // no column or row is left out
        EXPECT_GE(last_y + stride, view.height);
        for (int y = 0; y < some.height; ++y)
            for (int x = 0; x < some.width; ++x) {
                const glm::dvec2 here = centre_in_window(some, x, y);
                const glm::dvec2 there =
                    centre_in_window(view, lattice.first_x + stride * x, lattice.first_y + stride * y);
                ASSERT_NEAR(here.x, there.x, 1e-14);
                ASSERT_NEAR(here.y, there.y, 1e-14);
            }
    }
}

TEST(PixelLattice, OfEveryPixelItIsTheViewItself) {
    const View view{.name = "v", .camera = {}, .width = 31, .height = 17};
    const View all = view_of({}, view);
    EXPECT_EQ(all.width, 31);
    EXPECT_EQ(all.height, 17);
    EXPECT_EQ(all.camera.window.left, view.camera.window.left);
    EXPECT_EQ(all.camera.window.top, view.camera.window.top);
    EXPECT_NEAR(all.camera.window.right, view.camera.window.right, 1e-15);
    EXPECT_NEAR(all.camera.window.bottom, view.camera.window.bottom, 1e-15);
}

TEST(PixelLattice, ItsFrameHasTheValuesThere) {
    Frame frame({10, 7});
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 10; ++x) {
            frame.primitive.at(x, y) = PrimitiveId{std::uint32_t(16'777'217 + 10 * y + x)};
            frame.camera_depth.at(x, y) = float(1 + 10 * y + x);
        }
    const Frame some = frame_at({.stride = 4, .first_x = 1, .first_y = 3}, frame);
    ASSERT_EQ(some.size(), (Resolution{3, 1}));
    for (int x = 0; x < 3; ++x) {
        EXPECT_EQ(some.primitive.at(x, 0), PrimitiveId{std::uint32_t(16'777'217 + 31 + 4 * x)});
        EXPECT_EQ(some.camera_depth.at(x, 0), float(32 + 4 * x));
    }
}

}  // namespace
}  // namespace zproof
