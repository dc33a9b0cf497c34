#include <gtest/gtest.h>

#include "cli/arguments.h"
#include "cli/folder_names.h"
#include "cli/usage_error.h"

namespace zproof {
namespace {

Command parsed(std::vector<const char*> words) {
    words.insert(words.begin(), "zproof");
    return parse_command_line(int(words.size()), words.data());
}

TEST(CommandLine, OfRunIsUnderstood) {
    const auto run = std::get<RunArguments>(parsed(
        {"run", "a b.glb", "suite", "-o", "x", "--width", "640", "--threads", "3", "--color", "never"}));
    EXPECT_EQ(run.scenes, (std::vector<std::string>{"a b.glb", "suite"}));
    EXPECT_EQ(run.out, "x");
    EXPECT_EQ(run.settings.resolution, (Resolution{640, 1080}));
    EXPECT_EQ(run.settings.threads, 3);
    EXPECT_EQ(run.colour, ColourWish::never);
    EXPECT_EQ(run.progress, ProgressStyle::automatic);
    EXPECT_EQ(run.typed, "zproof run 'a b.glb' suite -o x --width 640 --threads 3 --color never");
}

TEST(CommandLine, QuietMeansVerdictAndNoProgress) {
    const auto run = std::get<RunArguments>(parsed({"run", "-q"}));
    EXPECT_EQ(run.detail, Detail::verdict);
    EXPECT_EQ(run.progress, ProgressStyle::none);
    EXPECT_THROW(parsed({"run", "-q", "--times"}), UsageError);
}

TEST(CommandLine, OfExplainIsUnderstood) {
    const auto explain =
        std::get<ExplainArguments>(parsed({"explain", "s.glb", "812", "344", "--view", "main"}));
    EXPECT_EQ(explain.scene, "s.glb");
    EXPECT_EQ(explain.x, 812);
    EXPECT_EQ(explain.y, 344);
    EXPECT_EQ(explain.view, "main");
    EXPECT_THROW(parsed({"explain", "s.glb", "-1", "0"}), UsageError);
}

TEST(CommandLine, OfMeasureIsUnderstood) {
    const auto table = std::get<MeasureArguments>(parsed({"measure", "zproof"}));
    EXPECT_EQ(table.renderer, "zproof");
    EXPECT_EQ(table.format, MeasurementFormat::table);
    EXPECT_EQ(std::get<MeasureArguments>(parsed({"measure", "zproof", "--json"})).format,
              MeasurementFormat::json);
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
