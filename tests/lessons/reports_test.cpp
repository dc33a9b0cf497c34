/// Whatever a study finds, its document holds together and says what was found.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "lessons/cost/report.h"
#include "lessons/depth/report.h"
#include "lessons/shading/report.h"
#include "reports/pages/error_colours.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

document::Document with(document::Document document, const std::vector<document::Section>& sections) {
    std::ranges::copy(sections, std::back_inserter(document.sections));
    return document;
}

const document::Table& table_of(const document::Document& document, std::string_view name) {
    for (const document::Section& section : document.sections)
        for (const document::Item& item : section.items)
            if (document::name_of(item) == name) return std::get<document::Table>(item);
    throw std::out_of_range(std::string{name});
}

study::depth::GapStudy few_gaps() {
    using namespace study::depth;
    GapStudy study;
    for (const double ratio : ladder_ratios()) {
        for (const char* name : {"z-unorm16", "reversed-float32"})
            study.curves.push_back(gap_curve(format_named(name), Interpolation::reciprocal, {1, ratio}, 3));
        for (int decade = 1; decade <= 7; ++decade)
            study.choices.push_back({ratio, std::pow(10.0, -decade), {}});
    }
    study.choices.front().names = {"z-unorm16", "w-unorm16"};
    study.ways = {gap_curve(format_named("z-float32"), Interpolation::ndc, {1, 1e4}, 3)};
    return study;
}

TEST(DepthDocument, HoldsTogetherAndAnswersTheQuestion) {
    const Loaded loaded = generate_suite_scene("depth_range", 64, 36);
    const study::depth::DepthStudy found =
        study::depth::study_depth(loaded.scene, loaded.views.front(), [](const std::string&) {});
    const document::Document document =
        with(depth_document(few_gaps(), {{1, 10}, 1e-3}), depth_sections(found, "range"));
    EXPECT_NO_THROW(document::require_sound(document));
    const document::Table& choice = table_of(document, "choice");
    EXPECT_EQ(choice.rows.size(), 7u);
    EXPECT_EQ(std::get<std::string>(choice.rows[0][1]), "z-unorm16, w-unorm16");
    EXPECT_EQ(std::get<std::string>(choice.rows[0][2]), "none");
    const document::Table& formats = table_of(document, "formats");
    EXPECT_EQ(formats.rows.size(), study::depth::formats().size());
    for (const document::Row& row : formats.rows)
        EXPECT_EQ(std::get<std::string>(row[4]) == "yes", std::get<double>(row[2]) <= 1e-3);
    EXPECT_EQ(table_of(document, "range-errors").rows.size(), 4 * study::depth::formats().size());
}

TEST(DepthDocument, AViewThatShowsNothingSaysSo) {
    const study::depth::DepthStudy nothing;
    ASSERT_EQ(depth_sections(nothing, "none").size(), 1u);
    EXPECT_NE(depth_sections(nothing, "none").front().paragraphs.front().find("No pixel"), std::string::npos);
}

TEST(ShadingDocument, HoldsTogether) {
    using namespace study::shading;
    const Loaded loaded = sphere(1, 48);
    const View& view = loaded.views.front();
    const TessellationStudy levels = study_tessellation(lighting_of(view, Highlight::phong), 1, 48);
    const ShadingStudy found = study_shading(loaded.scene, view, [](const std::string&) {});
    const document::Document document = with(shading_document(levels), {shading_section(found, "sphere")});
    EXPECT_NO_THROW(document::require_sound(document));
    EXPECT_EQ(table_of(document, "levels").rows.size(), 2u * 3);
    EXPECT_EQ(table_of(document, "sphere-methods").rows.size(), found.scores.size());
}

TEST(CostDocument, HoldsTogetherAndShowsWhatIsNotDetermined) {
    using namespace study::cost;
    Model model;
    for (int i = 1; i <= 9; ++i) {
        const Quantities q{100. * i, 10. * i * i, 1000. / i, 64. * i * i * i, 9};
        model.runs.push_back({"vertices", Stages::all, q, {1000. + i, 1000, 1001. + i, 3}});
    }
    std::vector<Observation> rows;
    for (const study::cost::Run& run : model.runs)
        rows.push_back({factors_of(run.quantities, run.stages), run.timing.median});
    model.whole_runs = model.runs;
    model.fit = model.whole_fit = fitted(rows);
    Prediction prediction{"a scene", "a view", {1, 2, 3, 4, 5}, {5, 4, 6, 3}, 5, {}};
    prediction.share.assign(constant_names().size(), 0.1);
    const Loaded loaded = generate_suite_scene("closed_surfaces", 64, 36);
    const OptimizationStudy optimizations = study_optimizations(loaded.scene, loaded.views.front(), 1);
    auto document = with(cost_document(model), prediction_sections({prediction}));
    document = with(std::move(document), {optimization_section(optimizations, "closed")});
    EXPECT_NO_THROW(document::require_sound(document));
    const document::Table& constants = table_of(document, "constants");
    EXPECT_EQ(std::get<std::string>(constants.rows[0][0]), "k_bus");
    EXPECT_NEAR(std::get<double>(constants.rows[0][3]), 1.0 / 3, 1e-3);
    EXPECT_TRUE(std::isnan(std::get<double>(constants.rows[0][2])));
    EXPECT_EQ(table_of(document, "closed-optimizations").rows.size(), optimizations.runs.size());
    EXPECT_TRUE(prediction_sections({}).empty());
}

TEST(ErrorColours, GrowLighterAndCutOffAtTheEnds) {
    Plane<float> errors({5, 1});
    const std::array<float, 5> values{0.0f, 1e-9f, 1e-4f, 1.0f, std::numeric_limits<float>::quiet_NaN()};
    std::ranges::copy(values, errors.pixels().begin());
    const Plane<Rgb8> colours = error_colours(errors, {1e-9, 1});
    EXPECT_EQ(colours.at(0, 0), colours.at(1, 0));
    EXPECT_EQ(colours.at(3, 0), (Rgb8{253, 231, 37}));
    EXPECT_EQ(colours.at(4, 0), (Rgb8{128, 128, 128}));
    EXPECT_GT(int(colours.at(2, 0).g), int(colours.at(1, 0).g));
}

}  // namespace
}  // namespace zproof
