/// Each frame of a report is called by its name, or stands among those that are not yet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>
#include <ostream>

#include "compare/diagnosis/diagnosis.h"
#include "compare/judge.h"
#include "compare/labels/labelled_frame.h"
#include "oracle/embree.h"
#include "tests/reports_from_the_field/field_frames.h"

namespace zproof::field_reports {

/// Names the frame in the test's parameter line; found by gtest in this namespace.
void PrintTo(const FieldFrame& frame, std::ostream* out) { *out << frame.name; }

namespace {

std::vector<FieldFrame> all_frames() {
    std::vector<FieldFrame> all;
    for (const auto& family : {frames_of_drawing, frames_of_place, frames_of_depth, frames_of_depth_pictures,
                               frames_of_resolves, frames_of_ids}) {
        std::vector<FieldFrame> more = family();
        all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    return all;
}

/// Frames whose cause is not named, and why. One that is named now must leave the list.
const std::map<std::string, std::string> not_yet{
    {"stale_hierarchical_z", "what a block hides depends on the order of drawing; no hypothesis replays it"},
    {"stale_vertex_cache", "which vertex comes instead is the cache's secret; no hypothesis replays it"},
};

/// Those of which depth alone tells less.
const std::map<std::string, std::string> not_told_by_depth{
    {"first_pixel_of_the_quad", "but for four pixels at outlines, 2 x 2 pixels with one depth tell the same"},
    {"resolved_to_sample_0", "a picture that is sampled there has the same depths"},
    {"mesh_that_failed_to_load", "of which part a depth is nobody says"},
    {"node_of_another_parent", "the same"},
};

/// Those of which labels tell less.
const std::map<std::string, std::string> not_told_by_labels{
    {"node_of_another_parent", "which of a label's triangles is seen there is a guess"},
};

struct Row {
    std::string frame, right_cause, named, share, remark;
};

/// The table that is printed when all frames were tried.
class Table : public testing::Environment {
  public:
    static void add(const Row& row) { rows().push_back(row); }
    void TearDown() override {
        std::size_t right = 0;
        for (const Row& row : rows()) {
            right += row.remark == "right";
            std::printf("| %s | %s | %s | %s | %s |\n", row.frame.c_str(), row.right_cause.c_str(),
                        row.named.c_str(), row.share.c_str(), row.remark.c_str());
        }
        if (!rows().empty()) std::printf("%zu of %zu named right\n", right, rows().size());
    }

  private:
    static std::vector<Row>& rows() {
        static std::vector<Row> all;
        return all;
    }
};

const auto* const table = testing::AddGlobalTestEnvironment(new Table);

std::string told(const Explanation& e) {
    return e.name + ": " + std::to_string(e.explained) + "/" + std::to_string(e.asked) +
           ", contradicted by " + std::to_string(e.contradicted) + "/" + std::to_string(e.checked) +
           ", permits " + std::to_string(e.permitted) + ", spares " + std::to_string(e.saved_share) + "\n";
}

std::string told(const Diagnosis& d) {
    std::string text = d.cause ? told(*d.cause) : "no single cause\n";
    for (const Explanation& e : d.runners_up) text += "  " + told(e);
    return text;
}

void expect_right_cause(const FieldFrame& report, const std::optional<Diagnosis>& diagnosis,
                        const std::map<std::string, std::string>& unnamed) {
    ASSERT_TRUE(diagnosis) << "the frame has no defect";
    const std::string named = diagnosis->cause ? diagnosis->cause->name : "";
    const bool is_right = std::ranges::count(report.causes, named) > 0;
    const std::string share =
        diagnosis->cause ? std::to_string(int(100 * explained_share(*diagnosis->cause))) + " %" : "";
    Table::add({report.name, report.causes.front(), named.empty() ? "-" : named, share,
                is_right        ? "right"
                : named.empty() ? "none"
                                : "wrong"});
    if (!unnamed.contains(report.name))
        EXPECT_TRUE(is_right) << "should be: " << report.causes.front() << "\n"
                              << diagnosis->defects << " defects, " << told(*diagnosis);
    else
        EXPECT_FALSE(is_right) << "is found now: take it from the list";
}

class Report : public testing::TestWithParam<FieldFrame> {};

TEST_P(Report, IsCalledByItsCause) {
    const FieldFrame& report = GetParam();
    const Shown shown = report.rebuild();
    const Frame reference = oracle::Embree(shown.scene).trace(shown.view);
    const RenderedFrame ours{shown.frame, report.declared}, theirs{reference, oracle::embree_precision()};
    expect_right_cause(
        report, diagnose(shown.scene, shown.view, ours, theirs, judge(shown.scene, shown.view, ours, theirs)),
        not_yet);
}

/// Diagnosed as a frame of such labels.
std::optional<Diagnosis> diagnosis_of_labels(const FieldFrame& report, const TriangleLabels& labels,
                                             const Shown& shown) {
    const Frame reference = oracle::Embree(shown.scene).trace(shown.view);
    Frame said = labels.are_absent ? shown.frame : with_labels(shown.frame, labels);
    const Frame of_triangles = with_triangles(shown.scene, shown.view, {said, report.declared}, labels,
                                              {reference, oracle::embree_precision()});
    const RenderedFrame ours{of_triangles, report.declared}, theirs{reference, oracle::embree_precision()};
    return diagnose(shown.scene, shown.view, ours, theirs, judge(shown.scene, shown.view, ours, theirs),
                    {.said = SaidLabels{labels, said.primitive}});
}

/// Frames of which the depths alone are kept.
class DepthAlone : public testing::TestWithParam<FieldFrame> {};

TEST_P(DepthAlone, IsCalledByItsCause) {
    const Shown shown = GetParam().rebuild();
    expect_right_cause(GetParam(),
                       diagnosis_of_labels(GetParam(), label_triangles("none", shown.scene), shown),
                       not_told_by_depth);
}

/// Frames whose ids are those of the scene's parts.
class Labels : public testing::TestWithParam<FieldFrame> {};

TEST_P(Labels, AreCalledByTheirCause) {
    const Shown shown = GetParam().rebuild();
    TriangleLabels labels{.ids = "primitive", .of_triangle = {}};
    for (const Part& part : shown.scene.parts)
        labels.of_triangle.resize(part.first_triangle,
                                  labels.of_triangle.empty() ? 0 : labels.of_triangle.back() + 1);
    labels.of_triangle.resize(shown.scene.triangles.size(), std::uint32_t(shown.scene.parts.size()));
    expect_right_cause(GetParam(), diagnosis_of_labels(GetParam(), labels, shown), not_told_by_labels);
}

TEST(Reports, NotYetHoldsFramesOnly) {
    const std::vector<FieldFrame> all = all_frames();
    for (const auto& [name, reason] : not_yet)
        EXPECT_EQ(std::ranges::count(all, name, &FieldFrame::name), 1) << name;
}

std::string name_of(const testing::TestParamInfo<FieldFrame>& test) { return test.param.name; }

/// Those whose ids are right.
std::vector<FieldFrame> depths_of_resolves() {
    std::vector<FieldFrame> all = frames_of_resolves();
    std::erase_if(all, [](const FieldFrame& frame) { return frame.name.starts_with("ids"); });
    return all;
}

INSTANTIATE_TEST_SUITE_P(Place, DepthAlone, testing::ValuesIn(frames_of_place()), name_of);
INSTANTIATE_TEST_SUITE_P(AllDepth, DepthAlone, testing::ValuesIn(frames_of_depth()), name_of);
INSTANTIATE_TEST_SUITE_P(AllPictures, DepthAlone, testing::ValuesIn(frames_of_depth_pictures()), name_of);
INSTANTIATE_TEST_SUITE_P(AllResolves, DepthAlone, testing::ValuesIn(depths_of_resolves()), name_of);
INSTANTIATE_TEST_SUITE_P(AllPlace, Labels, testing::ValuesIn(frames_of_place()), name_of);
INSTANTIATE_TEST_SUITE_P(Field, Report, testing::ValuesIn(all_frames()), name_of);

}  // namespace
}  // namespace zproof::field_reports
