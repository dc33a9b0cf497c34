#include "reports/expectations.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace zproof {
namespace {

/// The views of a scene that expects edge and clip, each with pixels of one class.
std::vector<ViewResult> views_showing(std::initializer_list<PixelClass> classes) {
    std::vector<ViewResult> views;
    for (const PixelClass c : classes) {
        ViewResult& view = views.emplace_back();
        view.counts[std::size_t(c)] = 1;
        view.view_place = views.size() - 1;
        view.scene_views = classes.size();
        view.expects = {"edge", "clip"};
    }
    return views;
}

TEST(Expectations, AreMetByAllViewsTogether) {
    std::vector<ViewResult> views = views_showing({PixelClass::edge, PixelClass::clip});
    hold_to_expectations(views);
    EXPECT_EQ(views[0].outcome, Outcome::proven);
    EXPECT_EQ(views[1].outcome, Outcome::proven);
}

TEST(Expectations, FailTheSceneThatNoLongerShowsAClass) {
    std::vector<ViewResult> views = views_showing({PixelClass::edge, PixelClass::agree});
    hold_to_expectations(views);
    EXPECT_EQ(views[1].outcome, Outcome::defective);
    EXPECT_NE(views[1].message.find("class clip "), std::string::npos) << views[1].message;
}

TEST(Expectations, SayNothingOfASceneOfWhichAViewIsMissing) {
    std::vector<ViewResult> views = views_showing({PixelClass::edge, PixelClass::agree});
    hold_to_expectations(std::span{views}.first(1));
    EXPECT_EQ(views[0].outcome, Outcome::proven);
}

}  // namespace
}  // namespace zproof
