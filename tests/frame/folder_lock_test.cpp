#include "frame/folder_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <vector>

#include "frame/frame_error.h"
#include "frame/whole_file.h"
#include "scratch_folder.h"

namespace zproof {
namespace {

class FolderLocks : public ScratchFolder {};

TEST_F(FolderLocks, SixProcessesChangeAFileAndEachChangeIsKept) {
    std::vector<pid_t> writers;
    for (int i = 0; i < 6; ++i) {
        const pid_t pid = fork();
        if (pid == 0) {
            for (int n = 0; n < 20; ++n) {
                const FolderLock lock(folder_of(file("a")));
                write_whole_file(file("a"), content_of(file("a")) + "x");
            }
            _exit(0);
        }
        writers.push_back(pid);
    }
    for (const pid_t writer : writers) waitpid(writer, nullptr, 0);
    EXPECT_EQ(content_of(file("a")), std::string(120, 'x'));
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(FolderLocks, AreFreeOnceTheirHolderIsGone) {
    {
        const FolderLock held(file(""));
        EXPECT_FALSE(FolderLock::if_free(file("")));
    }
    EXPECT_TRUE(FolderLock::if_free(file("")));
}

TEST_F(FolderLocks, AMissingFolderIsReported) {
    EXPECT_NE(
        complaint<FrameError>([&] { const FolderLock lock(file("none")); }).find("none: cannot be locked"),
        std::string::npos);
    EXPECT_FALSE(FolderLock::if_free(file("none")));
}

TEST_F(FolderLocks, AFileIsLockedWhereItsLinkLeads) {
    std::filesystem::create_directory(file("there"));
    write_whole_file(file("there/a"), "text");
    std::filesystem::create_symlink(file("there/a"), file("link"));
    EXPECT_EQ(folder_of(file("link")), std::filesystem::canonical(file("there")));
}

}  // namespace
}  // namespace zproof
