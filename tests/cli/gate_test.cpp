// The gate on the real program: waivers, reports for CI servers, and what is made again from results.json.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;

/// Judged by a promise of far finer corners than the rasterizer snaps to, the room has defects.
const Words defective{"run",           "room", "--width",  "96",   "--height",    "64",
                      "--oracle",      "none", "--config", "none", "--precision", "raster,subpixel_bits=16",
                      "--no-diagnosis"};
const Words today{"--now", "2026-01-20"};

Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

json results_in(const Folder& folder, const std::string& out) {
    return json::parse(folder.read(out + "/results.json"));
}

/// A waiver for every defect of the room but `invalid`, with one line of it to be chosen.
std::string waiver(const std::string& line, int most) {
    return "format = 1\n[[waiver]]\nid = \"W-1\"\nscene = \"room\"\n"
           "class = [\"hole\", \"outside\", \"hidden\", \"wrong_depth\"]\nallow_all = true\n"
           "count = { min = 1, max = " +
           std::to_string(most) +
           " }\nreason = \"a promise that nobody keeps\"\nlink = \"https://example.org/1\"\n"
           "created = 2026-01-10\n" +
           line + "\n";
}

class Gate : public testing::Test {
  protected:
    Ran judged(const Words& more) { return run(folder, with(defective, more)); }
    int most = 100'000;
    Folder folder;
};

TEST_F(Gate, FailsWithoutAWaiverAndPassesWithOneThatShowsThePixels) {
    EXPECT_EQ(judged({"-o", "a"}).exit_code, 1);
    folder.write("w.toml", waiver("expires = 2026-04-10", most));
    const Ran ran = judged(with(today, {"--waivers", "w.toml", "-o", "b", "--report", "html,junit,md,csv"}));
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    const json before = results_in(folder, "a").at("views")[0],
               after = results_in(folder, "b").at("views")[0];
    EXPECT_EQ(after.at("counts"), before.at("counts"));
    EXPECT_GT(before.at("defects"), 0);
    EXPECT_EQ(after.at("defects"), before.at("defects"));
    int waived = 0;
    for (const auto& [name, count] : after.at("waived").items()) waived += count.get<int>();
    EXPECT_EQ(waived, after.at("defects").get<int>());
    EXPECT_EQ(after.at("worst")[0].at("waiver"), "W-1");
    EXPECT_NE(ran.out.find("waived"), std::string::npos) << ran.out;
    EXPECT_NE(folder.read("b/junit.xml").find("let pass by waiver W-1"), std::string::npos);
    EXPECT_EQ(folder.read("b/junit.xml").find("<failure"), std::string::npos);
    EXPECT_NE(folder.read("b/summary.md").find("| W-1 | in\\_use |"), std::string::npos);
    EXPECT_NE(folder.read("b/results.csv").find("scene,view,"), std::string::npos);
}

TEST_F(Gate, FailsAgainOnTheDayAfterTheLast) {
    folder.write("w.toml", waiver("expires = 2026-04-10", most));
    EXPECT_EQ(judged({"--waivers", "w.toml", "--now", "2026-04-10"}).exit_code, 0);
    const Ran late = judged({"--waivers", "w.toml", "--now", "2026-04-11"});
    EXPECT_EQ(late.exit_code, 1);
    EXPECT_NE(late.err.find("error: w.toml:2: waiver W-1 expired on 2026-04-10"), std::string::npos)
        << late.err;
}

TEST_F(Gate, FailsWhereThereAreMoreDefectsThanTheWaiverAllows) {
    folder.write("w.toml", waiver("expires = 2026-04-10", 1));
    const Ran ran = judged(with(today, {"--waivers", "w.toml"}));
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.err.find("allows 1 pixel per view"), std::string::npos) << ran.err;
}

TEST_F(Gate, WarnsOfAWaiverWithoutUseAndFailsItIfStrict) {
    folder.write("w.toml", waiver("expires = 2026-04-10", most));
    const Words good{"run",      "room", "--width",  "96",   "--height",  "64",
                     "--oracle", "none", "--config", "none", "--waivers", "w.toml"};
    const Ran lenient = run(folder, with(good, today));
    EXPECT_EQ(lenient.exit_code, 0) << lenient.err;
    EXPECT_NE(lenient.err.find("warning: w.toml:2: waiver W-1 lets nothing pass"), std::string::npos)
        << lenient.err;
    EXPECT_EQ(run(folder, with(with(good, today), {"--strict"})).exit_code, 1);
}

