// Names that would reorder a line, colour a terminal or are no text: shown escaped wherever the real program
// shows them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

namespace fs = std::filesystem;

/// An override of the direction, an escape that turns a terminal red, a byte that is no UTF-8.
const std::string hostile = "a\u202Eb\x1b[31mc\xB6";
const std::string shown = R"(a\u202eb\x1b[31mc\xb6)";

bool is_raw(const std::string& text) {
    return text.find("\u202E") != std::string::npos || text.find("\x1b[31m") != std::string::npos ||
           text.find("c\xB6") != std::string::npos;
}

class HostileName : public testing::Test {
  protected:
    HostileName() { folder.write(hostile + ".gltf", one_triangle()); }

    /// Runs it, and looks at what it says.
    Ran said_escaped(Words words) const {
        words.insert(words.end(), {"--width", "16", "--height", "12"});
        Ran ran = run(folder, words);
        EXPECT_FALSE(is_raw(ran.out)) << ran.out;
        EXPECT_FALSE(is_raw(ran.err)) << ran.err;
        return ran;
    }

    Folder folder;
};

TEST_F(HostileName, OfASceneIsEscapedInEveryReport) {
    const Ran ran =
        said_escaped({"run", hostile + ".gltf", "--oracle", "none", "--precision", "raster,subpixel_bits=16",
                      "--evidence", "all", "--report", "html,junit,md,github", "-o", "out"});
    EXPECT_NE(ran.out.find(shown), std::string::npos) << ran.out << ran.err;
    for (const char* report : {"report.html", "junit.xml", "summary.md"}) {
        const std::string text = folder.read(fs::path{"out"} / report);
        EXPECT_FALSE(is_raw(text)) << report;
        EXPECT_NE(text.find("u202eb"), std::string::npos) << report;
    }
}

TEST_F(HostileName, OfTheOutputFolderIsEscaped) {
    for (const char* command : {"render", "run"})
        EXPECT_EQ(said_escaped({command, hostile + ".gltf", "-o", "out" + hostile}).exit_code, 0) << command;
}

TEST_F(HostileName, DoesNotEndAStudy) {
    for (const Words& command : {Words{"fit"}, Words{"study", "projection"}}) {
        Words words = command;
        words.insert(words.end(), {hostile + ".gltf", "-o", command.front()});
        EXPECT_LE(said_escaped(words).exit_code, 1) << command.front();
        EXPECT_FALSE(is_raw(folder.read(fs::path{command.front()} / "study.html")));
    }
}

TEST_F(HostileName, OfARendererIsEscaped) {
    const std::string renderer = "./" + hostile + " {scene} {out}";
    const Ran ran = said_escaped({"run", hostile + ".gltf", "--oracle", "none", "--renderer", renderer});
    EXPECT_EQ(ran.exit_code, 3) << ran.err;
    const Ran checked = run(folder, {"contract-check", renderer});
    EXPECT_EQ(checked.exit_code, 3);
    EXPECT_FALSE(is_raw(checked.out)) << checked.out;
    EXPECT_FALSE(is_raw(checked.err)) << checked.err;
}

TEST(LongNames, LeaveAnErrorLineShort) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    const std::string path(4000, 'x'), option(10000, 'y');
    for (const Words& words :
         {Words{"run", path + ".gltf"}, Words{"render", path + ".gltf"},
          Words{"run", "one.gltf", "--" + option}, Words{"run", option},
          Words{"run", "one.gltf", "--precision", option}, Words{"run", "one.gltf", "--waivers", option},
          Words{"run", "one.gltf", "--renderer", option}, Words{"compare", option, "one.gltf"},
          Words{"report", option}}) {
        const Ran ran = run(folder, words);
        EXPECT_TRUE(ran.exit_code == 2 || ran.exit_code == 3) << ran.exit_code;
        EXPECT_FALSE(ran.err.empty());
        EXPECT_LT(ran.err.size(), 300u) << ran.err;
        EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << ran.err;
    }
}

}  // namespace
}  // namespace zproof::test
