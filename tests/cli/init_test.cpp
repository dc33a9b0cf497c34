/// `zproof init`: what it writes is proven as it stands, in every language.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

class Init : public testing::TestWithParam<const char*> {};

/// The line that it prints is what a user types next. Then the far plane is at infinity, and z runs either
/// way.
TEST_P(Init, LeavesARendererThatIsProven) {
    const Folder folder;
    const Ran begun = run(folder, {"init", GetParam(), "-o", "a folder"});
    ASSERT_EQ(begun.exit_code, 0) << begun.err;
    const std::string next = begun.out.substr(begun.out.find("next: ") + 6);
    const std::string program = std::filesystem::path{ZPROOF_PROGRAM}.parent_path().string();
    const std::string line = "cd '" + folder.path().string() + "' && PATH=" + program +
                             ":$PATH && exec >out.txt 2>&1 && " + next.substr(0, next.find('\n')) +
                             " && zproof run far_at_infinity --width 48 --height 27 --oracle none";
    EXPECT_EQ(std::system(line.c_str()), 0) << folder.read("out.txt");
    EXPECT_THAT(folder.read("out.txt"), ContainsRegex("proven: 2 views(.*\n)+.*proven: 2 views"));
    EXPECT_THAT(folder.read("a folder/.github/workflows/zproof.yml"), HasSubstr("uses: OWNER/zproof@v"));
}

INSTANTIATE_TEST_SUITE_P(Languages, Init, testing::Values("python", "c++", "opengl"),
                         [](const auto& language) { return "Number" + std::to_string(language.index); });

TEST(InitTwice, LeavesWhatIsThereAndReplacesNothing) {
    const Folder folder;
    EXPECT_EQ(run(folder, {"init"}).exit_code, 0);
    EXPECT_EQ(run(folder, {"init"}).exit_code, 0) << "the same files are there";
    const Ran onto_a_file = run(folder, {"init", "-o", "zbuffer.py"});
    EXPECT_EQ(onto_a_file.exit_code, 2);
    EXPECT_THAT(onto_a_file.err, HasSubstr("zbuffer.py: is no folder"));
    folder.write("zproof.toml", "renderer = \"mine\"\n");
    std::filesystem::remove(folder.path() / "zbuffer.py");
    const Ran again = run(folder, {"init"});
    EXPECT_EQ(again.exit_code, 2);
    EXPECT_THAT(again.err, HasSubstr("zproof.toml: is there already"));
    EXPECT_EQ(folder.read("zproof.toml"), "renderer = \"mine\"\n");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "zbuffer.py")) << "nothing is half-written";
}

}  // namespace
}  // namespace zproof::test
