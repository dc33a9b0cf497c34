#include <gtest/gtest.h>

#include "cli/arguments.h"
#include "program/folder_names.h"
#include "program/shell_line.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

Command parsed(std::vector<const char*> words) {
    words.insert(words.begin(), "zproof");
    return parse_command_line(int(words.size()), words.data(), [](const std::string&) { return nullptr; });
}

TEST(CommandLine, OfRunIsUnderstood) {
    const auto run = std::any_cast<RunArguments>(
        parsed({"run", "a b.glb", "suite", "-o", "x", "--width", "640", "--threads", "3", "--color", "never"})
            .arguments);
    EXPECT_EQ(run.scenes, (std::vector<std::string>{"a b.glb", "suite"}));
    EXPECT_EQ(run.report.common.out, "x");
    EXPECT_EQ(run.settings.resolution, (Resolution{640, 1080}));
    EXPECT_EQ(run.report.common.threads, 3);
    EXPECT_EQ(run.report.common.colour, ColourMode::never);
    EXPECT_EQ(run.report.common.progress, ProgressStyle::automatic);
    EXPECT_EQ(run.report.typed, "zproof run 'a b.glb' suite -o x --width 640 --threads 3 --color never");
}

TEST(CommandLine, QuietMeansVerdictAndNoProgress) {
    const auto run = std::any_cast<RunArguments>(parsed({"run", "-q"}).arguments);
    EXPECT_EQ(run.report.common.detail, Detail::verdict);
    EXPECT_EQ(progress_of(run.report.common), ProgressStyle::silent);
    EXPECT_EQ(
        progress_of(
            std::any_cast<RunArguments>(parsed({"run", "-q", "--progress", "bar"}).arguments).report.common),
        ProgressStyle::silent);
    EXPECT_THROW(parsed({"run", "-q", "--times"}), UsageError);
}

TEST(CommandLine, OfExplainIsUnderstood) {
    const auto explain = std::any_cast<ExplainArguments>(
        parsed({"explain", "s.glb", "812", "344", "--view", "main"}).arguments);
    EXPECT_EQ(explain.scene, "s.glb");
    EXPECT_EQ(explain.x, 812);
    EXPECT_EQ(explain.y, 344);
    EXPECT_EQ(explain.view, "main");
    EXPECT_THROW(parsed({"explain", "s.glb", "-1", "0"}), UsageError);
}

TEST(CommandLine, OfMeasureIsUnderstood) {
    const auto table = std::any_cast<MeasureArguments>(parsed({"measure", "zproof"}).arguments);
    EXPECT_EQ(name_of(table.renderer), "zproof");
    EXPECT_EQ(table.format, MeasurementFormat::table);
    EXPECT_EQ(std::any_cast<MeasureArguments>(parsed({"measure", "zproof", "--json"}).arguments).format,
              MeasurementFormat::json);
    EXPECT_THROW(parsed({"measure"}), UsageError);
}

TEST(CommandLine, NamesARendererAlikeWhereOneIsLookedAt) {
    const char* command = "./mine {scene} {out}";
    for (const char* option : {"", "--renderer"}) {
        const auto given = [&](const char* name, std::vector<const char*> words) {
            words.insert(words.begin(), name);
            if (*option != '\0') words.push_back(option);
            words.push_back(command);
            return parsed(words);
        };
        EXPECT_EQ(name_of(std::any_cast<MeasureArguments>(given("measure", {}).arguments).renderer), command);
        const auto fit = std::any_cast<FitArguments>(given("fit", {"room"}).arguments);
        EXPECT_EQ(name_of(fit.renderer), command);
        EXPECT_EQ(fit.scenes, std::vector<std::string>{"room"});
        const auto selfcheck = std::any_cast<SelfcheckArguments>(given("selfcheck", {}).arguments);
        EXPECT_EQ(name_of(selfcheck.renderer), command);
        EXPECT_TRUE(selfcheck.scenes.empty());
    }
    EXPECT_THROW(parsed({"fit", "embree", "--renderer", "opengl"}), UsageError);
}

TEST(CommandLine, TakesBothSidesOfAPictureInOneWord) {
    const auto run = [](std::vector<const char*> words) {
        words.insert(words.begin(), "run");
        return std::any_cast<RunArguments>(parsed(words).arguments).settings.resolution;
    };
    EXPECT_EQ(run({"--width", "640x480"}), (Resolution{640, 480}));
    EXPECT_THROW(run({"--width", "640x"}), UsageError);
    EXPECT_THROW(run({"--width", "640x0"}), UsageError);
    EXPECT_THROW(run({"--width", "640x480", "--height", "480"}), UsageError);
}

TEST(CommandLine, OfFitIsUnderstood) {
    const auto fit = std::any_cast<FitArguments>(
        parsed({"fit", "room", "--renderer", "embree", "--view", "door"}).arguments);
    EXPECT_EQ(fit.scenes, (std::vector<std::string>{"room"}));
    EXPECT_EQ(name_of(fit.renderer), "embree");
    EXPECT_EQ(fit.view, "door");
    EXPECT_EQ(
        name_of(
            std::any_cast<FitArguments>(parsed({"fit", "room", "--candidate", "a.exr"}).arguments).renderer),
        "a.exr");
}

