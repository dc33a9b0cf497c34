// Both sides of every limit of docs/scenes.md, "What is judged".
#include "scenes/judged_ranges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "scenes/scene_error.h"

namespace zproof {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Camera perspective() {
    Camera camera;
    camera.window = {-1, 1, -1, 1};
    camera.near_depth = 1;
    camera.far_depth = 100;
    return camera;
}

Camera parallel() {
    Camera camera = perspective();
    camera.projection = Projection::parallel;
    return camera;
}

/// A quantity of a camera, its last value that is judged, the first that is not, and what is then named.
struct Limit {
    const char* name;
    Camera camera;
    std::function<void(Camera&, double)> set;
    double judged, refused;
    const char* said;
};

void PrintTo(const Limit& limit, std::ostream* out) { *out << limit.name; }

class LimitOfACamera : public testing::TestWithParam<Limit> {};

TEST_P(LimitOfACamera, IsJudgedUpToItAndRefusedBeyond) {
    const Limit& limit = GetParam();
    View view{.name = "v", .camera = limit.camera, .width = 8, .height = 8};
    limit.set(view.camera, limit.judged);
    EXPECT_EQ(outside_judged_ranges(view), "");
    limit.set(view.camera, limit.refused);
    EXPECT_THAT(outside_judged_ranges(view), testing::HasSubstr(limit.said));
    EXPECT_THROW(require_judged(view), SceneError);
}

void set_eye(Camera& c, double value) { c.eye_world.y = float(value); }
void set_near(Camera& c, double value) { c.near_depth = value; }
void set_far(Camera& c, double value) { c.far_depth = value; }
void set_width(Camera& c, double value) { c.window = {-value, value, -1, 1}; }
void set_square(Camera& c, double value) { c.window = {-value, value, -value, value}; }
void set_aside(Camera& c, double value) { c.window = {value - 1, value + 1, -1, 1}; }
void set_shear(Camera& c, double value) { c.shear = {value, 0}; }
void set_eye_aside(Camera& c, double value) { c.eye_world.x = float(value); }

void set_far_square(Camera& c, double value) {
    c.far_depth = 1e9;
    set_square(c, value);
}
void set_long_shear(Camera& c, double value) {
    c.far_depth = value;
    c.window = {-1e6, 1e6, -1e6, 1e6};
    c.shear = {1e3, 0};
}
void set_slender(Camera& c, double value) {
    c.window = {-1e-9, 1e-9, -1e-9, 1e-9};
    c.near_depth = value;
}

const std::vector<Limit> limits{
    {"Eye", perspective(), set_eye, 9.9e10, 1.1e11, "eye's largest coordinate"},
    {"EyeOfInfinity", perspective(), set_eye, 0, inf, "eye's largest coordinate"},
    {"EyeOfNoNumber", perspective(), set_eye, 0, nan, "eye's largest coordinate"},
    {"Near", perspective(), [](Camera& c, double v) { c.far_depth = inf, c.near_depth = v; }, 1e11, 1.1e11,
     "near plane's depth"},
    {"FieldOfView", perspective(), set_square, 1e4, 1.1e4, "farthest side"},
    {"FieldOfViewOfAPoint", perspective(), [](Camera& c, double v) { c.near_depth = 10, set_width(c, v); },
     1.1e-10, 0.9e-10, "nearer pair of sides"},
    {"WindowAside", perspective(), set_aside, 9e3, 1.1e4, "farthest side"},
    {"WindowFarAside", perspective(),
     [](Camera& c, double v) {
         c.window = {1 - v, 1, -1, 1};
     },
     1.1e-7, 0.9e-7, "width over its distance"},
    {"VolumeBeforeNear", perspective(), set_near, 5e-8, 4e-8, "volume before the near plane"},
    {"VolumeOfASlenderView", perspective(), set_slender, 0.05, 0.04, "volume before the near plane"},
    {"Slab", perspective(), set_far, 1.000002, 1.0000005, "(far - near) / far"},
    {"FarWhereverItIs", perspective(), set_far, inf, 1.0000005, "(far - near) / far"},
    {"ParallelEye", parallel(), set_eye_aside, 1.9e7, 2.1e7, "width over its distance"},
    {"ParallelFar", parallel(), set_far, 0.9e10, 1.1e10, "over the farther plane's depth"},
    {"ParallelNear", parallel(), set_near, -0.9e10, -1.1e10, "over the farther plane's depth"},
    {"ParallelWindow", parallel(), set_square, 1e11, 1.1e11, "window's farthest side"},
    {"ParallelWindowOfAPoint", parallel(), set_square, 5e-8, 4e-8, "window's volume"},
    {"ParallelWindowOfALongView", parallel(), set_far_square, 0.11, 0.09, "over the farther plane's depth"},
    {"Shear", parallel(), [](Camera& c, double v) { set_shear(c, v), c.far_depth = 2; }, 1e4, 1.1e4,
     "the shear is"},
    {"ShearAtFar", parallel(), set_long_shear, 0.9e8, 1.1e8, "shear at the far plane"},
    {"ParallelSlab", parallel(), set_far, 1.000002, 1.0000005, "farther plane's depth"},
};

INSTANTIATE_TEST_SUITE_P(Ranges, LimitOfACamera, testing::ValuesIn(limits),
                         [](const auto& tested) { return tested.param.name; });

TEST(JudgedRanges, CoordinatesOfVerticesAreNamedWithTheirVertex) {
    Scene scene;
    scene.name = "far";
    scene.vertices.position_world = {{0, 0, 0}, {-9.9e10f, 1e-45f, 0}};
    EXPECT_EQ(outside_judged_ranges(scene), "");
    for (const float bad : {1.1e11f, -1.1e11f, float(inf), float(nan)}) {
        scene.vertices.position_world[1].z = bad;
        EXPECT_THAT(outside_judged_ranges(scene), testing::HasSubstr("vertex 1 of scene 'far'")) << bad;
        EXPECT_THROW(require_judged(scene), SceneError);
    }
}

TEST(JudgedRanges, AMessageSaysValueRangeAndRemedy) {
    View view{.name = "v", .camera = perspective(), .width = 8, .height = 8};
    view.camera.eye_world.x = 1e30f;
    EXPECT_EQ(outside_judged_ranges(view),
              "camera: the eye's largest coordinate is 1e+30; judged up to 1e+11; scale the scene down, or "
              "move it to the origin (docs/scenes.md)");
}

}  // namespace
}  // namespace zproof
