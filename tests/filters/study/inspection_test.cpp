// What a method reads at a pixel, and what the numbers say of it.
#include "filters/study/inspection.h"

#include <gtest/gtest.h>

#include <numeric>

#include "filters/methods/catalogue.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/study/worst_pixels.h"
#include "rasterizer/texturing.h"
#include "scenes/filters/filter_scenes.h"

namespace zproof::study {
namespace {

texture::KernelShape shape(const glm::dvec2& centroid, double uu, double vv) {
    return {.sum = 1, .centroid = centroid, .covariance = {{uu, 0}, {0, vv}}};
}

constexpr texture::Ellipse along_u{.major = 8, .minor = 2, .major_direction = {1, 0}};

TEST(FindingsOf, NamesTheAxisOnWhichWeightsSpreadTooWideOrTooLittle) {
    const auto findings = findings_of(along_u, shape({5, 5}, 4, 9), shape({5, 5}, 16, 1));
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].fault, WeightFault::alias);
    EXPECT_TRUE(findings[0].is_along_major);
    EXPECT_EQ(findings[0].found, 2);
    EXPECT_EQ(findings[0].exact, 4);
    EXPECT_EQ(findings[1].fault, WeightFault::blur);
    EXPECT_FALSE(findings[1].is_along_major);
    EXPECT_EQ(findings[1].found, 3);
    EXPECT_EQ(findings[1].exact, 1);
}

TEST(FindingsOf, NamesAShiftByItsAxisAndLength) {
    const auto findings = findings_of(along_u, shape({5, 5.25}, 4, 1), shape({5, 5}, 4, 1));
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].fault, WeightFault::shift);
    EXPECT_FALSE(findings[0].is_along_major);
    EXPECT_EQ(findings[0].found, 0.25);
}

TEST(FindingsOf, NamesNothingWhereMomentsAreAlike) {
    EXPECT_TRUE(findings_of(along_u, shape({5, 5}, 4, 1), shape({5, 5}, 4, 1)).empty());
    EXPECT_TRUE(findings_of(along_u, shape({5, 5}, 4 + 1e-9, 1), shape({5, 5}, 4, 1)).empty());
}

class OnTheWorkedPlane : public testing::Test {
  protected:
    Loaded loaded_ = generate_filter_scene("worked", 64, 64);
    const View& view_ = loaded_.views[0];
    Frame frame_ = oracle::exact_visibility(loaded_.scene, view_);
    Inspector inspector_{loaded_.scene, view_, frame_, oracle::Reconstruction::nearest};

    static StudyMethod method(const char* name) { return {name, {.method = *texture::find_method(name)}}; }
};

TEST_F(OnTheWorkedPlane, TheTapsGiveThePixelThatThePictureHas) {
    for (const char* name : {"nearest", "trilinear-gl", "ewa-true", "sat-affine", "ripmap"}) {
        const StudyMethod one = method(name);
        const Picture picture = rasterizer::filtered(loaded_.scene, view_, frame_, one.texturing);
        for (const PixelInspection& found : inspector_.at(one, {{10, 60}, {31, 30}, {50, 20}})) {
            ASSERT_TRUE(found.reading) << name;
            EXPECT_NEAR(found.result.r, double(picture.at(found.x, found.y).r), 1e-6) << name;
            EXPECT_NEAR(found.reading->shape.sum, 1, 1e-6) << name;
        }
    }
}

TEST_F(OnTheWorkedPlane, ExactWeightsGiveTheTruth) {
    const oracle::AreaTruth truth = oracle::area_truth(loaded_.scene, view_, oracle::Reconstruction::nearest);
    const PixelInspection found = inspector_.at(method("nearest"), {{10, 60}}).front();
    ASSERT_TRUE(found.exact);
    EXPECT_FALSE(found.exact->wraps);
    EXPECT_NEAR(found.factor.r * found.exact->mean.r, truth.mean.at(10, 60).r, 1e-12);
    EXPECT_NEAR(found.exact->shape.sum, 1, 1e-12);
}

/// A square filter as wide as the long axis is far too wide for the short one.
TEST_F(OnTheWorkedPlane, IsotropicFiltersBlurAlongTheMinorAxisAndPointsAlias) {
    const auto says = [](const PixelInspection& found, WeightFault fault, bool is_along_major) {
        return std::ranges::any_of(found.findings, [&](const WeightFinding& f) {
            return f.fault == fault && f.is_along_major == is_along_major;
        });
    };
    const PixelInspection wide = inspector_.at(method("trilinear-gl"), {{31, 30}}).front(),
                          point = inspector_.at(method("nearest"), {{31, 30}}).front();
    ASSERT_GT(wide.ellipse.major, 2 * wide.ellipse.minor);
    EXPECT_TRUE(says(wide, WeightFault::blur, false));
    EXPECT_FALSE(says(wide, WeightFault::alias, false));
    EXPECT_TRUE(says(point, WeightFault::alias, true));
    EXPECT_TRUE(says(point, WeightFault::alias, false));
    ASSERT_EQ(wide.reading->images.size(), 2u);
    EXPECT_TRUE(wide.reading->images[0].level);
    EXPECT_NEAR(wide.reading->images[0].weight + wide.reading->images[1].weight, 1, 1e-12);
}

