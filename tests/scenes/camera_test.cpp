#include "scenes/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "scenes/frame_all.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The message of the refusal, or "valid".
std::string verdict_on(const std::function<void(Camera&)>& change) {
    Camera camera;
    change(camera);
    try {
        validate(camera);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "valid";
}

TEST(CameraValidate, AcceptsWhatRendersAPicture) {
    EXPECT_EQ(verdict_on([](Camera&) {}), "valid");
    EXPECT_EQ(verdict_on([](Camera& c) { c.far_depth = infinity; }), "valid");
    EXPECT_EQ(verdict_on([](Camera& c) {
                  c.projection = Projection::parallel;
                  c.near_depth = -5;
                  c.shear = {0.5, -0.25};
              }),
              "valid");
}

TEST(CameraValidate, NamesTheFieldThatIsWrong) {
    const std::vector<std::pair<const char*, std::function<void(Camera&)>>> cases{
        {"camera eye", [](Camera& c) { c.eye_world.y = std::numeric_limits<float>::infinity(); }},
        {"camera right",
         [](Camera& c) {
             c.right = {1.0000001, 0, 0};
         }},
        {"camera right", [](Camera& c) { c.right = glm::normalize(glm::dvec3(1, 1e-6, 0)); }},
        {"camera up", [](Camera& c) { c.up.x = nan; }},
        {"camera back",
         [](Camera& c) {
             c.back = {0, 0, -1};
         }},
        {"camera window", [](Camera& c) { c.window.left = c.window.right; }},
        {"camera window", [](Camera& c) { c.window.top = -2; }},
        {"camera window", [](Camera& c) { c.window.right = infinity; }},
        {"camera shear", [](Camera& c) { c.shear.x = 1; }},
        {"camera shear", [](Camera& c) { c.shear.y = nan; }},
        {"camera near", [](Camera& c) { c.near_depth = 0; }},
        {"camera near", [](Camera& c) { c.near_depth = nan; }},
        {"camera far", [](Camera& c) { c.far_depth = c.near_depth; }},
        {"camera far", [](Camera& c) { c.far_depth = nan; }},
        {"camera far", [](Camera& c) { c.projection = Projection::parallel, c.far_depth = infinity; }},
    };
    for (const auto& [field, change] : cases)
        EXPECT_TRUE(verdict_on(change).starts_with(field)) << field << ", got: " << verdict_on(change);
}

TEST(CameraLookAt, LooksAlongMinusBackWithUpAbove) {
    const Camera camera = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
    EXPECT_EQ(camera.back, glm::dvec3(0, 0, 1));
    EXPECT_EQ(camera.right, glm::dvec3(1, 0, 0));
    EXPECT_EQ(camera.up, glm::dvec3(0, 1, 0));
}

TEST(CameraLookAt, RoundsTheEyeFirst) {
    const Camera camera = look_at({0.1, 0, 0}, {0.1, 0, -1}, {0, 1, 0});
    EXPECT_EQ(camera.eye_world.x, 0.1f);
    EXPECT_EQ(camera.back, glm::normalize(glm::dvec3(0.1f, 0, 0) - glm::dvec3(0.1, 0, -1)));
    EXPECT_NE(camera.back.x, 0) << "computed from the eye before rounding";
}

TEST(CameraLookAt, IsOrthonormalEvenWhereUpIsAlmostAlongTheView) {
    for (double slant = 1; slant > 1e-8; slant /= 3) {
        SCOPED_TRACE(slant);
        EXPECT_NO_THROW(validate(look_at({1, 2, 3}, {-4, 1, 2.5}, {5, 1 + slant, 0.5})));
    }
}

TEST(CameraLookAt, RefusesWhatSpansNoView) {
    EXPECT_THROW(look_at({1, 2, 3}, {1, 2, 3}, {0, 1, 0}), SceneError);
    EXPECT_THROW(look_at({0, 5, 0}, {0, 0, 0}, {0, 1, 0}), SceneError);
    EXPECT_THROW(look_at({0, 5, 0}, {0, 0, 0}, {0, 0, 0}), SceneError);
    EXPECT_THROW(look_at({0, nan, 0}, {0, 0, 0}, {1, 0, 0}), SceneError);
    EXPECT_THROW(look_at({1e39, 0, 0}, {0, 0, 0}, {0, 1, 0}), SceneError);
}

TEST(CameraWindow, OfARightAngleIsTheUnitSquare) {
    const Window window = symmetric_window(std::numbers::pi / 2, 2);
    EXPECT_NEAR(window.top, 1, 1e-15);
    EXPECT_EQ(window.bottom, -window.top);
    EXPECT_EQ(window.right, 2 * window.top);
    EXPECT_EQ(window.left, -window.right);
}

Scene triangle_at(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    Scene scene;
    scene.vertices.position_world = {a, b, c};
    scene.triangles = {{0, 1, 2}};
    return scene;
}

TEST(FrameAll, ServesEmptyFlatAndFarScenes) {
    EXPECT_NO_THROW(validate(frame_all(Scene{}, 1)));
    EXPECT_NO_THROW(validate(frame_all(triangle_at({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), 1)));
    EXPECT_NO_THROW(validate(frame_all(triangle_at({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 1)));
    EXPECT_NO_THROW(validate(frame_all(triangle_at({1e5f, 0, 0}, {1.001e5f, 0, 0}, {1e5f, 1, 0}), 1)));
}

TEST(FrameAll, RefusesWhatFloatCannotFrame) {
    EXPECT_THROW(frame_all(triangle_at({-3e38f, -3e38f, -3e38f}, {3e38f, 0, 0}, {0, 3e38f, 3e38f}), 1),
                 SceneError);
}

}  // namespace
}  // namespace zproof
