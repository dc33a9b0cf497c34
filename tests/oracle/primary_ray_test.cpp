#include "oracle/primary_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace zproof::oracle {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

/// 4 x 2 pixels over a window of 4 x 2 units: the pixel centres lie at half units.
View four_by_two() {
    View view{.name = "four_by_two", .camera = {}, .width = 4, .height = 2};
    view.camera.window = {.left = -2, .right = 2, .bottom = -1, .top = 1};
    return view;
}

/// A camera that looks along +x with z to its right: right x up = back.
void look_along_x(Camera& camera) {
    camera.right = {0, 0, 1};
    camera.up = {0, 1, 0};
    camera.back = {-1, 0, 0};
}

TEST(PrimaryRay, PerspectiveRaysLeaveTheEyeWithUnitDepthAndRowsRunDown) {
    View view = four_by_two();
    view.camera.eye_world = {10, 20, 30};
    const PrimaryRay upper_left = primary_ray(view, 0, 0), lower_right = primary_ray(view, 3, 1);
    EXPECT_EQ(upper_left.origin, glm::vec3(10, 20, 30));
    EXPECT_EQ(upper_left.direction, glm::vec3(-1.5f, 0.5f, -1));
    EXPECT_EQ(lower_right.direction, glm::vec3(1.5f, -0.5f, -1));
    EXPECT_EQ(upper_left.origin_depth, 0);
}

TEST(PrimaryRay, PerspectiveFollowsTheCamerasAxes) {
    View view = four_by_two();
    look_along_x(view.camera);
    EXPECT_EQ(primary_ray(view, 0, 0).direction, glm::vec3(1, 0.5f, -1.5f));
    EXPECT_EQ(primary_ray(view, 3, 1).direction, glm::vec3(1, -0.5f, 1.5f));
}

TEST(PrimaryRay, OffAxisWindowShiftsTheDirections) {
    View view = four_by_two();
    view.camera.window = {.left = 0, .right = 8, .bottom = -3, .top = 1};
    EXPECT_EQ(primary_ray(view, 0, 0).direction, glm::vec3(1, 0, -1));
    EXPECT_EQ(primary_ray(view, 3, 1).direction, glm::vec3(7, -2, -1));
}

TEST(PrimaryRay, DirectionIsRoundedOnceFromDouble) {
    View view = four_by_two();
    view.camera.window = {.left = 0, .right = 8.0 / 3, .bottom = -1, .top = 1};
    // u = (8/3) (0.5/4) = 1/3
    EXPECT_EQ(primary_ray(view, 0, 0).direction.x, static_cast<float>(1.0 / 3));
}

TEST(PrimaryRay, OrthographicRaysStartOnThePlaneThroughTheEyeAndRunStraight) {
    View view = four_by_two();
    view.camera.projection = Projection::parallel;
    view.camera.eye_world = {10, 20, 30};
    look_along_x(view.camera);
    const PrimaryRay ray = primary_ray(view, 3, 0);
    EXPECT_EQ(ray.origin, glm::vec3(10, 20.5f, 31.5f));
    EXPECT_EQ(ray.direction, glm::vec3(1, 0, 0));
    EXPECT_EQ(ray.origin_depth, 0);
}

TEST(PrimaryRay, ObliqueRaysStepSidewaysByTheShear) {
    View view = four_by_two();
    view.camera.projection = Projection::parallel;
    view.camera.shear = {0.25, -0.5};
    const PrimaryRay ray = primary_ray(view, 0, 0);
    EXPECT_EQ(ray.origin, glm::vec3(-1.5f, 0.5f, 0));
    EXPECT_EQ(ray.direction, glm::vec3(0.25f, -0.5f, -1));
}

TEST(PrimaryRay, NearAndFarAreTheLimitsOfT) {
    View view = four_by_two();
    view.camera.near_depth = 0.1;
    view.camera.far_depth = std::numeric_limits<double>::infinity();
    EXPECT_EQ(primary_ray(view, 1, 1).t_near, 0.1f);
    EXPECT_EQ(primary_ray(view, 1, 1).t_far, inf);
    view.camera.far_depth = 7;
    EXPECT_EQ(primary_ray(view, 1, 1).t_far, 7.0f);
    view.camera.far_depth = 1e39;  // beyond float
    EXPECT_EQ(primary_ray(view, 1, 1).t_far, inf);
}

TEST(PrimaryRay, ParallelRaysStartOnANearPlaneBehindTheEye) {
    View view = four_by_two();
    view.camera.projection = Projection::parallel;
    view.camera.shear = {0.25, 0};
    view.camera.near_depth = -2;
    view.camera.far_depth = 5;
    const PrimaryRay ray = primary_ray(view, 0, 0);
    EXPECT_EQ(ray.origin, glm::vec3(-2, 0.5f, 2));  // (-1.5, 0.5, 0) - 2 (0.25, 0, -1)
    EXPECT_EQ(ray.t_near, 0.0f);
    EXPECT_EQ(ray.t_far, 7.0f);
    EXPECT_EQ(ray.origin_depth, -2);
}

TEST(PrimaryRay, ParallelRaysStayAtTheEyesPlaneWhereNearLiesAhead) {
    View view = four_by_two();
    view.camera.projection = Projection::parallel;
    view.camera.near_depth = 2;
    view.camera.far_depth = 5;
    const PrimaryRay ray = primary_ray(view, 0, 0);
    EXPECT_EQ(ray.origin.z, 0.0f);
    EXPECT_EQ(ray.t_near, 2.0f);
    EXPECT_EQ(ray.t_far, 5.0f);
}

}  // namespace
}  // namespace zproof::oracle
