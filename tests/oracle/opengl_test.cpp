/// Needs a driver: libegl1 and libgl1-mesa-dri. Where there is none, or OpenGL is not built in, every test
/// fails.
#include "oracle/opengl.h"

#include <gmock/gmock.h>
#include <tbb/parallel_for.h>

#include <cstdlib>
#include <limits>
#include <thread>

#include "oracle/oracle_error.h"
#include "pictures.h"
#include "scenes_at_random.h"

namespace zproof::oracle {
namespace {

using testing::HasSubstr;

Frame drawn(const Corners& corners, const View& view) { return OpenGl(scene_of(corners)).render(view); }

/// Is it a driver of 3.3 that the environment makes of Mesa's (CMakeLists.txt)?
bool is_old() { return std::getenv("MESA_GL_VERSION_OVERRIDE") != nullptr; }

/// Standard z is near 1 where depth is: there a step of float32 is one of depth^2 / near.
void expect_depth(float depth, double expected, const View& view) {
    const double relative = is_old() ? expected / view.camera.near_depth : 1;
    EXPECT_NEAR(depth, expected, 4 * 0x1p-24 * expected * relative);
}

TEST(OpenGlTest, IsThere) { EXPECT_EQ(opengl_is_missing(), std::nullopt); }

TEST(OpenGlTest, RowsRunDownAndColumnsRunRight) {
    const Corners upper_left{{-2.9f, 1.9f, -1}, {0, 1.9f, -1}, {-2.9f, -0.9f, -1}};
    EXPECT_EQ(picture(drawn(upper_left, unit_pixels(6, 4))), R"(
000...
00....
0.....
......
)");
}

TEST(OpenGlTest, DepthIsMeasuredAlongTheViewAxisNotAlongTheRay) {
    const View view = unit_pixels(6, 4);
    const Frame frame = drawn(wall(4), view);
    for (const float depth : frame.camera_depth.pixels()) expect_depth(depth, 4, view);
}

TEST(OpenGlTest, NearestTriangleWinsWithinNearAndFar) {
    const Corners walls = together({wall(5), wall(3), wall(1)});
    View view = unit_pixels(1, 1);
    const auto nearest = [&](double near, double far) {
        view.camera.near_depth = near;
        view.camera.far_depth = far;
        return drawn(walls, view);
    };
    constexpr double inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(nearest(0.1, 1000).primitive.at(0, 0), PrimitiveId{2});
    EXPECT_EQ(nearest(2, 4).primitive.at(0, 0), PrimitiveId{1});
    EXPECT_EQ(nearest(4, inf).primitive.at(0, 0), PrimitiveId{0});
    EXPECT_EQ(nearest(1.5, 2.5).primitive.at(0, 0), PrimitiveId::none);
    EXPECT_EQ(nearest(1.5, 2.5).camera_depth.at(0, 0), background_depth) << "not the far plane";
}

TEST(OpenGlTest, ParallelCameraSeesBehindItsEyeAndClipsAtFar) {
    View view = unit_pixels(1, 1);
    view.camera.projection = Projection::parallel;
    view.camera.near_depth = -4;
    view.camera.far_depth = 4;
    const Corners behind{{-9, -9, 3}, {9, -9, 3}, {0, 9, 3}};
    const Frame frame = drawn(together({wall(2), behind}), view);
    EXPECT_EQ(frame.primitive.at(0, 0), PrimitiveId{1});
    EXPECT_FLOAT_EQ(frame.camera_depth.at(0, 0), -3);
    EXPECT_EQ(drawn(wall(5), view).primitive.at(0, 0), PrimitiveId::none);
}

TEST(OpenGlTest, AnObliqueCameraShiftsWhatLiesDeeper) {
    View view = unit_pixels(4, 1);
    view.camera.projection = Projection::parallel;
    view.camera.shear = {0.5, 0};
    const auto strip = [](float depth) {
        return Corners{{-2.1f, -5, -depth}, {-0.9f, -5, -depth}, {-1.5f, 15, -depth}};
    };
    EXPECT_EQ(picture(drawn(strip(1), view)), "\n....\n") << "between two centres";
    EXPECT_EQ(picture(drawn(strip(2), view)), "\n....\n") << "a unit to the left, out of the window";
    view.camera.shear = {-0.5, 0};
    EXPECT_EQ(picture(drawn(strip(2), view)), "\n.0..\n");
    EXPECT_EQ(picture(drawn(strip(4), view)), "\n..0.\n");
}

TEST(OpenGlTest, BothSidesAreSeenAndOfEqualDepthsTheFirstStays) {
    const Corners front = wall(2), back{front[0], front[2], front[1]};
    EXPECT_EQ(drawn(front, unit_pixels(1, 1)).primitive.at(0, 0), PrimitiveId{0});
    EXPECT_EQ(drawn(back, unit_pixels(1, 1)).primitive.at(0, 0), PrimitiveId{0});
    EXPECT_EQ(drawn(together({front, front}), unit_pixels(1, 1)).primitive.at(0, 0), PrimitiveId{0});
}

TEST(OpenGlTest, SceneWithoutTrianglesIsBackground) {
    EXPECT_TRUE(same_bits(drawn({}, unit_pixels(7, 5)), Frame({7, 5})));
}

TEST(OpenGlTest, AnEyeFarFromTheOriginCostsNothing) {
    View view = unit_pixels(6, 4);
    view.camera.eye_world = {1e6f, -1e6f, 1e6f};
    Corners far_away = wall(4);
    for (glm::vec3& corner : far_away) corner += view.camera.eye_world;
    const Frame frame = drawn(far_away, view);
    for (const float depth : frame.camera_depth.pixels()) expect_depth(depth, 4, view);
}

TEST(OpenGlTest, AnImageLargerThanTheDriverAllowsIsRefusedBySize) {
    try {
        drawn(wall(1), unit_pixels(1'000'000, 1));
        ADD_FAILURE() << "accepted";
    } catch (const OracleError& error) {
        EXPECT_THAT(error.what(), HasSubstr("1000000 x 1"));
    }
}

/// More than one draw call's worth of the driver's own batches, most of them hidden.
Scene crowd() {
    Rng rng(7);
    return random_soup(rng, Camera{}, 20'000);
}

View crowd_view(const std::string& name) {
    View view{.name = name, .camera = {}, .width = 301, .height = 203};
    view.camera.near_depth = 2;
    return view;
}

TEST(OpenGlTest, EveryRunAndEveryContextGivesTheSameBits) {
    const Scene scene = crowd();
    const OpenGl first(scene), second(scene);
    const Frame once = first.render(crowd_view("ties"));
    first.render(unit_pixels(8, 2));
    EXPECT_TRUE(same_bits(once, first.render(crowd_view("ties"))));
    EXPECT_TRUE(same_bits(once, second.render(crowd_view("ties"))));
    EXPECT_TRUE(same_bits(once, OpenGlDriver().render(scene, crowd_view("ties"))));
}

TEST(OpenGlTest, AnyThreadMayAskAndAllAtOnce) {
    const Scene scene = crowd();
    const OpenGlDriver driver;
    const OpenGl shared(scene, driver);
    const Frame alone = shared.render(crowd_view("alone"));
    std::vector<Frame> frames(8);
    {
        std::vector<std::jthread> threads;
        for (Frame& frame : frames)
            threads.emplace_back([&] { frame = OpenGl(scene, driver).render(crowd_view("thread")); });
    }
    for (const Frame& frame : frames) EXPECT_TRUE(same_bits(alone, frame));
    tbb::parallel_for(std::size_t(0), frames.size(),
                      [&](std::size_t i) { frames[i] = shared.render(crowd_view("task")); });
    for (const Frame& frame : frames) EXPECT_TRUE(same_bits(alone, frame));
}

TEST(OpenGlTest, NamesVendorRendererAndVersion) {
    EXPECT_THAT(OpenGlDriver().version(), testing::MatchesRegex(".+, .+, OpenGL [3-9]\\.[0-9].*"));
}

/// OpenGL asks for 4 sub-pixel bits at least (4.5 core, table 23.53).
TEST(OpenGlTest, PromisesTheDriversSubpixelBitsAndTheZThatItCanHave) {
    const auto precision = std::get<RasterPrecision>(OpenGlDriver().precision());
    EXPECT_GE(precision.subpixel_bits, 4);
    EXPECT_EQ(precision.depth_buffer, is_old() ? DepthBuffer::standard_z : DepthBuffer::reversed_z);
    EXPECT_EQ(precision.clip_range, is_old() ? ClipRange::minus_one_to_one : ClipRange::zero_to_one);
    EXPECT_EQ(precision.matrix_far, is_old() ? MatrixFar::finite : MatrixFar::infinite);
}

/// Far away z is 1, that of a cleared buffer, where the far plane is infinite.
TEST(OpenGlTest, WhatLiesAsFarAsNothingDoesIsDrawn) {
    View view = unit_pixels(2, 2);
    view.camera.near_depth = 0x1p-30;
    view.camera.far_depth = std::numeric_limits<double>::infinity();
    EXPECT_EQ(picture(drawn(wall(4), view)), "\n00\n00\n");
}

}  // namespace
}  // namespace zproof::oracle
