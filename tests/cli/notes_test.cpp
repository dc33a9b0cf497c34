// What a scene's file says and its picture does not show: told by every command that reads the file.
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

const std::string triangle_and_lines = "v -1 -1 -3\nv 1 -1 -3\nv 0 1 -3\nf 1 2 3\nl 1 2\n";

class Notes : public testing::Test {
  protected:
    Notes() {
        folder.write("m/a.obj", triangle_and_lines);
        folder.write("m/b.obj", triangle_and_lines + "l 2 3\n");
    }

    std::string told(Words words) const {
        words.insert(words.end(), {"--width", "16", "--height", "12"});
        return run(folder, words).err;
    }

    Folder folder;
};

TEST_F(Notes, OfOneSceneAreToldBesideItsResult) {
    for (const Words& words :
         {Words{"render", "m/a.obj"}, {"explain", "m/a.obj", "1", "1"}, {"fit", "m/a.obj"}}) {
        EXPECT_EQ(told(words), "note: a: points, lines and curves skipped: 1\n") << words[0];
        Words quiet = words;
        quiet.push_back("-q");
        EXPECT_EQ(told(quiet), "") << words[0];
    }
}

TEST_F(Notes, AreToldByCommandsOfFilters) {
    Words words{"filters", "explain", "m/a.obj",  "--view", "frame-all",
                "--pixel", "8,6",     "--method", "nearest"};
    const std::string note = "note: a: points, lines and curves skipped: 1\n";
    EXPECT_TRUE(told(words).starts_with(note)) << told(words);
    words.push_back("-q");
    EXPECT_FALSE(told(words).starts_with(note)) << told(words);
}

TEST_F(Notes, OfSeveralScenesAreToldOncePerKind) {
    for (const char* command : {"fit", "selfcheck"}) {
        EXPECT_EQ(told({command, "m"}), "note: 2 scenes: points, lines and curves skipped\n") << command;
        EXPECT_EQ(told({command, "m", "-q"}), "") << command;
    }
}

}  // namespace
}  // namespace zproof::test