TEST_F(OnTheWorkedPlane, SumsOfATableAreNoLevels) {
    const PixelInspection found = inspector_.at(method("sat-affine"), {{31, 30}}).front();
    ASSERT_FALSE(found.reading->images.empty());
    EXPECT_FALSE(found.reading->images[0].level);
}

TEST_F(OnTheWorkedPlane, WhatManySumsOfSumsAreMadeOfIsNotTold) {
    EXPECT_FALSE(inspector_.at(method("quadratic-sat"), {{31, 30}}).front().reading);
}

TEST_F(OnTheWorkedPlane, WhatGivenLevelsAreMadeOfIsNotTold) {
    StudyMethod own = method("trilinear-gl");
    own.texturing.options.given_levels = std::make_shared<const std::vector<texture::LinearImage>>();
    const PixelInspection found = inspector_.at(own, {{31, 30}}).front();
    EXPECT_FALSE(found.reading);
    EXPECT_TRUE(found.exact);
}

TEST_F(OnTheWorkedPlane, WhatOthersReadIsNotRecorded) {
    StudyMethod foreign = method("nearest");
    foreign.paint = [](const Scene&, const View&, const Frame&) { return Picture{}; };
    const PixelInspection found = inspector_.at(foreign, {{31, 30}}).front();
    EXPECT_FALSE(found.reading);
    EXPECT_TRUE(found.exact);
    EXPECT_TRUE(found.findings.empty());
    EXPECT_GT(found.window.width, 0);
}

TEST_F(OnTheWorkedPlane, AboveTheHorizonThereIsNoTexture) {
    const PixelInspection found = inspector_.at(method("nearest"), {{31, 0}}).front();
    EXPECT_EQ(found.texture_width, 0);
    EXPECT_FALSE(found.reading);
}

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Whatever the block, a window loses no weight.
TEST_F(OnTheWorkedPlane, WindowsHoldAllWeightsInAFewCells) {
    for (const PixelInspection& found : inspector_.at(method("ewa-true"), {{31, 16}, {31, 30}, {10, 60}})) {
        const TextureWindow& window = found.window;
        EXPECT_LE(std::max(window.width, window.height), most_window_cells);
        EXPECT_EQ(window.colour.size(), std::size_t(window.width) * std::size_t(window.height));
        EXPECT_NEAR(sum_of(window.read), found.reading->shape.sum, 1e-12);
        ASSERT_TRUE(found.exact);
        EXPECT_NEAR(sum_of(window.exact), found.exact->shape.sum, 1e-12);
    }
}

TEST(WorstPixels, AreTheGreatestErrorsOfTheirRegions) {
    const Picture truth({3, 1});
    Picture picture = truth;
    picture.at(0, 0) = {0.1f, 0, 0};
    picture.at(1, 0) = {0, 0, -0.3f};
    picture.at(2, 0) = {0.2f, 0.2f, 0.2f};
    Region all{"all", Plane<std::uint8_t>({3, 1}, 1), 3}, part = all,
                                                          none{"none", Plane<std::uint8_t>({3, 1}), 0};
    part.mask.at(1, 0) = 0;
    const auto worst = worst_pixels(picture, truth, std::vector<Region>{all, part, none});
    EXPECT_EQ(worst[0], (std::vector<PixelCoord>{{1, 0}}));
    EXPECT_EQ(worst[1], (std::vector<PixelCoord>{{2, 0}}));
    EXPECT_TRUE(worst[2].empty());
}

TEST(WorstPixels, WhatIsNoNumberIsWorst) {
    EXPECT_EQ(pixel_error({std::nanf(""), 0.5f, 0}, {0, 0, 0}), std::numeric_limits<double>::infinity());
}

TEST(ChosenPixels, ServeEveryMethodBeforeTheNextRegion) {
    const std::vector<MethodPixels> methods{{"a", {{{1, 0}}, {{1, 0}}, {{2, 0}}}},
                                            {"b", {{{3, 0}}, {{4, 0}}, {}}}};
    const auto chosen = chosen_pixels(methods, 3);
    EXPECT_EQ(chosen[0].pixels, (std::vector<PixelCoord>{{1, 0}}));
    EXPECT_EQ(chosen[1].pixels, (std::vector<PixelCoord>{{3, 0}, {4, 0}}));
    EXPECT_EQ(chosen_pixels(methods, 9)[0].pixels, (std::vector<PixelCoord>{{1, 0}, {2, 0}}));
}

}  // namespace
}  // namespace zproof::study
