/// A claim is decided within a hundredth of the judge's work, and is not explained beyond.
#include "compare/diagnosis/hypothesis_check.h"

#include <gtest/gtest.h>

#include <mutex>

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

/// A wall, and before it a sheet of so many cells a side, two triangles each, in which one is missing.
Scene wall_behind_sheet(int side) {
    Scene scene;
    add(scene, {-64, -64, -8}, {192, -64, -8}, {-64, 192, -8});
    const float step = 2 / float(side);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const float x = float(column) * step - 0.5f, y = 0.5f - float(row) * step;
            const float right = float(column + 1) * step - 0.5f, below = 0.5f - float(row + 1) * step;
            if (row == side / 2 + 1 && column == side / 2 + 1) continue;  // not at the centre
            add(scene, {x, below, -4}, {right, below, -4}, {x, y, -4});
            add(scene, {right, below, -4}, {right, y, -4}, {x, y, -4});
        }
    return scene;
}

/// May the wall be seen through the gap? Asked of the judge, and of a hypothesis that draws by that rule.
struct GapView {
    Scene scene;
    View view = one_pixel();
    Precision precision = BoundedPrecision{.eps_px = 0.5, .depth_relative = 1e-3};
    Frame frame{{1, 1}};

    explicit GapView(int side) : scene(wall_behind_sheet(side)) {
        frame.primitive.at(0, 0) = PrimitiveId{0};
        frame.camera_depth.at(0, 0) = 8;
    }

    bool is_admitted_by_judge() const {
        const ViewBounds bounds(view, precision);
        const PixelQuery asked{&bounds, PrimitiveId{0}, 0, 0};
        const Adjudicator judge(scene, view, {&bounds}, QueryDetail::admissibility);
        return is_admissible(judge.decide({&asked, 1}).front().decision.admissibility);
    }
    bool is_explained(const RuleOverride& rule, CheckDetail detail = CheckDetail::admissibility) const {
        const RenderedFrame both{frame, precision};
        const DiagnosisInput input{scene, view, both, both};
        Hypothesis h = as_declared(input, {});
        h.amend = rule;
        const Claim claim{0, 0, {PrimitiveId{0}, 8.0f}};
        const HypothesisQuery query{&h, {&claim, 1}};
        return check_claims(input, {&query, 1}, detail).front().front().is_admissible;
    }
};

TEST(HypothesisCheck, ExplainsWhatTakesLittleWork) {
    EXPECT_TRUE(GapView(7).is_admitted_by_judge());
    EXPECT_TRUE(GapView(7).is_explained(nullptr));
}

/// So that many hypotheses can be asked.
TEST(HypothesisCheck, DoesNotExplainWhatTakesMoreThanAHundredthOfTheJudgesWork) {
    EXPECT_TRUE(GapView(16).is_admitted_by_judge());
    EXPECT_FALSE(GapView(16).is_explained(nullptr));
}

TEST(HypothesisCheck, GivesAllOtherAnswersTogetherAsMuchWorkAgain) {
    std::size_t of_the_wall = 0, of_others = 0;
    std::mutex mutex;
    const auto rule = [&](Neighbourhood& around, PrimitiveId answer) {
        const std::lock_guard lock(mutex);
        (answer == PrimitiveId{0} ? of_the_wall : of_others) += around.most_work;
    };
    EXPECT_TRUE(GapView(7).is_explained(rule, CheckDetail::open_bits));
    EXPECT_EQ(of_the_wall, Neighbourhood{}.most_work / 100);
    EXPECT_GT(of_others, 0u);
    EXPECT_LE(of_others, of_the_wall + of_the_wall / 32) << "background, and 32 triangles at most";
}

}  // namespace
}  // namespace zproof
