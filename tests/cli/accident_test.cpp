// Whatever crashes, one scene or one view is lost: the run goes on and leaves its report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Accidents : public testing::Test {
  protected:
    Accidents() {
        folder.write("a.gltf", one_triangle());
        folder.write("b.gltf", two_triangles());
        folder.write("c.gltf", one_triangle());
    }

    /// Scenes of two triangles have the accident.
    Ran run_with(const std::string& accident, Words words = {"run", "a.gltf", "b.gltf", "c.gltf"}) const {
        for (const char* word :
             {"--oracle", "none", "--width", "32", "--height", "24", "--report", "html,json,junit,md"})
            words.emplace_back(word);
        return run(folder, words,
                   {"LD_PRELOAD=" ZPROOF_ACCIDENTS, "ACCIDENT=" + accident, "ACCIDENT_TRIANGLES=2",
                    "ASAN_OPTIONS=verify_asan_link_order=0"});
    }

    json results() const { return json::parse(folder.read("zproof-out/results.json")); }

    Folder folder;
};

TEST_F(Accidents, LoseOneSceneAndTheRunGoesOn) {
    for (const std::string accident : {"11", "8", "6", "7", "9", "logic_error", "exit"}) {
        const Ran ran = run_with(accident);
        EXPECT_EQ(ran.exit_code, 70) << accident << ran.out << ran.err;
        const json all = results();
        ASSERT_EQ(all.at("views").size(), 3u) << accident;
        EXPECT_EQ(all.at("views").at(0).at("outcome"), "proven");
        EXPECT_EQ(all.at("views").at(1).at("outcome"), "internal_error");
        EXPECT_EQ(all.at("views").at(2).at("outcome"), "proven");
        EXPECT_EQ(all.at("summary").at("internal_error"), 1);
    }
}

TEST_F(Accidents, AreToldWithTheirSignalTheirStageAndTheCommandThatRepeatsThem) {
    const Ran ran = run_with("11");
    const std::string message = results().at("views").at(1).at("message");
    EXPECT_EQ(message,
              "killed by signal 11 (Segmentation fault) at 'build'; to see it again: zproof run b.gltf "
              "--renderer zproof "
              "--width 32 --height 24 --oracle none");
    for (const char* report : {"zproof-out/report.html", "zproof-out/summary.md", "zproof-out/junit.xml"})
        EXPECT_THAT(folder.read(report), HasSubstr("Segmentation fault")) << report;
    EXPECT_THAT(ran.out, HasSubstr("! 1 internal error"));
    EXPECT_THAT(ran.out, HasSubstr("Segmentation fault"));
    EXPECT_THAT(ran.err, HasSubstr("[2/3] internal_error  b: killed"));
    EXPECT_THAT(ran.err, HasSubstr("[3/3] proven      c / frame-all"));
}

TEST_F(Accidents, ThatAreWantOfMemoryMakeTheSceneUnreadable) {
    const Ran ran = run_with("bad_alloc");
    EXPECT_EQ(ran.exit_code, 3) << ran.err;
    EXPECT_EQ(results().at("views").at(1).at("outcome"), "unreadable");
    EXPECT_THAT(results().at("views").at(1).at("message").get<std::string>(), HasSubstr("out of memory"));
    EXPECT_EQ(results().at("views").at(2).at("outcome"), "proven");
}

TEST_F(Accidents, LeaveNoEvidenceThatIsUnfinished) {
    run_with("11", {"run", "a.gltf", "b.gltf", "--evidence", "all"});
    EXPECT_EQ(results().at("views").at(0).at("folder"), "scenes/a-frame-all");
    Words folders;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "zproof-out/scenes"))
        folders.push_back(entry.path().filename());
    EXPECT_EQ(folders, Words{"a-frame-all"});
}

TEST_F(Accidents, OfAllScenesStillLeaveAReport) {
    const Ran ran = run_with("11", {"run", "b.gltf"});
    EXPECT_EQ(ran.exit_code, 70) << ran.err;
    EXPECT_EQ(results().at("views").size(), 1u);
    EXPECT_EQ(results().at("run").at("renderers").size(), 2u);
}

TEST_F(Accidents, OfAnImageReaderLoseOneView) {
    folder.write("frame.exr", "\x76\x2F\x31\x01");
    for (const int number : {SIGFPE, SIGSEGV, SIGABRT}) {
        const Ran ran = run(folder,
                            {"run", "a.gltf", "--renderer", "cp frame.exr {out}", "--width", "32", "--height",
                             "24", "--oracle", "none"},
                            {"ZPROOF_IMAGE_IO=" ZPROOF_ACCIDENTS, "ACCIDENT=" + std::to_string(number)});
        EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
        EXPECT_EQ(results().at("views").at(0).at("outcome"), "unreadable");
        EXPECT_THAT(results().at("views").at(0).at("message").get<std::string>(),
                    HasSubstr(strsignal(number)));
    }
}

TEST_F(Accidents, OfTheReaderOfAStoredFrameAreOneLine) {
    folder.write("frame.exr", "\x76\x2F\x31\x01");
    const Ran ran =
        run(folder, {"compare", "frame.exr", "a.gltf"}, {"ZPROOF_IMAGE_IO=" ZPROOF_ACCIDENTS, "ACCIDENT=8"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_EQ(ran.err,
              "zproof: cannot judge: frame.exr: cannot be read: its reader crashed (signal 8, Floating point "
              "exception)\n");
}

TEST_F(Accidents, OfAReaderOfScenesLeaveAPlan) {
    ASSERT_EQ(run(folder, {"filters", "scenes", "worked", "-o", "textured"}).exit_code, 0);
    const auto planned_views = [&](const Words& environment) {
        const Ran ran =
            run(folder, {"plan", "a.gltf", "textured", "--of", "2", "--config", "none"}, environment);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        Words counts;
        const json plan = json::parse(folder.read("plan.json"));
        for (const json& scene : plan.at("runs").at(0).at("scenes"))
            counts.push_back(std::to_string(scene.at("views").size()));
        return counts;
    };
    EXPECT_EQ(planned_views({}), (Words{"1", "13"}));
    EXPECT_EQ(planned_views({"ZPROOF_IMAGE_IO=" ZPROOF_ACCIDENTS, "ACCIDENT=11"}), (Words{"1", "0"}));
}

}  // namespace
}  // namespace zproof::test