TEST_F(Gate, IgnoresAWaiverOfAnotherScene) {
    folder.write("w.toml",
                 waiver("expires = 2026-04-10\nscene_sha256 = \"" + std::string(64, '0') + "\"", most));
    EXPECT_EQ(judged(with(today, {"--waivers", "w.toml"})).exit_code, 1);
    ASSERT_EQ(judged({"-o", "a"}).exit_code, 1);
    const std::string hash = results_in(folder, "a").at("views")[0].at("scene_sha256");
    folder.write("w.toml", waiver("expires = 2026-04-10\nscene_sha256 = \"" + hash + "\"", most));
    EXPECT_EQ(judged(with(today, {"--waivers", "w.toml"})).exit_code, 0);
}

TEST_F(Gate, DoesNotStartOnAMalformedWaiverOrSettingsFile) {
    folder.write("w.toml", waiver("expires = 2026-13-10", most));
    const Ran ran = judged(with(today, {"--waivers", "w.toml"}));
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("w.toml:11:"), std::string::npos) << ran.err;
    EXPECT_EQ(judged(with(today, {"--waivers", "absent.toml"})).exit_code, 3);
    folder.write("zproof.toml", "widht = 3\n");
    EXPECT_EQ(run(folder, {"run", "room"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"list"}).exit_code, 0);
}

TEST_F(Gate, TakesAWaiverForThePixelThatWasLookedAt) {
    ASSERT_EQ(judged({"-o", "a"}).exit_code, 1);
    const json worst = results_in(folder, "a").at("views")[0].at("worst")[0];
    const std::string pixel =
        std::to_string(worst.at("x").get<int>()) + "," + std::to_string(worst.at("y").get<int>());
    const Words add{"waive",   "add",  "--waivers", "w.toml", "--from",   "a",
                    "--scene", "room", "--view",    "door",   "--config", "none"};
    const Words signed_by{"--reason", "known", "--link", "https://example.org/1", "--expires", "2026-04-10"};
    EXPECT_EQ(run(folder, with(with(add, {"--pixel", pixel}), today)).exit_code, 2);
    EXPECT_EQ(run(folder, with(with(add, {"--pixel", "0,0"}), with(signed_by, today))).exit_code, 2);
    EXPECT_EQ(folder.names(), Words{"a"});
    const Ran ran = run(folder, with(with(add, {"--pixel", pixel}), with(signed_by, today)));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    judged(with(today, {"--waivers", "w.toml", "-o", "b"}));
    const json use = results_in(folder, "b").at("views")[0].at("waivers")[0];
    EXPECT_EQ(use.at("effect"), "holds");
    EXPECT_GE(use.at("waived"), 1);
    EXPECT_EQ(
        run(folder, with({"waive", "list", "--waivers", "w.toml", "--config", "none"}, today)).exit_code, 0);
    EXPECT_EQ(
        run(folder, {"waive", "check", "--waivers", "w.toml", "--now", "2026-05-01", "--config", "none"})
            .exit_code,
        1);
    EXPECT_EQ(
        run(folder, {"waive", "prune", "--waivers", "w.toml", "--now", "2026-05-01", "--config", "none"})
            .exit_code,
        0);
    EXPECT_EQ(folder.read("w.toml").find("[[waiver]]"), std::string::npos);
}

TEST_F(Gate, TellsGitHubWhatFailedAndSummarizesTheStep) {
    folder.write("summary.md", "before\n");
    const std::string file = "GITHUB_STEP_SUMMARY=" + (folder.path() / "summary.md").string();
    const Ran ran = run(folder, with(defective, {"-q", "--report", "github"}), {file});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_EQ(ran.out.find("::error title=zproof%3A room/"), 0u) << ran.out;
    EXPECT_EQ(folder.read("summary.md").find("before\n## zproof: "), 0u);
    EXPECT_NE(folder.names(), Words{});
}

TEST_F(Gate, MakesReportsAgainFromResults) {
    ASSERT_EQ(judged({"-o", "a", "--report", "html,junit,csv,md"}).exit_code, 1);
    for (const auto& [file, name] :
         std::vector<std::pair<std::string, std::string>>{{"a/report.html", "again.html"},
                                                          {"a/junit.xml", "again.xml"},
                                                          {"a/results.csv", "again.csv"},
                                                          {"a/summary.md", "again.md"},
                                                          {"a/results.json", "again.json"}}) {
        EXPECT_EQ(run(folder, {"report", "a", "-o", "a/" + name}).exit_code, 0);
        EXPECT_EQ(folder.read("a/" + name), folder.read(file)) << name;
    }
    EXPECT_EQ(run(folder, {"report", "a", "-o", "elsewhere.html"}).exit_code, 0);
    EXPECT_NE(folder.read("elsewhere.html").find("href=\"a/scenes/room-"), std::string::npos);
    EXPECT_NE(run(folder, {"report", "a/results.json", "--format", "github", "-o", "-"}).out.find("::error"),
              std::string::npos);
    EXPECT_EQ(run(folder, {"report", "a", "-o", "a.docx"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"report", "nowhere"}).exit_code, 3);
}

