/// The bound of attributes, worked by hand, and what the judge makes of them.
#include <gtest/gtest.h>

#include <cmath>

#include "compare/attributes/attribute_check.h"
#include "test_scene.h"

namespace zproof {
namespace {

constexpr std::size_t bary_u = 0, bary_v = 1, uv_u = 2, normal_x = 4, position_x = 7;

std::size_t index(PixelClass c) { return std::size_t(c); }

/// A wall before everything, with the right barycentrics: u = (x + 64) / 256, v = (y + 64) / 256.
TestScene wall_with_barycentrics(Projection projection) {
    TestScene t(projection, 4, 4, {wall(4)});
    answer_everywhere(t.candidate, 0, 4);
    answer_everywhere(t.reference, 0, 4);
    for (const std::size_t channel : {bary_u, bary_v}) {
        t.candidate.attributes.planes[channel] = Plane<float>({4, 4});
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x)
                t.candidate.attributes.planes[channel].at(x, y) =
                    float(((channel == bary_u ? x : y) + 64.5) / 256);
    }
    return t;
}

float& u_at_1_2(TestScene& t) { return t.candidate.attributes.planes[bary_u].at(1, 2); }

class WallAttributes : public testing::TestWithParam<Projection> {
  protected:
    TestScene t = wall_with_barycentrics(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Projections, WallAttributes,
                         testing::Values(Projection::perspective, Projection::parallel),
                         [](const auto& projection) {
                             return projection.param == Projection::perspective ? "Perspective" : "Parallel";
                         });

/// Far from the origin a corner's depth errs, and so its weight. Means of equal values do not.
TEST(Attributes, OfEqualCornersOweNothingToTheirWeights) {
    TestScene t(Projection::perspective, 1, 1, {wall(0.5)});
    t.view.camera.eye_world += glm::vec3(1000);
    for (glm::vec3& p : t.scene.vertices.position_world) p += glm::vec3(1000);
    t.scene.vertices.uv.push_back({{1000, 1000}, {1000, 1000}, {1000, 1000}});
    answer_everywhere(t.candidate, 0, 0.5);
    const auto is_wrong = [&](float uv) {
        t.candidate.attributes.planes[uv_u] = t.candidate.attributes.planes[uv_u + 1] =
            Plane<float>({1, 1}, uv);
        return AttributeCheck(t.scene, t.view, t.candidate, RasterPrecision{}).at({0, 0}).wrong.has_value();
    };
    EXPECT_FALSE(is_wrong(1000));
    EXPECT_FALSE(is_wrong(1000.0005f));
    EXPECT_TRUE(is_wrong(1000.1f));
    t.scene.vertices.uv.front() = {{0, 0}, {1, 1}, {0, 0}};
    const double right = 64.5 / 256,
                 bound =
                     ViewBounds(t.view, RasterPrecision{}).of(corners_of(t.scene, 0)).depth_absolute / 0.5;
    EXPECT_FALSE(is_wrong(float(right + 0.99 * bound)));
    EXPECT_TRUE(is_wrong(float(right + 1.03 * bound)));
}

TEST_P(WallAttributes, RightOnesAgree) { EXPECT_EQ(t.verdict().counts[index(PixelClass::agree)], 16u); }

/// 1/512 px is 1/131072 of the wall's side; 3 u are of the depth's rounding, twice, and of float32.
TEST_P(WallAttributes, TheBoundIsSnapAndRounding) {
    u_at_1_2(t) = 0;
    const auto wrong = AttributeCheck(t.scene, t.view, t.candidate, t.candidate_precision).at({1, 2}).wrong;
    ASSERT_TRUE(wrong);
    const double by_hand = 1.0 / 131072 + 3 * 0x1p-24;
    EXPECT_EQ(wrong->channel, bary_u);
    EXPECT_EQ(wrong->truth, 65.5 / 256);
    EXPECT_NEAR(wrong->high - wrong->truth, by_hand, 0.001 * by_hand);
    EXPECT_NEAR(wrong->truth - wrong->low, by_hand, 0.001 * by_hand);
    EXPECT_NEAR(wrong->error_over_bound, 65.5 / 256 / by_hand, 100);
}

TEST_P(WallAttributes, OneMayUseAllOfItsBoundAndNotATenthMore) {
    const double right = 65.5 / 256, bound = 1.0 / 131072 + 3 * 0x1p-24;
    for (const double side : {-1.0, 1.0}) {
        u_at_1_2(t) = float(right + side * 0.99 * bound);
        EXPECT_EQ(t.class_at(1, 2), PixelClass::agree) << side;
        u_at_1_2(t) = float(right + side * 1.1 * bound);
        EXPECT_EQ(t.class_at(1, 2), PixelClass::wrong_attribute) << side;
    }
}

TEST_P(WallAttributes, AWrongOneIsAFindingOfItsOwn) {
    u_at_1_2(t) = 0.5f;
    const Verdict verdict = t.verdict();
    EXPECT_EQ(verdict.counts[index(PixelClass::wrong_attribute)], 1u);
    EXPECT_EQ(verdict.counts[index(PixelClass::agree)], 15u);
    EXPECT_EQ(verdict.candidate_depth.histogram[0], 16u);
    EXPECT_EQ(verdict.adjudicated, 0u);
    EXPECT_EQ(defect_count(verdict), 1u);
    ASSERT_EQ(verdict.findings.size(), 1u);
    const Finding& f = verdict.findings[0];
    EXPECT_EQ(f.x, 1);
    EXPECT_EQ(f.y, 2);
    EXPECT_EQ(f.verdict, PixelClass::wrong_attribute);
    ASSERT_TRUE(f.wrong_attribute);
    EXPECT_EQ(f.wrong_attribute->value, 0.5f);
    EXPECT_LE(f.error_over_bound, 1);
}

TEST_P(WallAttributes, WhatIsNoNumberIsWrongAndBackgroundIsNotAsked) {
    for (const float odd : {NAN, INFINITY, -INFINITY}) {
        u_at_1_2(t) = odd;
        EXPECT_EQ(t.class_at(1, 2), PixelClass::wrong_attribute) << odd;
    }
    answer_background(t.candidate, 1, 2);
    EXPECT_EQ(t.class_at(1, 2), PixelClass::hole);
}

TEST_P(WallAttributes, AWrongDepthIsToldFirst) {
    u_at_1_2(t) = 0.5f;
    answer(t.candidate, 1, 2, 0, 4.01);
    EXPECT_EQ(t.class_at(1, 2), PixelClass::wrong_depth);
}

TEST_P(WallAttributes, AreToldBeforeTheReferencesDefect) {
    u_at_1_2(t) = 0.5f;
    answer_background(t.reference, 1, 2);
    EXPECT_EQ(t.class_at(1, 2), PixelClass::wrong_attribute);
}

/// Where two triangles may be shown, the weights are those of the one that the candidate names.
TEST_P(WallAttributes, BelongToTheTriangleThatIsNamed) {
    const double edge = 1.5 + 1.0 / 1024;
    TestScene walls(GetParam(), 4, 4, {wall_left_of(edge, 4), wall_right_of(edge, 4)});
    answer_everywhere(walls.reference, 0, 4);
    answer_everywhere(walls.candidate, 0, 4);
    answer(walls.candidate, 1, 1, 1, 4);
    for (const std::size_t channel : {bary_u, bary_v})
        walls.candidate.attributes.planes[channel] = Plane<float>({4, 4});
    float& u = walls.candidate.attributes.planes[bary_u].at(1, 1);
    float& v = walls.candidate.attributes.planes[bary_v].at(1, 1);
    // of the right wall: corner 0 on row -64, corner 2 on row 64, corner 1 far to the right
    v = 65.5f / 128, u = 0;
    EXPECT_EQ(walls.class_at(1, 1), PixelClass::edge);
    // of the left wall: corner 1 on row 64
    v = 0, u = 65.5f / 128;
    EXPECT_EQ(walls.class_at(1, 1), PixelClass::wrong_attribute);
}

TEST_P(WallAttributes, ThatNobodyPromisesAreNotJudged) {
    u_at_1_2(t) = 0.5f;
    t.candidate_precision = PlaneRayPrecision{.depth_relative = 0.01};
    EXPECT_EQ(t.class_at(1, 2), PixelClass::agree);
    t.candidate_precision = BoundedPrecision{.eps_px = 0.01, .depth_relative = 1e-6};
    EXPECT_EQ(t.class_at(1, 2), PixelClass::wrong_attribute);
}

TEST_P(WallAttributes, AreNotJudgedWhereTheSceneHasNone) {
    t.candidate.attributes.planes[uv_u] = t.candidate.attributes.planes[uv_u + 1] = Plane<float>({4, 4}, 7);
    EXPECT_EQ(t.class_at(1, 2), PixelClass::agree);
    t.scene.vertices.uv.push_back({glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)});
    EXPECT_EQ(t.class_at(1, 2), PixelClass::wrong_attribute);
}

/// Half of the side from one corner's position to the other's.
TEST_P(WallAttributes, PositionsAreInTheWorld) {
    const double scale = GetParam() == Projection::perspective ? 4 : 1;
    const double p_world[] = {1.5 * scale, -2.5 * scale, -4};
    for (std::size_t axis = 0; axis < 3; ++axis)
        t.candidate.attributes.planes[position_x + axis] = Plane<float>({4, 4}, float(p_world[axis]));
    EXPECT_EQ(t.class_at(1, 2), PixelClass::agree);
    t.candidate.attributes.planes[position_x + 2].at(1, 2) = 4;
    EXPECT_EQ(t.class_at(1, 2), PixelClass::wrong_attribute);
}

/// Normals of the corners along x, y and z: at the centre they are in the ratio of the weights.
TEST_P(WallAttributes, NormalsAreDirections) {
    t.scene.vertices.normal_world = {glm::vec3{1, 0, 0}, glm::vec3{0, 1, 0}, glm::vec3{0, 0, 1}};
    const double right[] = {1 - 132.0 / 256, 65.5 / 256, 66.5 / 256};
    const auto class_of = [&](double x, double y, double z) {
        const double normal[] = {x, y, z};
        for (std::size_t axis = 0; axis < 3; ++axis)
            t.candidate.attributes.planes[normal_x + axis] = Plane<float>({4, 4}, float(normal[axis]));
        return t.class_at(1, 2);
    };
    for (const double length : {1.0, 1e-3, 1234.5})
        EXPECT_EQ(class_of(length * right[0], length * right[1], length * right[2]), PixelClass::agree);
    EXPECT_EQ(class_of(-right[0], -right[1], -right[2]), PixelClass::wrong_attribute);
    EXPECT_EQ(class_of(right[0], right[2], right[1]), PixelClass::wrong_attribute);
    EXPECT_EQ(class_of(0, 0, 0), PixelClass::wrong_attribute);
    EXPECT_EQ(class_of(right[0] + 6e-6, right[1], right[2]), PixelClass::agree);
    EXPECT_EQ(class_of(right[0] + 6e-5, right[1], right[2]), PixelClass::wrong_attribute);
}

}  // namespace
}  // namespace zproof
