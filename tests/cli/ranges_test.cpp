// Views and scenes that are not judged (docs/scenes.md): each is refused by itself, and the run goes on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using testing::HasSubstr;

/// A view of one.gltf whose window reaches so far.
std::string view_of(const std::string& name, const std::string& side, const std::string& eye) {
    return R"({"name": ")" + name + R"(", "width": 64, "height": 48, "projection": "perspective",
        "eye": [0, 0, )" +
           eye + R"(], "target": [0, 0, -1], "up": [0, 1, 0], "near": 0.1, "far": "infinity",
        "exact_window": {"left": -)" +
           side + R"(, "right": )" + side + R"(, "bottom": -)" + side + R"(, "top": )" + side + "}}";
}

class Ranges : public testing::Test {
  protected:
    Ranges() {
        folder.write("one.gltf", one_triangle());
        folder.write("one.view.json",
                     R"({"scene": "one.gltf", "views": [)" + view_of("narrow", "1e-310", "5") + ", " +
                         view_of("far", "1", "1e30") + ", " + view_of("good", "1", "5") + "]}");
    }
    Folder folder;
};

TEST_F(Ranges, AViewBeyondThemIsRefusedAndTheOthersAreJudged) {
    const Ran ran = run(folder, {"run", "one.view.json", "--oracle", "none"});
    EXPECT_EQ(ran.exit_code, 3) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("is 1e-310; judged from 1e-10 to 10000"));
    EXPECT_THAT(ran.out, HasSubstr("is 1e+30; judged up to 1e+11"));
    EXPECT_THAT(ran.out, HasSubstr("1 proven"));
}

TEST_F(Ranges, OtherCommandsRefuseSuchAView) {
    const Ran explained = run(folder, {"explain", "one.view.json", "3", "3", "--view", "far"});
    EXPECT_EQ(explained.exit_code, 3);
    EXPECT_THAT(explained.err, HasSubstr("judged up to 1e+11"));
    EXPECT_EQ(run(folder, {"explain", "one.view.json", "3", "3", "--view", "good"}).exit_code, 0);
    EXPECT_EQ(run(folder, {"fit", "one.view.json", "--view", "narrow"}).exit_code, 3);
    EXPECT_EQ(run(folder, {"render", "one.view.json", "--renderer", "embree"}).exit_code, 3);
    EXPECT_EQ(run(folder, {"study", "depth", "one.view.json", "--view", "far"}).exit_code, 3);
}

TEST_F(Ranges, AViewBehindWhoseEyeSomethingIsSeenIsJudged) {
    folder.write("behind.view.json",
                 R"({"scene": "one.gltf", "views": [{"name": "v", "width": 64, "height": 48,
        "projection": "orthographic", "xmag": 3, "ymag": 3, "eye": [0.1, 0.2, -50], "target": [0, 0, -51],
        "up": [0, 1, 0], "near": -100, "far": 1}]})");
    const Ran ran = run(folder, {"run", "behind.view.json", "--oracle", "none", "--evidence", "all"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
}

}  // namespace
}  // namespace zproof::test