TEST_F(Gate, GivesEachViewTheCommandOfItsRunWhereAReportIsOfMany) {
    ASSERT_EQ(judged({"-o", "a"}).exit_code, 1);
    ASSERT_EQ(judged({"-o", "b"}).exit_code, 1);
    ASSERT_EQ(run(folder, {"report", "a", "b", "-o", "both.json"}).exit_code, 0);
    const json both = json::parse(folder.read("both.json"));
    const auto command_of = [&](const std::string& one) { return results_in(folder, one)["run"]["command"]; };
    EXPECT_EQ(both["run"]["command"], "");
    EXPECT_EQ(both["views"].front()["command"], command_of("a"));
    EXPECT_EQ(both["views"].back()["command"], command_of("b"));
}

TEST_F(Gate, SaysWhatBecameWorse) {
    ASSERT_EQ(judged({"-o", "bad"}).exit_code, 1);
    const Words good{"run",      "room", "--width",  "96",   "--height", "64",
                     "--oracle", "none", "--config", "none", "-o",       "good"};
    ASSERT_EQ(run(folder, good).exit_code, 0);
    EXPECT_EQ(run(folder, {"diff-results", "good", "good"}).exit_code, 0);
    EXPECT_EQ(run(folder, {"diff-results", "bad", "good"}).exit_code, 0);
    const Ran worse = run(folder, {"diff-results", "good", "bad", "--json"});
    EXPECT_EQ(worse.exit_code, 1);
    const json changes = json::parse(worse.out);
    EXPECT_EQ(changes.at("worse"), true);
    EXPECT_EQ(changes.at("views")[0].at("new_defects").size(),
              results_in(folder, "bad").at("views")[0].at("defects").get<std::size_t>());
    EXPECT_EQ(run(folder, {"diff-results", "good", "absent"}).exit_code, 3);
    const Words larger{"run",      "room", "--width",  "98",   "--height", "64",
                       "--oracle", "none", "--config", "none", "-o",       "larger"};
    ASSERT_EQ(run(folder, larger).exit_code, 0);
    const Ran refused = run(folder, {"diff-results", "good", "larger"});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.err.find("was judged at 96 x 64 and then at 98 x 64"), std::string::npos)
        << refused.err;
}

TEST_F(Gate, HasADoctorWhoKnowsWhereEverySettingComesFrom) {
    folder.write("zproof.toml", "width = 640\nheight = 480\n[profiles.ci]\nwidth = 320\n");
    const Ran ran = run(folder, {"doctor", "--profile", "ci"}, {"ZPROOF_THREADS=2"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    const auto says = [&](const std::string& name, const std::string& value, const std::string& origin) {
        const std::size_t place = ran.out.find("\n  " + name + " ");
        ASSERT_NE(place, std::string::npos) << ran.out;
        const std::string line = ran.out.substr(place + 1, ran.out.find('\n', place + 1) - place - 1);
        EXPECT_NE(line.find(" " + value + " "), std::string::npos) << line;
        EXPECT_TRUE(line.ends_with(origin)) << line;
    };
    says("width", "320", "zproof.toml:4:9");
    says("height", "480", "zproof.toml:2:10");
    says("threads", "2", "ZPROOF_THREADS");
    says("report", "html,json,junit", "default");
    says("embree", "Embree", "");
    folder.write("zproof.toml", "require = \"povray\"\n");
    EXPECT_EQ(run(folder, {"doctor"}, {"PATH=/nowhere"}).exit_code, 3);
}

TEST_F(Gate, HasADoctorWhoPromisesNoMoreThanHeSaw) {
    folder.write("zproof.toml", "renderer = \"./mine {out}\"\nwaivers = \"waivers.toml\"\n");
    const Ran without = run(folder, {"doctor"});
    EXPECT_EQ(without.exit_code, 3);
    EXPECT_TRUE(without.out.ends_with("missing: waivers: waivers.toml: no such file\n")) << without.out;
    folder.write("waivers.toml", "format = 1\n");
    const Ran with = run(folder, {"doctor"});
    EXPECT_EQ(with.exit_code, 0);
    EXPECT_NE(with.out.find("not tried: ./mine {out} "), std::string::npos) << with.out;
    EXPECT_TRUE(with.out.ends_with("everything else that these settings need is here\n")) << with.out;
}

}  // namespace
}  // namespace zproof::test
