#include "cli/early_end.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

ViewResult view_with(Outcome outcome, const std::string& message = "") {
    ViewResult view;
    view.view = "main";
    view.outcome = outcome;
    view.message = message;
    return view;
}

TEST(EarlyEnd, IsDueAfterSoManyViewsThatFailed) {
    EarlyEnd end({.max_failed_views = 2});
    for (const Outcome outcome : {Outcome::proven, Outcome::defective, Outcome::not_judged}) {
        end.note(view_with(outcome));
        EXPECT_FALSE(end.is_due()) << name_of(outcome);
    }
    end.note(view_with(Outcome::undecided));
    EXPECT_EQ(end.why(), "the run ended after 2 views that failed (-x, --max-defects)");
}

TEST(EarlyEnd, IsDueWhereTheFirstThreeViewsAreRefusedInTheSameWords) {
    const auto after = [](const std::vector<ViewResult>& views, Persistence persistence = Persistence::ends) {
        EarlyEnd end({.persistence = persistence});
        for (const ViewResult& view : views) end.note(view);
        return end.is_due();
    };
    const ViewResult same = view_with(Outcome::unreadable, "no"), other = view_with(Outcome::unreadable, "?"),
                     proven = view_with(Outcome::proven);
    ViewResult scene = view_with(Outcome::unreadable, "broken");
    scene.view = "";
    EXPECT_TRUE(after({same, same, same}));
    EXPECT_TRUE(after({scene, same, same, same}));
    EXPECT_FALSE(after({same, same}));
    EXPECT_FALSE(after({same, other, same}));
    EXPECT_FALSE(after({proven, same, same, same}));
    EXPECT_FALSE(after({same, same, same}, Persistence::keeps_going));
}

/// Five scenes, and a renderer that gives no frame of any.
class EndsEarly : public testing::Test {
  protected:
    EndsEarly() {
        for (const char* name : {"a", "b", "c", "d", "e"})
            folder.write(std::string("models/") + name + ".gltf", two_triangles());
    }
    Ran judged(const Words& more) const {
        Words words{"run", "models", "--width", "32", "--height", "24", "--oracle", "none"};
        words.insert(words.end(), more.begin(), more.end());
        return run(folder, words);
    }
    json results() const { return json::parse(folder.read("zproof-out/results.json")); }
    int views_of(const std::string& outcome) const {
        int count = 0;
        const json all = results();
        for (const json& view : all.at("views")) count += view.at("outcome") == outcome;
        return count;
    }
    Folder folder;
};

TEST_F(EndsEarly, BeforeItBeginsWhereTheRendererIsNotThere) {
    for (const char* missing : {"./notthere {out}", "no-such-program {out}", "models/a.gltf {out}"}) {
        const Ran ran = judged({"--renderer", missing});
        EXPECT_EQ(ran.exit_code, 2) << missing;
        EXPECT_THAT(ran.err, HasSubstr("expected a program that can be started, found '"));
        EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << ran.err;
    }
    EXPECT_EQ(folder.names(), Words{"models"});
    EXPECT_EQ(judged({"--renderer", "cd models && false {out}"}).exit_code, 3) << "a word of the shell's own";
}

TEST_F(EndsEarly, WhereTheRendererRefusesTheFirstThreeViews) {
    const Ran ran = judged({"--renderer", "ls {scene} {out}"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_THAT(ran.out, HasSubstr("'{out}': No such file")) << "the folder is another one each time";
    EXPECT_EQ(results().at("run").at("ending"), "stopped");
    EXPECT_EQ(views_of("unreadable"), 3);
    EXPECT_THAT(ran.out, HasSubstr("! unreadable  3 views: a/frame-all, b/frame-all, c/frame-all"));
    EXPECT_THAT(ran.out, HasSubstr("? not judged  2 whole scenes: d, e\n    the first three views were "));
    EXPECT_THAT(ran.out, HasSubstr("cannot judge everything: 3 views; 2 whole scenes not judged; report: "));
    EXPECT_EQ(judged({"--renderer", "false {out}", "--keep-going"}).exit_code, 3);
    EXPECT_EQ(views_of("unreadable"), 5);
    EXPECT_EQ(results().at("run").at("ending"), "complete");
}

TEST_F(EndsEarly, AfterTheFirstFailureThatIsTooMany) {
    folder.write("one.gltf", one_triangle());
    ASSERT_EQ(run(folder, {"render", "one.gltf", "--width", "32x24", "-o", "frames"}).exit_code, 0);
    const std::string half = "cp " + folder.path().string() + "/frames/frame-all.exr {out}";
    EXPECT_EQ(judged({"--renderer", half, "-x"}).exit_code, 1);
    EXPECT_EQ(views_of("defective"), 1);
    EXPECT_EQ(views_of("not_judged"), 4);
    const Ran two = judged({"--renderer", half, "--max-defects", "2"});
    EXPECT_EQ(two.exit_code, 1);
    EXPECT_EQ(views_of("defective"), 2);
    EXPECT_THAT(two.out, HasSubstr("; next: zproof explain models/"));
    EXPECT_EQ(judged({"-x"}).exit_code, 0) << "nothing fails";
    EXPECT_EQ(results().at("run").at("ending"), "complete");
    EXPECT_EQ(judged({"-x", "--max-defects", "2"}).exit_code, 2);
}

/// The renderer is right again for every scene but one.
TEST_F(EndsEarly, AndAnotherRunJudgesOnlyWhatFailed) {
    ASSERT_EQ(judged({"--renderer", "false {out}", "--keep-going", "-o", "old"}).exit_code, 3);
    folder.write("models/f.gltf", two_triangles());
    EXPECT_EQ(judged({"--only-failed", "old/results.json"}).exit_code, 0);
    EXPECT_EQ(results().at("views").size(), 5u) << "f is new";
    const Ran none = judged({"--only-failed", "zproof-out"});
    EXPECT_EQ(none.exit_code, 4);
    EXPECT_THAT(none.err, HasSubstr("no view of what was named failed in zproof-out"));
    const Ran unnamed = run(
        folder, {"run", "--only-failed", "old", "--width", "32", "--height", "24", "--oracle", "none", "-q"});
    EXPECT_EQ(unnamed.out, "proven: 5 views; report: zproof-out/report.html\n") << unnamed.err;
    EXPECT_EQ(judged({"--only-failed", "nowhere"}).exit_code, 3);
}

}  // namespace
}  // namespace zproof::test
