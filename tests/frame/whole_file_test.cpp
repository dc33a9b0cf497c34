#include "frame/whole_file.h"

#include <gmock/gmock.h>

#include <array>
#include <fstream>

#include "frame/frame_error.h"
#include "scratch_folder.h"

namespace zproof {
namespace {

class WholeFile : public ScratchFolder {
  protected:
    std::string contents(const std::string& name) const {
        std::ifstream in(file(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

constexpr std::array two_bytes{std::byte{'o'}, std::byte{'k'}};

TEST_F(WholeFile, ReplacesAnOlderFileAndLeavesNothingElse) {
    std::ofstream(file("a")) << "an older and longer file";
    write_whole_file(file("a"), two_bytes);
    EXPECT_EQ(contents("a"), "ok");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFile, FailedRenameLeavesNothingBehind) {
    std::filesystem::create_directories(file("taken/by"));
    EXPECT_THAT(complaint<FrameError>([&] { write_whole_file(file("taken"), two_bytes); }),
                testing::HasSubstr("taken: cannot be written: Is a directory"));
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFile, FullDeviceIsReported) {
    // Linux's /dev/full refuses every write; reached by a link under the temporary's name.
    const std::string temporary = file("a").string() + "." + std::to_string(getpid()) + ".partial";
    std::filesystem::create_symlink("/dev/full", temporary);
    EXPECT_THAT(complaint<FrameError>([&] { write_whole_file(file("a"), two_bytes); }),
                testing::HasSubstr("No space left"));
    EXPECT_EQ(file_count(), 0u);
}

}  // namespace
}  // namespace zproof
