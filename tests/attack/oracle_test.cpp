/// The attack's oracle against values worked by hand.
#include "tests/attack/oracle.h"

#include <gtest/gtest.h>

namespace zproof::attack {
namespace {

/// An image of 8 x 8 pixels; perspective with a window of [-1, 1], so that a unit at depth 1 is four pixels.
View view_of(Projection projection) {
    View view{.name = "by_hand", .camera = {}, .width = 8, .height = 8};
    view.camera.projection = projection;
    view.camera.near_depth = 1;
    view.camera.far_depth = 100;
    return view;
}

Scene scene_of(const std::vector<glm::vec3>& p_world) {
    Scene scene;
    for (const glm::vec3& p : p_world) scene.vertices.position_world.push_back(p);
    for (std::uint32_t i = 0; i < p_world.size(); i += 3) scene.triangles.emplace_back(i, i + 1, i + 2);
    return scene;
}

ExactPlace at(double x, double y) { return {Number(x), Number(y)}; }

TEST(AttackOracle, ProjectsInPerspective) {
    // at depth 2 a unit is two pixels; raster (4, 4) is the axis
    const ExactScene exact(scene_of({{0, 0, -2}, {1, 0, -2}, {0, 2, -4}}), view_of(Projection::perspective));
    const ExactImage& image = exact.image(0);
    ASSERT_EQ(image.size(), 3u);
    EXPECT_EQ(image[0].x, 4);
    EXPECT_EQ(image[0].y, 4);
    EXPECT_EQ(image[1].x, 6);
    EXPECT_EQ(image[2].y, 2);
    EXPECT_EQ(exact.depth(image[2].front), 4);
}

TEST(AttackOracle, ProjectsAlongASlant) {
    View view = view_of(Projection::parallel);
    view.camera.shear = {0.25, 0};
    // at depth 2 a view ray has gone half a unit to the right: two pixels
    const ExactScene exact(scene_of({{0, 0, -2}, {1, 0, -2}, {0, 1, -2}}), view);
    EXPECT_EQ(exact.image(0)[0].x, 2);
    EXPECT_EQ(exact.image(0)[0].y, 4);
    EXPECT_EQ(exact.depth(exact.image(0)[0].front), 2);
}

TEST(AttackOracle, TakesTheAxesAsTheyAre) {
    View view = view_of(Projection::parallel);
    view.camera.right = {2, 0, 0};  // p_world = u right: half of x
    const ExactScene exact(scene_of({{1, 0, -2}, {0, 0, -2}, {0, 1, -2}}), view);
    EXPECT_EQ(exact.image(0)[0].x, 6);
}

TEST(AttackOracle, CutsAtNear) {
    // from (0, 0) at depth 2 to depth 0: what lies before depth 1 is gone, through the middle of both sides
    const ExactScene exact(scene_of({{0, 0, -2}, {1, 0, 0}, {0, 1, 0}}), view_of(Projection::perspective));
    const ExactImage& image = exact.image(0);
    ASSERT_EQ(image.size(), 3u);
    for (const auto& corner : image) EXPECT_GE(exact.depth(corner.front), 1);
    EXPECT_TRUE(covers(image, at(5, 3.5)));
    EXPECT_FALSE(
        covers(image, at(5.5, 3)));  // (0.5, 0.5, -1) lies on the cut at raster (6, 2): (5, 3) half way
    EXPECT_TRUE(ExactScene(scene_of({{0, 0, -0.5}, {1, 0, 0}, {0, 1, 0}}), view_of(Projection::perspective))
                    .image(0)
                    .empty());
}

TEST(AttackOracle, MeasuresInTheLargerCoordinate) {
    const ExactScene exact(scene_of({{-1, -1, -2}, {1, -1, -2}, {-1, 1, -2}}), view_of(Projection::parallel));
    const ExactImage& image = exact.image(0);  // (0, 8), (8, 8), (0, 0)
    EXPECT_EQ(distance_to(image, at(10, 7)), Number(2));
    EXPECT_EQ(distance_to(image, at(5, 3)), Number(1));  // its side y = x is 2 away in x, and in y
    EXPECT_EQ(distance_to(image, at(-1, -3)), Number(3));
    EXPECT_EQ(distance_to(image, at(4, 4)), Number(0));
    EXPECT_EQ(inset_of(image, at(2, 5)), Number(3) / 2);
    EXPECT_EQ(inset_of(image, at(1, 5)), Number(1));
    EXPECT_EQ(inset_of(image, at(4, 4)), Number(0));
    EXPECT_EQ(inset_of(image, at(5, 3)), Number(0));
}

TEST(AttackOracle, KnowsDepthsInASquare) {
    // x = 0 at depth 2, x = 1 at depth 4; 1 / depth is affine in the image
    const ExactScene exact(scene_of({{0, -1, -2}, {1, 0, -4}, {0, 1, -2}}), view_of(Projection::perspective));
    const ExactImage& image = exact.image(0);  // (4, 6), (5, 4), (4, 2)
    EXPECT_EQ(front_at(image, at(4.5, 4)), Number(3) / 8);
    const auto wide = front_in_square(image, at(4.5, 4), Number(2));
    ASSERT_TRUE(wide);
    EXPECT_EQ(exact.depth(wide->greatest), 2);  // not beyond its corners
    EXPECT_EQ(exact.depth(wide->least), 4);
    const auto narrow = front_in_square(image, at(4.5, 4), Number(1) / 4);
    EXPECT_EQ(narrow->greatest, Number(7) / 16);
    EXPECT_FALSE(front_in_square(image, at(7, 4), Number(1)));
}

TEST(AttackOracle, SeesATriangleEdgeOnAsItsSides) {
    const ExactScene exact(scene_of({{0, 0, -2}, {0, 1, -2}, {0, 0, -4}}), view_of(Projection::perspective));
    const ExactImage& image = exact.image(0);  // x = 4 from y = 2 to 4
    EXPECT_EQ(twice_area(image), 0);
    EXPECT_FALSE(covers(image, at(4, 3)));
    EXPECT_EQ(distance_to(image, at(4.5, 3)), Number(1) / 2);
    EXPECT_FALSE(front_at(image, at(4, 3)));
    EXPECT_EQ(exact.depth(front_in_square(image, at(4, 3.5), Number(2))->least), 4);
}

}  // namespace
}  // namespace zproof::attack
