#include "frame/whole_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "frame/frame_error.h"
#include "scratch_folder.h"

namespace zproof {
namespace {

class WholeFiles : public ScratchFolder {
  protected:
    std::string contents(const std::string& name) const {
        std::ifstream in(file(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

constexpr std::array two_bytes{std::byte{'o'}, std::byte{'k'}};

TEST_F(WholeFiles, ReplacesAnOlderFileAndLeavesNothingElse) {
    std::ofstream(file("a")) << "an older and longer file";
    write_whole_file(file("a"), two_bytes);
    EXPECT_EQ(contents("a"), "ok");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFiles, PartsStandWhereTheyWerePut) {
    {
        WholeFile whole(file("a"));
        whole.append("begin");
        whole.put(8, "far");
        whole.append("ther");
        whole.put(1, "E");
        whole.append("most");
        EXPECT_FALSE(exists(file("a")));
        whole.finish();
    }
    EXPECT_EQ(contents("a"), std::string("bEgin\0\0\0farthermost", 19));
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFiles, WhatIsGivenUpLeavesNothingBehind) {
    std::ofstream(file("a")) << "older";
    { WholeFile(file("a")).append("newer"); }
    EXPECT_EQ(contents("a"), "older");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFiles, WhatAKilledProcessLeftIsRemoved) {
    std::ofstream(file("a.1234.partial")) << "half of";
    write_whole_file(file("a"), two_bytes);
    EXPECT_EQ(contents("a"), "ok");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFiles, WhatAnotherProcessWritesStays) {
    const int other = open(file("a.1234.partial").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    ASSERT_EQ(flock(other, LOCK_EX), 0);
    write_whole_file(file("a"), two_bytes);
    EXPECT_TRUE(exists(file("a.1234.partial")));
    close(other);
}

TEST_F(WholeFiles, WhatIsBeingWrittenIsLocked) {
    WholeFile whole(file("a"));
    const int other =
        open((file("a").string() + "." + std::to_string(getpid()) + ".partial").c_str(), O_WRONLY);
    ASSERT_GE(other, 0);
    EXPECT_NE(flock(other, LOCK_EX | LOCK_NB), 0);
    close(other);
}

TEST_F(WholeFiles, FilesOfOtherNamesStay) {
    for (const char* name : {"ab.1.partial", "a.b.partial", "a.1.partial.x", "a.partial", "b.1.partial"})
        std::ofstream(file(name)) << "mine";
    write_whole_file(file("a"), two_bytes);
    EXPECT_EQ(file_count(), 6u);
}

TEST_F(WholeFiles, MissingFolderIsReported) {
    EXPECT_THAT(complaint<FrameError>([&] { write_whole_file(file("none/a"), two_bytes); }),
                testing::HasSubstr("none/a: cannot be written: No such file or directory"));
}

TEST_F(WholeFiles, FailedRenameLeavesNothingBehind) {
    std::filesystem::create_directories(file("taken/by"));
    EXPECT_THAT(complaint<FrameError>([&] { write_whole_file(file("taken"), two_bytes); }),
                testing::HasSubstr("taken: cannot be written: Is a directory"));
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFiles, ALinkAndPermissionsOutlastTheReplacement) {
    std::ofstream(file("a")) << "older";
    std::filesystem::permissions(file("a"), std::filesystem::perms(0640));
    std::filesystem::create_symlink("a", file("link"));
    write_whole_file(file("link"), two_bytes);
    EXPECT_TRUE(std::filesystem::is_symlink(file("link")));
    EXPECT_EQ(contents("a"), "ok");
    EXPECT_EQ(std::filesystem::status(file("a")).permissions(), std::filesystem::perms(0640));
}

TEST_F(WholeFiles, ADeviceIsNeverReplaced) {
    std::filesystem::create_symlink("/dev/null", file("a"));
    EXPECT_THAT(complaint<FrameError>([&] { write_whole_file(file("a"), two_bytes); }),
                testing::HasSubstr("a: cannot be written: is a device or a pipe"));
    EXPECT_TRUE(std::filesystem::is_symlink(file("a")));
}

TEST_F(WholeFiles, FullDeviceIsReported) {
    // Linux's /dev/full refuses every write; reached by a link under the temporary's name.
    const std::string temporary = file("a").string() + "." + std::to_string(getpid()) + ".partial";
    std::filesystem::create_symlink("/dev/full", temporary);
    EXPECT_THAT(complaint<FrameError>([&] { write_whole_file(file("a"), two_bytes); }),
                testing::HasSubstr("No space left"));
    EXPECT_EQ(file_count(), 0u);
}

}  // namespace
}  // namespace zproof
