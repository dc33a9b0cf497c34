/// Every known fault is called by its name.
#include "compare/diagnosis/diagnosis.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <functional>
#include <ostream>
#include <span>
#include <variant>

#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"
#include "tests/diagnosis/frame_faults.h"
#include "tests/support/planted_rules.h"

namespace zproof {
namespace {

/// One view of a suite scene before the judge.
class DiagnosisFixture {
  public:
    DiagnosisFixture(const std::string& scene, std::size_t view)
        : loaded_(generate_suite_scene(scene, 480, 270)),
          view_(loaded_.views.at(view)),
          reference_(oracle::Embree(loaded_.scene).trace(view_)) {}

    const Scene& scene() const { return loaded_.scene; }
    const View& view() const { return view_; }
    Frame drawn_by(const rasterizer::Rules& rules) const {
        return rasterizer::render_by(rules, loaded_.scene, view_);
    }
    std::optional<Diagnosis> diagnosis_of(const Frame& frame,
                                          const Precision& declared = rasterizer::precision(),
                                          std::span<const EarlierCause> earlier = {}) const {
        const RenderedFrame ours{frame, declared}, theirs{reference_, oracle::embree_precision()};
        return diagnose(scene(), view_, ours, theirs, judge(scene(), view_, ours, theirs), {}, {}, earlier);
    }

