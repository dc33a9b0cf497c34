// Kept reference frames change no result, and are not trusted.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/program.h"
#include "tests/cli/same_run.h"

namespace zproof::test {
namespace {

namespace fs = std::filesystem;

Ran judge(const Folder& folder, const Words& more) {
    Words words{"run",  "room",     "near_plane", "--width", "64",         "--height", "48", "--oracle",
                "none", "--config", "none",       "-q",      "--evidence", "all",      "-o", "out"};
    words.insert(words.end(), more.begin(), more.end());
    return run(folder, words);
}

std::vector<fs::path> kept_in(const Folder& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder.path() / "kept")) files.push_back(entry.path());
    return files;
}

TEST(ReferenceCache, ChangesNoByteOfAResult) {
    const Folder first, second;
    const Ran one = judge(first, {"--reference-cache", "kept"});
    EXPECT_EQ(one.exit_code, 0) << one.err;
    const std::size_t views = kept_in(first).size();
    EXPECT_GE(views, 4u);
    fs::copy(first.path() / "kept", second.path() / "kept");
    EXPECT_EQ(judge(second, {"--reference-cache", "kept"}).exit_code, 0);
    EXPECT_EQ(kept_in(second).size(), views);
    expect_same_run(first.path() / "out", second.path() / "out");
}

TEST(ReferenceCache, IsNotTrusted) {
    const Folder folder;
    judge(folder, {"--reference-cache", "kept"});
    for (const fs::path& file : kept_in(folder)) {
        std::fstream bytes{file, std::ios::in | std::ios::out | std::ios::binary};
        bytes.seekp(-64, std::ios::end);
        bytes << "nobody rendered this";
    }
    EXPECT_EQ(judge(folder, {"--reference-cache", "kept"}).exit_code, 0);
}

TEST(ReferenceCache, HasALimitThatIsASize) {
    const Folder folder;
    EXPECT_EQ(judge(folder, {"--reference-cache", "kept", "--reference-cache-size", "30KB"}).exit_code, 0);
    EXPECT_LE(kept_in(folder).size(), 2u);
    EXPECT_EQ(judge(folder, {"--reference-cache", "kept", "--reference-cache-size", "much"}).exit_code, 2);
    EXPECT_EQ(judge(folder, {"--reference-cache-size", "30KB"}).exit_code, 2);
}

}  // namespace
}  // namespace zproof::test
