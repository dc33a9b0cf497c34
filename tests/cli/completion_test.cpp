// The shells themselves, asked to complete.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "oracle/subprocess.h"
#include "program/command_line/outline.h"
#include "program/completion/scripts.h"
#include "tests/cli/outline_of_zproof.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsSupersetOf;
using testing::Not;

/// A folder with every script in it, and some files to complete.
class Shells : public testing::Test {
  protected:
    Shells() {
        folder.write("z.bash", bash_completion(root));
        folder.write("z.zsh", zsh_completion(root));
        folder.write("z.fish", fish_completion(root));
        folder.write("model.glb", "");
        folder.write("models/a.glb", "");
    }

    Words output_of(const Words& command) const {
        const oracle::Outcome outcome = oracle::run({.arguments = command, .folder = folder.path()});
        EXPECT_TRUE(outcome.succeeded()) << outcome.error_output;
        EXPECT_EQ(outcome.error_output, "");
        std::istringstream in{outcome.output};
        Words lines;
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        return lines;
    }

    /// What bash offers for the last of these words, "=" being a word as it is for readline.
    Words bash(Words typed) const {
        const std::string script =
            "source ./z.bash; COMP_WORDS=(zproof \"$@\"); COMP_CWORD=$#; _zproof; "
            "for reply in \"${COMPREPLY[@]}\"; do echo \"$reply\"; done";
        typed.insert(typed.begin(), {"bash", "--norc", "-c", script, "bash"});
        return output_of(typed);
    }

    /// What fish offers at the end of this line, without its descriptions.
    Words fish(const std::string& line) const {
        Words offers =
            output_of({"fish", "--no-config", "-c", "source ./z.fish; complete -C $argv[1]", line});
        for (std::string& offer : offers) offer = offer.substr(0, offer.find('\t'));
        return offers;
    }

    const OutlineCommand root = outline_of_zproof();
    Folder folder;
};

TEST_F(Shells, AcceptTheScripts) {
    for (const char* shell : {"bash", "zsh", "fish"})
        EXPECT_EQ(output_of({shell, "-n", std::string{"z."} + shell}), Words{}) << shell;
}

TEST_F(Shells, BashOffersCommands) {
    EXPECT_THAT(bash({"r"}), ElementsAre("run", "render", "report"));
    EXPECT_THAT(bash({"filters", "c"}), ElementsAre("check", "crow"));
    EXPECT_THAT(bash({"scenes", ""}), ElementsAre("generate", "random"));
    EXPECT_THAT(bash({"frobnicate", ""}), ElementsAre());
}

TEST_F(Shells, BashOffersWordsForOptions) {
    EXPECT_THAT(bash({"run", "--color", ""}), ElementsAre("always", "auto", "never"));
    EXPECT_THAT(bash({"run", "--color", "=", "a"}), ElementsAre("always", "auto"));
    EXPECT_THAT(bash({"run", "--color", "="}), ElementsAre("always", "auto", "never"));
    EXPECT_THAT(bash({"run", "room", "--renderer", "o"}), ElementsAre("opengl"));
    EXPECT_THAT(bash({"run", "--oracle", "povray,op"}), ElementsAre("povray,opengl"));
    EXPECT_THAT(bash({"filters", "run", "--methods", "ewa-t"}), ElementsAre("ewa-true"));
    EXPECT_THAT(bash({"filters", "table", "x", "--region", "sil"}), ElementsAre("silhouette"));
    EXPECT_THAT(bash({"run", "--width", ""}), ElementsAre());
    EXPECT_THAT(bash({"run", "-o", "mo"}), ElementsAre("models"));
}

TEST_F(Shells, BashOffersNamesAndFilesInTheirPlaces) {
    EXPECT_THAT(bash({"run", "mi"}), ElementsAre("million_triangles"));
    EXPECT_THAT(bash({"run", "room", "--width", "64", "mo"}),
                testing::UnorderedElementsAre("model.glb", "models"));
    EXPECT_THAT(bash({"explain", "ro"}), ElementsAre("room"));
    EXPECT_THAT(bash({"explain", "room", "ro"}), ElementsAre()) << "a column, not a scene";
    EXPECT_THAT(bash({"compare", "ro"}), Not(Contains("room"))) << "a frame, not a scene";
    EXPECT_THAT(bash({"compare", "frame.exr", "ro"}), ElementsAre("room"));
    EXPECT_THAT(bash({"measure", "e"}), ElementsAre("embree"));
    EXPECT_THAT(bash({"fit", "mi"}), ElementsAre("million_triangles"));
    EXPECT_THAT(bash({"filters", "check", "near"}), Contains("nearest"));
    EXPECT_THAT(bash({"filters", "check", "nearest", "checker_p"}), ElementsAre("checker_plane"));
    EXPECT_THAT(bash({"completion", ""}), ElementsAre("bash", "fish", "zsh"));
}

TEST_F(Shells, FishOffersTheSame) {
    EXPECT_THAT(fish("zproof r"), ElementsAre("render", "report", "run"));
    EXPECT_THAT(fish("zproof filters c"), ElementsAre("check", "crow"));
    EXPECT_THAT(fish("zproof run --color "), ElementsAre("always", "auto", "never"));
    EXPECT_THAT(fish("zproof run --oracle povray,op"), ElementsAre("povray,opengl"));
    EXPECT_THAT(fish("zproof run mil"), ElementsAre("million_triangles"));
    EXPECT_THAT(fish("zproof filters check ewa-t"), Contains("ewa-true"));
    EXPECT_THAT(fish("zproof run mod"), testing::UnorderedElementsAre("model.glb", "models/"));
}

TEST_F(Shells, OfferEveryOptionOfEveryCommand) {
    for (const OutlineCommand& command : leaves_of(root)) {
        Words names;
        for (const OutlineOption& option : command.options)
            for (const std::string& name : option.names)
                if (name.starts_with("--")) names.push_back(name);
        Words typed;
        std::istringstream in{command.path};
        for (std::string word; in >> word;) typed.push_back(word);
        typed.push_back("--");
        EXPECT_THAT(bash(typed), testing::UnorderedElementsAreArray(names)) << command.path;
        EXPECT_THAT(fish("zproof " + command.path + " --"), testing::UnorderedElementsAreArray(names))
            << command.path;
    }
}

TEST_F(Shells, ZshKnowsAFunctionForEveryCommand) {
    const Words functions = output_of({"zsh", "-f", "-c",
                                       "autoload -Uz compinit; compinit -D -u; source ./z.zsh; print "
                                       "$_comps[zproof]; print -l ${(k)functions}"});
    EXPECT_EQ(functions.at(0), "_zproof");
    EXPECT_THAT(functions, IsSupersetOf({"_zproof_run", "_zproof_filters_check", "_zproof_contract_check"}));
}

}  // namespace
}  // namespace zproof::test
