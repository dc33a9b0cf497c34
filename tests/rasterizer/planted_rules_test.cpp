#include "tests/support/planted_rules.h"

#include <gtest/gtest.h>

#include <string>

#include "drawing.h"
#include "rasterizer/rasterizer.h"

namespace zproof::rasterizer {
namespace {

/// Has what every planted defect breaks: shared edges through pixel centres, an upright asymmetry, slanted
/// and intersecting surfaces, something between eye and near plane.
Scene telltale() {
    std::vector<Triangle> triangles{
        {glm::vec3{-4, 4, -4},
         {4, 4, -4},
         {-4, -4, -4}},  // a wall whose two halves meet on the image's diagonal
        {glm::vec3{4, 4, -4}, {4, -4, -4}, {-4, -4, -4}},
        {glm::vec3{-0.1f, 0.1f, -0.2f}, {0.1f, 0.1f, -0.2f}, {0, 0.2f, -0.2f}},  // before the near plane
        {glm::vec3{-3, 1, -1.5f}, {3, 2, -9}, {-2, 3, -6}},
    };
    std::mt19937 random(14);
    for (const Triangle& t : random_triangles(random, 20, {-2, -2, -6}, {2, 2, -2})) triangles.push_back(t);
    return scene_of(triangles);
}

View telltale_view() {
    View view{.name = "telltale", .camera = {}, .width = 64, .height = 64};
    view.camera.near_depth = 0.5;
    return view;
}

class EveryPlantedRule : public testing::TestWithParam<PlantedRules> {};

TEST_P(EveryPlantedRule, ChangesTheFrame) {
    const Scene scene = telltale();
    const Frame correct = render(scene, telltale_view());
    EXPECT_FALSE(same_bits(correct, render_by(GetParam().rules, scene, telltale_view())));
}

INSTANTIATE_TEST_SUITE_P(PlantedRules, EveryPlantedRule, testing::ValuesIn(planted_rules),
                         [](const auto& suite) { return std::string(suite.param.name); });

TEST(PlantedRules, CorrectRulesAreTheShippedRenderer) {
    const Scene scene = telltale();
    EXPECT_TRUE(same_bits(render(scene, telltale_view()), render_by(correct_rules, scene, telltale_view())));
}

TEST(PlantedRules, ExclusiveFillLeavesHolesAlongSharedEdges) {
    const std::vector<Triangle> square{at_pixels(0, 0, 4, 0, 0, 4), at_pixels(4, 0, 4, 4, 0, 4)};
    EXPECT_EQ(picture(square, 4, 4, {.fill = FillRule::exclusive}), R"(
111.
11.1
1.11
.111
)");
}

TEST(PlantedRules, InclusiveFillHitsSharedEdgesTwice) {
    const std::vector<Triangle> square{at_pixels(0, 0, 4, 0, 0, 4), at_pixels(4, 0, 4, 4, 0, 4)};
    EXPECT_EQ(picture(square, 4, 4, {.fill = FillRule::inclusive}), R"(
1112
1121
1211
2111
)");
}

TEST(PlantedRules, HalfPixelShiftSamplesCorners) {
    const Triangle t = at_pixels(0.75, 0.75, 2.75, 0.75, 0.75, 2.75);
    EXPECT_EQ(picture({t}, 4, 4), "\n....\n.1..\n....\n....\n");
    EXPECT_EQ(picture({t}, 4, 4, {.sample_offset_px = 0}), "\n....\n.11.\n.1..\n....\n");
}

TEST(PlantedRules, YFlippedMirrorsThePicture) {
    const Triangle t = at_pixels(0, 0, 4, 0, 0, 2);
    EXPECT_EQ(picture({t}, 4, 4), "\n111.\n1...\n....\n....\n");
    EXPECT_EQ(picture({t}, 4, 4, {.raster_y = RasterY::up}), "\n....\n....\n1...\n111.\n");
}

TEST(PlantedRules, ReversedDepthTestKeepsTheFarthest) {
    Triangle near = at_pixels(0, 0, 8, 0, 0, 8), far = near;
    for (glm::vec3& p : far) p.z = -5;
    const Frame frame =
        render_by({.depth_test = DepthTest::farther_wins}, scene_of({near, far}), raster_view(2, 2));
    EXPECT_EQ(ids(frame), "\n11\n11\n");
    for (const float depth : frame.camera_depth.pixels()) EXPECT_EQ(depth, 5);
}

TEST(PlantedRules, NoNearClipShowsWhatIsBeforeTheNearPlane) {
    const Scene scene = scene_of({{glm::vec3{-9, -9, -0.2f}, {9, -9, -0.2f}, {0, 9, -0.2f}}});
    const Frame correct = render(scene, telltale_view());
    const Frame planted = render_by({.near_clip = NearClip::just_before_the_eye}, scene, telltale_view());
    EXPECT_EQ(correct.primitive.at(32, 32), PrimitiveId::none);
    EXPECT_EQ(planted.primitive.at(32, 32), PrimitiveId{0});
    EXPECT_NEAR(planted.camera_depth.at(32, 32), 0.2, 1e-6);
}

TEST(PlantedRules, AffineDepthIsTheMeanHalfWayAlong) {
    // An upright plane from depth 2 to depth 6 as seen in the image: half way, 1 / depth is the mean of the
    // ends', so the true depth is 3 and the affine one 4.
    const Scene scene = scene_of({{glm::vec3{-2, -20, -2}, {-2, 20, -2}, {6, 0, -6}}});
    View view = telltale_view();
    view.width = view.height = 33;
    const Rules affine{.depth_interpolation = DepthInterpolation::affine};
    EXPECT_NEAR(render(scene, view).camera_depth.at(16, 16), 3, 0.02);
    EXPECT_NEAR(render_by(affine, scene, view).camera_depth.at(16, 16), 4, 0.02);
}

TEST(PlantedRules, FourSubpixelBitsMoveVerticesByUpToAThirtySecond) {
    const Triangle t = at_pixels(0.53f, 0, 4, 0, 0.53f, 4);
    EXPECT_EQ(picture({t}, 2, 2), "\n.1\n.1\n");
    EXPECT_EQ(picture({t}, 2, 2, {.subpixel_bits = 4}), "\n11\n11\n");
}

}  // namespace
}  // namespace zproof::rasterizer
