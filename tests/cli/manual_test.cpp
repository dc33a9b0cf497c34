// The manual page and the help say what the command line knows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "cli/command_line/tree.h"
#include "oracle/subprocess.h"
#include "program/command_line/help.h"
#include "program/command_line/outline.h"
#include "program/manual/page.h"
#include "tests/cli/outline_of_zproof.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using testing::HasSubstr;

TEST(ManualPage, IsReadWithoutAWarning) {
    const Folder folder;
    folder.write("zproof.1", manual_page(outline_of_zproof()));
    for (const char* reader : {"man --warnings -E UTF-8 -l -Tutf8 -Z ./zproof.1 >/dev/null",
                               "groff -man -ww -Tutf8 zproof.1 >/dev/null", "lexgrog zproof.1 >/dev/null"}) {
        const oracle::Outcome outcome =
            oracle::run({.arguments = oracle::shell_line(reader), .folder = folder.path()});
        EXPECT_TRUE(outcome.succeeded()) << reader;
        EXPECT_EQ(outcome.error_output, "") << reader;
    }
}

TEST(ManualPage, SaysAllThatTheCommandLineKnows) {
    const Folder folder;
    folder.write("zproof.1", manual_page(outline_of_zproof()));
    const std::string page =
        oracle::run({.arguments = oracle::shell_line("groff -man -Tascii -rLL=200n -P-c -P-u -P-b zproof.1"),
                     .folder = folder.path(),
                     .kept_bytes = 1 << 20})
            .output;
    for (const OutlineCommand& command : leaves_of(outline_of_zproof())) {
        EXPECT_THAT(page, HasSubstr("zproof " + command.path)) << command.path;
        for (const OutlineOption& option : command.options) EXPECT_THAT(page, HasSubstr(option.names.back()));
    }
    for (const Example& example : examples()) EXPECT_THAT(page, HasSubstr(std::string{example.line}));
}

/// The command, and those below it: `zproof waive` has a help of its own.
std::vector<OutlineCommand> all_of(const OutlineCommand& root) {
    std::vector<OutlineCommand> all{root};
    for (const OutlineCommand& command : root.commands)
        std::ranges::move(all_of(command), std::back_inserter(all));
    return all;
}

TEST(Help, OfEveryCommandBeginsWithExamples) {
    const Folder folder;
    for (const OutlineCommand& command : all_of(outline_of_zproof())) {
        std::istringstream in{command.path};
        Words words;
        for (std::string word; in >> word;) words.push_back(word);
        words.push_back("--help");
        const std::string help = run(folder, words).out;
        const std::size_t example =
            help.find("\n  zproof" + (command.path.empty() ? "" : " " + command.path));
        EXPECT_LT(example, help.find("Usage:"))
            << command.path << " has no example (command_line/examples.cpp)";
    }
}

TEST(Help, HasExamplesOfKnownCommandsOnly) {
    std::set<std::string> paths;
    for (const OutlineCommand& command : all_of(outline_of_zproof())) paths.insert(command.path);
    for (const Example& example : examples())
        EXPECT_EQ(paths.count(std::string{example.command}), 1u) << example.line;
}

TEST(Help, EveryOptionAndPositionalIsDescribed) {
    for (const OutlineCommand& command : leaves_of(outline_of_zproof())) {
        for (const OutlineOption& option : command.options)
            EXPECT_FALSE(option.description.empty()) << command.path << " " << option.names.back();
        for (const OutlineOption& option : command.positionals)
            EXPECT_FALSE(option.description.empty()) << command.path << " " << option.names.back();
    }
}

}  // namespace
}  // namespace zproof::test