TEST(CommandLine, NamesRenderersProgramsAndStoredFrames) {
    const auto run = std::any_cast<RunArguments>(
        parsed({"run", "--renderer", "./mine {out}", "--precision", "ray", "--time-limit", "7"}).arguments);
    EXPECT_EQ(std::get<Program>(run.renderers.candidate.who).command, "./mine {out}");
    EXPECT_EQ(run.renderers.candidate.time_limit, std::chrono::seconds{7});
    EXPECT_EQ(options_for(run.renderers.candidate), " --renderer './mine {out}' --precision ray");
    const auto compare = std::any_cast<CompareArguments>(
        parsed({"compare", "a.exr", "b.exr", "--scene", "room", "--view", "door"}).arguments);
    EXPECT_EQ(name_of(compare.renderers.candidate), "a.exr");
    EXPECT_EQ(name_of(compare.renderers.reference), "b.exr");
    EXPECT_EQ(compare.scene, "room");
    const auto against_embree =
        std::any_cast<CompareArguments>(parsed({"compare", "a.exr", "room"}).arguments);
    EXPECT_EQ(name_of(against_embree.renderers.reference), "embree");
    EXPECT_EQ(against_embree.scene, "room");
    EXPECT_THROW(parsed({"run", "--renderer", "no-such-renderer"}), UsageError);
}

TEST(CommandLine, GivesVulkanItsSettingsAndItsDevice) {
    const auto run = std::any_cast<RunArguments>(
        parsed({"run", "--renderer", "vulkan:depth_buffer=standard_z:depth_format=unorm16:ids=any",
                "--device", "llvm pipe", "--oracle", "vulkan:planes=distances:attributes=all"})
            .arguments);
    const oracle::VulkanSettings& candidate = std::get<BuiltIn>(run.renderers.candidate.who).vulkan;
    EXPECT_EQ(candidate.depth_format, DepthFormat::unorm16);
    EXPECT_EQ(candidate.depth_buffer, DepthBuffer::standard_z);
    EXPECT_EQ(candidate.device, "llvm pipe");
    EXPECT_EQ(options_for(run.renderers.candidate),
              " --renderer vulkan:depth_format=unorm16:depth_buffer=standard_z --device 'llvm pipe'");
    const oracle::VulkanSettings& oracle = std::get<BuiltIn>(run.renderers.oracles.at(0).renderer.who).vulkan;
    EXPECT_EQ(oracle, (oracle::VulkanSettings{.device = "llvm pipe",
                                              .planes = oracle::PlanesBy::distances,
                                              .attributes = oracle::Values::all}));
    EXPECT_EQ(name_of(std::any_cast<FitArguments>(
                          parsed({"fit", "vulkan:ids=vertex:attributes=all", "room"}).arguments)
                          .renderer),
              "vulkan:ids=vertex:attributes=all");
    for (const char* wrong :
         {"vulkan:", "vulkan:depth=16", "vulkan:depth_format=unorm16:", "vulkanic", "opengl:ids=any"})
        EXPECT_THROW(parsed({"run", "--renderer", wrong}), UsageError) << wrong;
    EXPECT_THROW(parsed({"run", "--device", "llvmpipe"}), UsageError) << "nobody there has devices";
}

TEST(CommandLine, CallsOraclesOnceAndNotTheCandidate) {
    const auto names = [](std::vector<const char*> words) {
        std::vector<std::string> list;
        const auto run = std::any_cast<RunArguments>(parsed(std::move(words)).arguments);
        for (const OracleChoice& oracle : run.renderers.oracles) list.push_back(name_of(oracle.renderer));
        return list;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names({"run", "--oracle", "none"}), Names{});
    EXPECT_EQ(names({"run", "--oracle", "zproof,embree", "--renderer", "zproof"}), Names{});
    EXPECT_EQ(names({"run", "--oracle", "zproof", "--require", "zproof", "--renderer", "embree"}),
              Names{"zproof"});
    EXPECT_THROW(parsed({"run", "--oracle", "delphi"}), UsageError);
    EXPECT_EQ(std::any_cast<RunArguments>(parsed({"run", "--oracle", "opengl", "room"}).arguments).scenes,
              Names{"room"});
    EXPECT_EQ(
        std::any_cast<RunArguments>(parsed({"run", "--require", "povray,opengl", "room"}).arguments).scenes,
        Names{"room"});
}

TEST(ShellQuoted, SurvivesTheShell) {
    EXPECT_EQ(shell_quoted("models/box.glb"), "models/box.glb");
    EXPECT_EQ(shell_quoted("a b"), "'a b'");
    EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_quoted("$(rm)"), "'$(rm)'");
    EXPECT_EQ(shell_quoted(""), "''");
}

TEST(FolderNames, AreSafe) {
    EXPECT_EQ(safe_name("../../etc"), "_._.._etc");
    EXPECT_EQ(safe_name("a b/\xC3\xA9"), "a_b___");
    EXPECT_EQ(safe_name(""), "_");
    EXPECT_EQ(safe_name(std::string(300, 'x')).size(), 100u);
}

TEST(FolderNames, AreNeverGivenTwice) {
    FolderNames names;
    EXPECT_EQ(names.next("room", "main"), "room-main");
    EXPECT_EQ(names.next("room", "main"), "room-main-2");
    EXPECT_EQ(names.next("Room", "main"), "Room-main-3");
    EXPECT_EQ(names.next("room", "main-2"), "room-main-2-2");
}

}  // namespace
}  // namespace zproof
