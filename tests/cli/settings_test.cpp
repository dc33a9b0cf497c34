// Flag, environment, profile, file: who wins, and what is said of mistakes.
#include <gtest/gtest.h>

#include <map>

#include "cli/arguments.h"
#include "program/settings/setting.h"
#include "program/usage_error.h"
#include "tests/cli/program.h"

namespace zproof {
namespace {

using Variables = std::map<std::string, std::string>;

/// A folder with a settings file, and a made-up environment.
struct SettingsFolder {
    test::Folder folder;
    Variables variables;

    explicit SettingsFolder(const std::string& toml, Variables set = {}) : variables(std::move(set)) {
        folder.write("zproof.toml", toml);
    }
    Environment environment() const {
        return [this](const std::string& name) {
            const auto found = variables.find(name);
            return found == variables.end() ? nullptr : found->second.c_str();
        };
    }
    std::string file() const { return (folder.path() / "zproof.toml").string(); }

    Command parsed(std::vector<std::string> words) const {
        words.insert(words.begin(), "zproof");
        words.insert(words.end(), {"--config", file()});
        std::vector<const char*> argv;
        for (const std::string& word : words) argv.push_back(word.c_str());
        return parse_command_line(int(argv.size()), argv.data(), environment());
    }
    RunArguments run(std::vector<std::string> words) const {
        words.insert(words.begin(), "run");
        return std::any_cast<RunArguments>(parsed(words).arguments);
    }
    std::string refusal(const std::vector<std::string>& words) const {
        try {
            run(words);
        } catch (const UsageError& e) {
            return e.what();
        }
        return "nothing was refused";
    }
};

constexpr const char* layered = R"(
width = 100
height = 200
threads = 3
profile = "ci"
[profiles.ci]
width = 300
[profiles.local]
width = 400
)";

TEST(Settings, OfAFlagWinOverTheEnvironmentOverTheProfileOverTheFile) {
    const SettingsFolder quiet{layered}, loud{layered, {{"ZPROOF_WIDTH", "500"}}};
    EXPECT_EQ(quiet.run({}).settings.resolution, (Resolution{300, 200}));
    EXPECT_EQ(quiet.run({"--profile", "local"}).settings.resolution, (Resolution{400, 200}));
    EXPECT_EQ(loud.run({}).settings.resolution, (Resolution{500, 200}));
    EXPECT_EQ(loud.run({"--width", "600"}).settings.resolution, (Resolution{600, 200}));
    EXPECT_EQ(quiet.run({}).report.common.threads, 3);
    const SettingsFolder by_variable{layered, {{"ZPROOF_PROFILE", "local"}}};
    EXPECT_EQ(by_variable.run({}).settings.resolution.width, 400);
    EXPECT_EQ(by_variable.run({"--profile", "ci"}).settings.resolution.width, 300);
}

TEST(Settings, AreUnderstoodOfEveryKind) {
    const SettingsFolder place{R"(
scenes = ["room", "tie"]
renderer = "embree"
oracle = ["none"]
report = "md,csv"
evidence = "defects"
strict = true
now = 2026-04-10
shard = "hash:2/3"
color = "never"
out = "reports"
)"};
    const RunArguments run = place.run({});
    EXPECT_EQ(run.scenes, (std::vector<std::string>{"room", "tie"}));
    EXPECT_EQ(name_of(run.renderers.candidate), "embree");
    EXPECT_TRUE(run.renderers.oracles.empty());
    EXPECT_EQ(run.report.formats, (std::vector{ReportFormat::md, ReportFormat::csv}));
    EXPECT_EQ(run.report.evidence, Evidence::defects);
    EXPECT_EQ(run.report.gate.strictness, Strictness::strict);
    EXPECT_EQ(in_words(*run.report.gate.today), "2026-04-10");
    EXPECT_EQ(run.shard.number, 2);
    EXPECT_EQ(run.report.common.colour, ColourMode::never);
    EXPECT_EQ(run.report.common.out, place.folder.path() / "reports");
    EXPECT_EQ(place.run({"other"}).scenes, std::vector<std::string>{"other"});
}

TEST(Settings, OfTheEnvironmentAreUnderstood) {
    const SettingsFolder place{"",
                               {{"ZPROOF_SCENES", "room,tie"}, {"ZPROOF_STRICT", "1"}, {"ZPROOF_OUT", "x"}}};
    EXPECT_EQ(place.run({}).scenes, (std::vector<std::string>{"room", "tie"}));
    EXPECT_EQ(place.run({}).report.gate.strictness, Strictness::strict);
    EXPECT_EQ(place.run({}).report.common.out, "x");
    EXPECT_EQ(SettingsFolder("strict = true", {{"ZPROOF_STRICT", "false"}}).run({}).report.gate.strictness,
              Strictness::lenient);
    EXPECT_EQ(SettingsFolder("", {{"ZPROOF_OUT", ""}}).run({}).report.common.out, "zproof-out");
}

TEST(Settings, AreRefusedWithWhereTheyStand) {
    const auto is_about = [](const std::string& said, const std::string& place, const std::string& what) {
        EXPECT_NE(said.find(place), std::string::npos) << said;
        EXPECT_NE(said.find(what), std::string::npos) << said;
    };
    is_about(SettingsFolder("\nwidht = 3").refusal({}), "zproof.toml:2:", "did you mean 'width'?");
    is_about(SettingsFolder("width = \"3\"").refusal({}), "zproof.toml:1:", "whole number");
    const std::string right = "height: expected a whole number from 1 to 32768, found ",
                      mended = "; write such as: height = 1080";
    is_about(SettingsFolder("\nheight = 0").refusal({}), "zproof.toml:2:10: ", right + "0" + mended);
    is_about(SettingsFolder("height = 32769").refusal({}), "zproof.toml:1:10: ", right + "32769" + mended);
    is_about(SettingsFolder("height = 1.5").refusal({}),
             "zproof.toml:1:10: ", right + "a decimal number" + mended);
    is_about(SettingsFolder("[profiles.x]\nheight = -1").refusal({}),
             "zproof.toml:2:10: ", right + "-1" + mended);
    is_about(SettingsFolder("", {{"ZPROOF_HEIGHT", "40000"}}).refusal({}),
             "ZPROOF_HEIGHT: expected a whole number from 1 to 32768",
             "'40000'; write such as: ZPROOF_HEIGHT=1080");
    is_about(SettingsFolder("strict = 1").refusal({}), "zproof.toml:1:", "true or false");
    is_about(SettingsFolder("color = \"mauve\"").refusal({}), "zproof.toml:1:", "mauve");
    is_about(SettingsFolder("report = [\"hmtl\"]").refusal({}), "zproof.toml:1:", "did you mean 'html'?");
    is_about(SettingsFolder("[profiles.x]\nwidht = 3").refusal({}),
             "zproof.toml:2:", "did you mean 'width'?");
    is_about(SettingsFolder("= 3").refusal({}), "zproof.toml:1:", "");
    is_about(SettingsFolder("[profiles.ci]\n").refusal({"--profile", "cj"}), "zproof.toml",
             "did you mean 'ci'?");
    is_about(SettingsFolder("", {{"ZPROOF_WIDTH", "wide"}}).refusal({}), "ZPROOF_WIDTH", "wide");
    is_about(SettingsFolder("", {{"ZPROOF_STRICT", "maybe"}}).refusal({}), "ZPROOF_STRICT", "maybe");
}

/// What a file may say and what may be typed: one range.
TEST(Settings, ThatAreNumbersHaveTheRangesOfTheirOptions) {
    for (const Setting& setting : known_settings()) {
        if (setting.kind != Setting::Kind::number) continue;
        const auto [least, most, such_as] = setting.range;
        EXPECT_TRUE(setting.range.contains(such_as)) << setting.name;
        const auto typed = [&](std::int64_t number) {
            return SettingsFolder("").refusal({option_name(setting.name), std::to_string(number)});
        };
        for (const std::int64_t right : {least, most}) EXPECT_EQ(typed(right), "nothing was refused");
        for (const std::int64_t wrong : {least - 1, most + 1})
            EXPECT_NE(typed(wrong).find("not in range"), std::string::npos) << setting.name << typed(wrong);
    }
}

/// A report's command names the renderer; what somebody types may leave that to the settings.
TEST(Settings, ReachExplainWhereItIsNotToldWhoseFrame) {
    const SettingsFolder place{"width = 100\nrenderer = \"embree\"\nthreads = 3"};
    const auto explain = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"explain", "room", "1", "1"};
        words.insert(words.end(), more.begin(), more.end());
        return std::any_cast<ExplainArguments>(place.parsed(words).arguments);
    };
    EXPECT_EQ(explain({}).settings.resolution.width, 100);
    EXPECT_EQ(name_of(explain({}).renderers.candidate), "embree");
    const ExplainArguments told = explain({"--renderer", "zproof"});
    EXPECT_EQ(told.settings.resolution.width, 1920);
    EXPECT_EQ(name_of(told.renderers.candidate), "zproof");
    EXPECT_EQ(told.common.threads, 3);
    EXPECT_EQ(explain({"--candidate", "frame.exr"}).settings.resolution.width, 1920);
}

TEST(Settings, OfACiServerAreTheWeakest) {
    const SettingsFolder place{"", {{"CI", "true"}, {"GITHUB_ACTIONS", "true"}}};
    EXPECT_EQ(place.run({}).report.common.progress, ProgressStyle::lines);
    EXPECT_EQ(place.run({}).report.formats.back(), ReportFormat::github);
    EXPECT_EQ(place.run({"--report", "md"}).report.formats, std::vector{ReportFormat::md});
    EXPECT_EQ(place.run({"-q"}).report.common.detail, Detail::verdict);
    EXPECT_EQ(SettingsFolder("progress = \"bar\"", {{"CI", "1"}}).run({}).report.common.progress,
              ProgressStyle::bar);
    EXPECT_EQ(SettingsFolder("", {{"CI", "false"}}).run({}).report.common.progress, ProgressStyle::automatic);
}

TEST(Precedence, IsOneFold) {
    const SettingValues strong{{"a", {"1"}, "x"}}, weak{{"a", {"2"}, "y"}, {"b", {"3"}, "y"}};
    const SettingValues both = strongest({strong, {}, weak});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0].origin, "x");
    EXPECT_EQ(both[1].words, std::vector<std::string>{"3"});
}

}  // namespace
}  // namespace zproof
