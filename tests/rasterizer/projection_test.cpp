#include "rasterizer/projection.h"

#include <gtest/gtest.h>

#include <limits>

#include "drawing.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer {
namespace {

Camera turned_camera() {
    Camera camera;
    camera.eye_world = {3, -2, 5};
    camera.right = {0.6, 0, -0.8};
    camera.up = {0, 1, 0};
    camera.back = {0.8, 0, 0.6};
    camera.window = {.left = -0.7, .right = 0.9, .bottom = -0.4, .top = 0.6};
    return camera;
}

glm::dvec4 to_clip(const Camera& camera, const glm::dvec4& p_world) {
    return clip_from_camera(camera) * (camera_from_world(camera) * p_world);
}

TEST(Projection, CameraSpaceLooksDownMinusZ) {
    const Camera camera = turned_camera();
    const glm::dvec3 p =
        glm::dvec3(camera.eye_world) + 2.0 * camera.right + 3.0 * camera.up - 4.0 * camera.back;
    const glm::dvec4 p_camera = camera_from_world(camera) * glm::dvec4(p, 1);
    EXPECT_NEAR(p_camera.x, 2, 1e-14);
    EXPECT_NEAR(p_camera.y, 3, 1e-14);
    EXPECT_NEAR(p_camera.z, -4, 1e-14);
}

// The lesson's own program, line by line, with its canvas on the near plane.
TEST(Projection, AgreesWithTheLessonsStages) {
    const Camera camera = turned_camera();
    const ViewSetup setup({.name = "", .camera = camera, .width = 640, .height = 480}, correct_rules);
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 p_camera{uniform(random, -5, 5), uniform(random, -5, 5), uniform(random, -50, -1)};
        const glm::vec3 p_world{glm::dvec3(camera.eye_world) + p_camera.x * camera.right +
                                p_camera.y * camera.up + p_camera.z * camera.back};
        const glm::dvec3 p{camera_from_world(camera) * glm::dvec4(p_world, 1)};
        const double near = camera.near_depth;
        const double l = near * camera.window.left, r = near * camera.window.right;
        const double b = near * camera.window.bottom, t = near * camera.window.top;
        const double x_screen = near * p.x / -p.z, y_screen = near * p.y / -p.z;
        const double x_ndc = 2 * x_screen / (r - l) - (r + l) / (r - l);
        const double y_ndc = 2 * y_screen / (t - b) - (t + b) / (t - b);
        const ClipVertex v = setup.clip_from_world(p_world);
        ASSERT_NEAR(v.x / v.w, x_ndc, 1e-12 * (1 + std::abs(x_ndc)));
        ASSERT_NEAR(v.y / v.w, y_ndc, 1e-12 * (1 + std::abs(y_ndc)));
        ASSERT_NEAR(v.depth, -p.z, 1e-12 * -p.z);
        const auto snapped = setup.snap(v);
        ASSERT_TRUE(snapped);
        ASSERT_NEAR(snapped->p.x / 256.0, (x_ndc + 1) / 2 * 640, 1.0 / 512 + 1e-9);
        ASSERT_NEAR(snapped->p.y / 256.0, (1 - y_ndc) / 2 * 480, 1.0 / 512 + 1e-9);
    }
}

TEST(Projection, NearAndFarMeetTheNamedNdcInterval) {
    struct Case {
        NdcDepth range;
        double at_near, at_far;
    };
    for (const auto& [range, at_near, at_far] :
         {Case{NdcDepth::minus_one_to_one, -1, 1}, Case{NdcDepth::zero_to_one, 0, 1},
          Case{NdcDepth::zero_to_one_reversed, 1, 0}}) {
        for (const Projection kind : {Projection::perspective, Projection::parallel}) {
            Camera camera = turned_camera();
            camera.projection = kind;
            camera.ndc_depth = range;
            const auto z_ndc = [&](double depth) {
                const glm::dvec4 p = clip_from_camera(camera) * glm::dvec4(0, 0, -depth, 1);
                return p.z / p.w;
            };
            EXPECT_NEAR(z_ndc(camera.near_depth), at_near, 1e-12);
            EXPECT_NEAR(z_ndc(camera.far_depth), at_far, 1e-12);
        }
    }
}

TEST(Projection, InfiniteFarPlaneIsTheLimitOfDistantOnes) {
    Camera distant = turned_camera(), infinite = turned_camera();
    distant.far_depth = 1e18;
    infinite.far_depth = std::numeric_limits<double>::infinity();
    for (const NdcDepth range :
         {NdcDepth::minus_one_to_one, NdcDepth::zero_to_one, NdcDepth::zero_to_one_reversed}) {
        distant.ndc_depth = infinite.ndc_depth = range;
        const glm::dvec4 a = to_clip(distant, {4, 1, -20, 1}), b = to_clip(infinite, {4, 1, -20, 1});
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(a[k], b[k], 1e-12 * (1 + std::abs(b[k])));
    }
}

// Camera.h: p_camera(t) = (u, v, 0) + t (shear.x, shear.y, -1) is seen at (u, v) for every t.
TEST(Projection, LinesOfSightOfAnObliqueCameraAreSeenAsPoints) {
    Camera camera = turned_camera();
    camera.projection = Projection::parallel;
    camera.shear = {0.5, -0.25};
    for (const double t : {1.0, 10.0, 100.0}) {
        const glm::dvec4 p = clip_from_camera(camera) * glm::dvec4(0.1 + t * 0.5, 0.2 - t * 0.25, -t, 1);
        EXPECT_NEAR(p.x / p.w, 2 * (0.1 + 0.7) / 1.6 - 1, 1e-12);
        EXPECT_NEAR(p.y / p.w, 2 * (0.2 + 0.4) / 1.0 - 1, 1e-12);
    }
}

}  // namespace
}  // namespace zproof::rasterizer
