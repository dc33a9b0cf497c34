#include "reports/fit/fit_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/fit/fit_words.h"

namespace zproof {
namespace {

using measure::LeftOut;

FittedView sample() {
    FittedView view{"room", "door", {}};
    view.fit.pixels = 4096;
    view.fit.eps.px = {0.0021, 0.00212};
    view.fit.eps.decided_by = {{3, 4}};
    view.fit.eps_px.add(measure::least_octave, 4000);
    view.fit.eps_px.add(-9, 94);
    view.fit.eps_px.add(0, 2);
    view.fit.promise = {.eps_px = 0.00212, .depth_relative = 1e-7};
    view.fit.is_verified = true;
    return view;
}

FittedView with_two_alone() {
    FittedView view = sample();
    view.fit.eps_of_alone.px = {0.69, 0.7};
    for (const int x : {12, 80}) view.fit.left_out.push_back({{x, 7}, {}, LeftOut::Reason::alone_by_place});
    return view;
}

TEST(FitWords, SayWhatExplainsEveryPixel) {
    EXPECT_EQ(fit_in_words(sample().fit), "eps 0.00212 px explains every pixel");
}

TEST(FitWords, ShowThePixelsThatStandAlone) {
    EXPECT_EQ(fit_in_words(with_two_alone().fit),
              "eps 0.00212 px explains all but 2 pixels; those need 0.7 px: look at (12, 7), (80, 7)");
}

TEST(FitWords, NameEveryOtherReason) {
    FittedView view = sample();
    view.fit.left_out = {{{1, 2}, {}, LeftOut::Reason::beyond_all_places},
                         {{3, 4}, {}, LeftOut::Reason::no_answer}};
    EXPECT_EQ(fit_in_words(view.fit),
              "eps 0.00212 px explains every other pixel; 1 pixel that no eps up to 8 px explains: look at "
              "(1, 2); 1 pixel without an answer: look at (3, 4)");
}

TEST(FitReport, CoversAllViews) {
    FittedView other = sample();
    other.fit.promise = {.eps_px = 0.001, .depth_relative = 1e-6, .watertight = false};
    const BoundedPrecision promise = promise_of({sample(), other});
    EXPECT_EQ(promise, (BoundedPrecision{.eps_px = 0.00212, .depth_relative = 1e-6, .watertight = false}));
    EXPECT_TRUE(explains_all({sample(), other}));
    EXPECT_FALSE(explains_all({sample(), with_two_alone()}));
    other.fit.is_verified = false;
    EXPECT_FALSE(explains_all({other}));
}

TEST(FitReport, IsASoundDocument) {
    const document::Document document = fit_document("mine", {sample(), with_two_alone()});
    EXPECT_NO_THROW(document::require_sound(document));
    EXPECT_EQ(document.sections.size(), 3u);
    EXPECT_EQ(fit_document("mine", {sample()}).sections.size(), 2u);
}

TEST(FitJson, HasAVersionAndTheCurve) {
    const auto json = nlohmann::json::parse(fit_json("mine", {with_two_alone()}));
    EXPECT_EQ(json["schema_version"], "1.0");
    EXPECT_EQ(json["explains_all"], false);
    const auto& view = json["views"][0];
    EXPECT_EQ(view["eps"]["high_px"], 0.00212);
    EXPECT_EQ(view["left_out"][0]["pixel"], nlohmann::json({12, 7}));
    EXPECT_EQ(view["left_out"][0]["why"], "alone_by_place");
    EXPECT_EQ(view["eps_curve"].front()["not_explained"], 96);
    EXPECT_EQ(view["eps_curve"].back()["not_explained"], 0);
    EXPECT_EQ(view["promise"]["kind"], "bounded");
}

}  // namespace
}  // namespace zproof
