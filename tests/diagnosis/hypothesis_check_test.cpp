/// A claim is decided within a hundredth of the judge's work, and counts as unexplained beyond.
#include "compare/diagnosis/hypothesis_check.h"

#include <gtest/gtest.h>

namespace zproof {
namespace {

View one_pixel() {
    View view{.name = "by_hand", .camera = {}, .width = 1, .height = 1};
    view.camera.projection = Projection::parallel;
    view.camera.window = {.left = 0, .right = 1, .bottom = -1, .top = 0};
    view.camera.near_depth = 0.25;
    view.camera.far_depth = 64;
    return view;
}

void add(Scene& scene, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto first = std::uint32_t(scene.vertices.position_world.size());
    for (const glm::vec3& p : {a, b, c}) scene.vertices.position_world.push_back(p);
    scene.triangles.emplace_back(first, first + 1, first + 2);
}

/// A wall, and before it a grid of so many triangles a side that cover half of the pixel.
Scene wall_behind_grid(int side) {
    Scene scene;
    add(scene, {-64, -64, -8}, {192, -64, -8}, {-64, 192, -8});
    const float step = 1 / float(side);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const float x = float(column) * step, y = -float(row) * step;
            add(scene, {x, y - step, -4}, {x + step, y - step, -4}, {x, y, -4});
        }
    return scene;
}

struct Decided {
    bool by_judge, by_hypothesis;
};

/// May the wall be seen between the grid's triangles?
Decided wall_is_admitted(int side) {
    const Scene scene = wall_behind_grid(side);
    const View view = one_pixel();
    Frame frame({1, 1});
    frame.primitive.at(0, 0) = PrimitiveId{0};
    frame.camera_depth.at(0, 0) = 8;
    const RenderedFrame both{frame, BoundedPrecision{.eps_px = 0.5, .depth_relative = 1e-3}};
    const DiagnosisInput input{scene, view, both, both};
    const Hypothesis declared = as_declared(input, "", "");
    const Claim claim{0, 0, {PrimitiveId{0}, 8.0f}};
    const HypothesisQuery query{&declared, {&claim, 1}};
    const ViewBounds bounds(view, both.precision);
    const Adjudicator judge(scene, view, {&bounds}, QueryDetail::admissibility);
    const PixelQuery asked{&bounds, PrimitiveId{0}, 0, 0};
    return {is_admissible(judge.decide({&asked, 1}).front().decision.admissibility),
            check_claims(input, {&query, 1}, CheckDetail::admissibility).front().front().is_admissible};
}

TEST(HypothesisCheck, DecidesAsTheJudgeDoes) {
    const auto [by_judge, by_hypothesis] = wall_is_admitted(3);
    EXPECT_TRUE(by_judge);
    EXPECT_TRUE(by_hypothesis);
}

TEST(HypothesisCheck, LeavesWhatTakesMoreThanAHundredthOfTheJudgesWork) {
    const auto [by_judge, by_hypothesis] = wall_is_admitted(24);
    EXPECT_TRUE(by_judge);
    EXPECT_FALSE(by_hypothesis);
}

}  // namespace
}  // namespace zproof