  private:
    Loaded loaded_;
    View view_;
    Frame reference_;
};

std::string told(const Explanation& e) {
    return e.name + ": " + std::to_string(e.explained) + "/" + std::to_string(e.asked) +
           ", contradicted by " + std::to_string(e.contradicted) + "/" + std::to_string(e.checked) + "\n";
}

std::string told(const std::optional<Diagnosis>& d) {
    if (!d) return "no defects";
    std::string text = d->cause ? told(*d->cause) : "no single cause\n";
    for (const Explanation& e : d->runners_up) text += "  " + told(e);
    return text;
}

void expect_cause(const std::optional<Diagnosis>& diagnosis, const std::string& cause) {
    ASSERT_TRUE(diagnosis);
    EXPECT_EQ(diagnosis->cause ? diagnosis->cause->name : "", cause) << told(diagnosis);
}

struct Planted {
    std::string name, scene;
    std::size_t view;
    rasterizer::Rules rules;
    std::string cause;
};

void PrintTo(const Planted& planted, std::ostream* out) { *out << planted.name << " in " << planted.scene; }

class PlantedRule : public testing::TestWithParam<Planted> {};

TEST_P(PlantedRule, IsNamed) {
    const Planted& planted = GetParam();
    const DiagnosisFixture fixture(planted.scene, planted.view);
    expect_cause(fixture.diagnosis_of(fixture.drawn_by(planted.rules)), planted.cause);
}

Planted planted(const std::string& name, const std::string& scene, std::size_t view,
                const std::string& cause) {
    const auto& all = rasterizer::planted_rules;
    return {name, scene, view, std::ranges::find(all, name, &rasterizer::PlantedRules::name)->rules, cause};
}

/// Fewer bits of either kind, so that "how many" is put to the test.
Planted with_bits(int bits, const std::string& cause) {
    return {"bits_" + std::to_string(bits), "room", 0, {.subpixel_bits = bits}, cause};
}

INSTANTIATE_TEST_SUITE_P(
    Rasterizer, PlantedRule,
    testing::Values(planted("half_pixel_shift", "room", 0, "the image is shifted by (+1/2, +1/2) px"),
                    planted("affine_depth", "room", 0, "depth is affine instead of perspective-correct"),
                    planted("exclusive_fill", "fan_at_pixel_centre", 0, "the top-left rule is missing"),
                    planted("y_flipped", "room", 0, "the image is flipped in y"),
                    planted("no_near_clip", "near_plane", 0, "the near clip is missing"),
                    planted("depth_test_reversed", "room", 0, "the depth test is reversed"),
                    planted("four_subpixel_bits", "room", 0, "only 4 sub-pixel bits"),
                    with_bits(7, "only 7 sub-pixel bits"), with_bits(2, "only 2 sub-pixel bits")),
    [](const auto& test) { return test.param.name; });

class InjectedFault : public testing::TestWithParam<FrameFault> {};

TEST_P(InjectedFault, IsNamed) {
    const DiagnosisFixture fixture(GetParam().scene, 0);
    const Frame good = fixture.drawn_by(rasterizer::correct_rules);
    expect_cause(fixture.diagnosis_of(GetParam().inject(fixture.scene(), fixture.view(), good)),
                 GetParam().cause);
}

INSTANTIATE_TEST_SUITE_P(Frame, InjectedFault, testing::ValuesIn(frame_faults()),
                         [](const auto& test) { return test.param.name; });

TEST(Diagnosis, OfAFaultlessFrameIsNone) {
    const DiagnosisFixture fixture("room", 0);
    EXPECT_FALSE(fixture.diagnosis_of(fixture.drawn_by(rasterizer::correct_rules)));
}

const FrameFault& fault_named(const std::string& name) {
    return *std::ranges::find(frame_faults(), name, &FrameFault::name);
}

Frame faulty(const DiagnosisFixture& fixture, const std::string& fault) {
    const Frame good = fixture.drawn_by(rasterizer::correct_rules);
    return fault_named(fault).inject(fixture.scene(), fixture.view(), good);
}

/// Rounding down displaces the whole picture by half a grid step, which 7 bits would explain as well.
TEST(Diagnosis, TellsTruncationFromFewerBits) {
    const DiagnosisFixture fixture("room", 0);
    View view = fixture.view();
    Window& w = view.camera.window;
    const double du = (w.right - w.left) / view.width / 512, dv = (w.top - w.bottom) / view.height / 512;
    w = {w.left + du, w.right + du, w.bottom - dv, w.top - dv};
    expect_cause(fixture.diagnosis_of(rasterizer::render(fixture.scene(), view)),
                 "vertices are snapped up and left");
}

TEST(Diagnosis, TellsTheNumberThatItFitted) {
    const DiagnosisFixture fixture("room", 0);
    Frame frame = fixture.drawn_by(rasterizer::correct_rules);
    for (float& depth : frame.camera_depth.pixels()) depth *= 1.125f;
    const auto diagnosis = fixture.diagnosis_of(frame);
    expect_cause(diagnosis, "depth is scaled by a constant");
    EXPECT_EQ(diagnosis->cause->fitted.substr(0, 25), "depth is told times 1.125");
}

TEST(Diagnosis, CountsWhatWasAsked) {
    const DiagnosisFixture fixture("room", 0);
    const auto few = fixture.diagnosis_of(faulty(fixture, "row_lost"));
    ASSERT_TRUE(few && few->cause);
    EXPECT_EQ(few->defects, 480u);
    EXPECT_EQ(few->cause->asked, 480u);
    EXPECT_EQ(few->cause->explained, 480u);
    const auto many = fixture.diagnosis_of(faulty(fixture, "shifted_up"));
    ASSERT_TRUE(many && many->cause);
    EXPECT_GT(many->defects, 100'000u);
    EXPECT_EQ(many->cause->asked, 1000u);
    EXPECT_GT(explained_share(*many->cause), 0.98) << "the lowest row has come from nowhere";
    EXPECT_LT(explained_share(*many->cause), 1);
}

/// Declares 12 sub-pixel bits of a picture that has 8.
std::optional<Diagnosis> diagnosis_of_few_bits(std::size_t view, std::span<const EarlierCause> earlier,
                                               const std::string& scene = "room") {
    const DiagnosisFixture fixture(scene, view);
    const Precision declared = RasterPrecision{.subpixel_bits = 12};
    return fixture.diagnosis_of(fixture.drawn_by(rasterizer::correct_rules), declared, earlier);
}

/// Nine bits would spare more, for they leave few; but they leave some.
TEST(Diagnosis, NamesWhatLeavesNothingWhereTheBestLeavesSome) {
    expect_cause(diagnosis_of_few_bits(1, {}), "only 8 sub-pixel bits");
}

TEST(Diagnosis, TakesWhatExplainedEarlierViewsWhereItSparesEnoughOfAll) {
    expect_cause(diagnosis_of_few_bits(0, {}), "");
    const std::array earlier{EarlierCause{"depth has the wrong sign", 9e6, 1e7},
                             EarlierCause{"only 8 sub-pixel bits", 9e6, 1e7}};
    const auto diagnosis = diagnosis_of_few_bits(0, earlier);
    expect_cause(diagnosis, "only 8 sub-pixel bits");
    EXPECT_EQ(diagnosis->cause->asked, 1000u);
    EXPECT_LT(diagnosis->cause->saved_share, 0.75);
    const std::array poor{EarlierCause{"only 8 sub-pixel bits", 7.4e6, 1e7}};
    expect_cause(diagnosis_of_few_bits(0, poor), "");
}

/// All its defects are depths, which alone do not tell that triangles were moved.
TEST(Diagnosis, BelievesEarlierViewsThatTrianglesWereMovedWhereOnlyDepthsAreWrong) {
    EXPECT_NE(diagnosis_of_few_bits(0, {}, "t_junctions")->cause.value_or(Explanation{}).name,
              "only 8 sub-pixel bits");
    const std::array earlier{EarlierCause{"only 8 sub-pixel bits", 9e6, 1e7}};
    expect_cause(diagnosis_of_few_bits(0, earlier, "t_junctions"), "only 8 sub-pixel bits");
}

/// A renderer has as many bits in one view as in another. Here telling the few defects one by one is shorter.
TEST(Diagnosis, TakesARuleOfTheRendererAlsoWhereItSparesNothing) {
    expect_cause(diagnosis_of_few_bits(2, {}, "off_axis"), "");
    const std::array earlier{EarlierCause{"only 8 sub-pixel bits", 9e6, 1e7}};
    const auto diagnosis = diagnosis_of_few_bits(2, earlier, "off_axis");
    expect_cause(diagnosis, "only 8 sub-pixel bits");
    EXPECT_LT(diagnosis->cause->saved_bits, 0);
    EXPECT_EQ(diagnosis->cause->contradicted, 0u);
    const std::array poor{EarlierCause{"only 8 sub-pixel bits", 7.505e6, 1e7}};
    expect_cause(diagnosis_of_few_bits(2, poor, "off_axis"), "");
}

TEST(Diagnosis, DoesNotBelieveEarlierViewsWhereAPixelIsLeft) {
    const DiagnosisFixture fixture("room", 0);
    const std::array earlier{EarlierCause{"depth is scaled by a constant", 9e6, 1e7}};
    expect_cause(fixture.diagnosis_of(faulty(fixture, "transposed"), rasterizer::precision(), earlier),
                 "the image is transposed");
}

TEST(Diagnosis, OfASceneWithoutTrianglesNamesNoCause) {
    const View view = generate_suite_scene("room", 8, 8).views.front();
    Frame frame({8, 8});
    const Frame reference = frame;
    frame.primitive.at(3, 3) = PrimitiveId{7};
    const RenderedFrame ours{frame, rasterizer::precision()}, theirs{reference, oracle::embree_precision()};
    const auto diagnosis = diagnose(Scene{}, view, ours, theirs, judge(Scene{}, view, ours, theirs));
    ASSERT_TRUE(diagnosis);
    EXPECT_EQ(diagnosis->defects, 1u);
    EXPECT_FALSE(diagnosis->cause);
}

/// What a transposed picture does not cover stays blank.
TEST(Diagnosis, NamesAFurtherCauseOfWhatTheFirstLeaves) {
    const DiagnosisFixture fixture("room", 0);
    const auto diagnosis = fixture.diagnosis_of(faulty(fixture, "transposed"));
    expect_cause(diagnosis, "the image is transposed");
    ASSERT_EQ(diagnosis->further.size(), 1u) << told(diagnosis);
    EXPECT_EQ(diagnosis->further[0].name, "the last columns are missing");
}

TEST(Diagnosis, OneWrongPixelProvesNoRule) {
    const DiagnosisFixture fixture("room", 0);
    Frame frame = fixture.drawn_by(rasterizer::correct_rules);
    frame.camera_depth.at(240, 135) *= 1.001f;
    const auto diagnosis = fixture.diagnosis_of(frame);
    expect_cause(diagnosis, "");
    EXPECT_EQ(diagnosis->defects, 1u);
}

/// Declared planes are not those that were drawn with. The rasterizer knows nothing of the hypothesis.
std::optional<Diagnosis> diagnosis_with_planes(const std::string& scene, std::size_t view_index,
                                               const std::function<void(Camera&)>& changed) {
    const DiagnosisFixture fixture(scene, view_index);
    View other = fixture.view();
    changed(other.camera);
    return fixture.diagnosis_of(rasterizer::render(fixture.scene(), other));
}

TEST(Diagnosis, NamesANearPlaneThatLiesNearerOrFarther) {
    const auto nearer = diagnosis_with_planes("near_plane", 0, [](Camera& c) { c.near_depth *= 0.7; });
    const auto farther = diagnosis_with_planes("near_plane", 0, [](Camera& c) { c.near_depth *= 1.05; });
    expect_cause(nearer, "the near plane lies nearer");
    expect_cause(farther, "the near plane lies farther");
}

TEST(Diagnosis, NamesTheFarClipThatAParallelViewMisses) {
    const auto missing = diagnosis_with_planes("parallel_planes", 0, [](Camera& c) { c.far_depth = 1e6; });
    expect_cause(missing, "the far clip is missing");
}

TEST(Diagnosis, NamesPixelsTakenForSquare) {
    const DiagnosisFixture fixture("room", 0);
    View declared = fixture.view();
    declared.camera.window.left *= 1.5;
    declared.camera.window.right *= 1.5;
    const Frame reference = oracle::Embree(fixture.scene()).trace(declared);
    const Frame frame = rasterizer::render(fixture.scene(), fixture.view());  // its pixels are square
    const RenderedFrame ours{frame, rasterizer::precision()}, theirs{reference, oracle::embree_precision()};
    expect_cause(
        diagnose(fixture.scene(), declared, ours, theirs, judge(fixture.scene(), declared, ours, theirs)),
        "pixels are taken for square: the width follows the height");
}

/// A row is missing, and ten depths are wrong for no reason.
TEST(Diagnosis, NamesNoCauseThatLeavesDefects) {
    const DiagnosisFixture fixture("room", 0);
    Frame frame = faulty(fixture, "row_lost");
    for (int x = 100; x < 110; ++x) frame.camera_depth.at(x, 40) *= 1.1f + 0.01f * float(x);
    expect_cause(fixture.diagnosis_of(frame), "");
}

TEST(Diagnosis, DoesNotDependOnThreads) {
    const DiagnosisFixture fixture("room", 0);
    const Frame frame = fixture.drawn_by({.subpixel_bits = 5});
    std::string one, three;
    tbb::task_arena(1).execute([&] { one = told(fixture.diagnosis_of(frame)); });
    tbb::task_arena(3).execute([&] { three = told(fixture.diagnosis_of(frame)); });
    EXPECT_EQ(one, three);
}

}  // namespace
}  // namespace zproof
