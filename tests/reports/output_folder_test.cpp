#include "reports/output_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "tests/reports/sample.h"

namespace zproof {

namespace {

namespace fs = std::filesystem;

void write_file(const fs::path& file, const std::string& content) { std::ofstream(file) << content; }

/// Names in a folder, sorted.
std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

using Names = std::vector<std::string>;

void publish(const fs::path& path, const std::string& content) {
    OutputFolder folder(path);
    write_file(folder.working() / "results.json", content);
    folder.publish();
}

std::string refusal(const fs::path& path) {
    try {
        const OutputFolder folder(path);
    } catch (const ReportError& e) {
        return e.what();
    }
    return "";
}

}  // namespace

TEST(OutputFolder, AppearsWholeOnlyWhenPublished) {
    const TemporaryFolder home;
    OutputFolder folder(home.path() / "deep/out");
    write_file(folder.working() / "results.json", "{}");
    EXPECT_FALSE(fs::exists(home.path() / "deep/out"));
    folder.publish();
    EXPECT_EQ(names_in(home.path() / "deep"), Names{"out"});
    EXPECT_EQ(names_in(home.path() / "deep/out"), (Names{".zproof-out", "results.json"}));
}

TEST(OutputFolder, ReplacesItsOwnWhole) {
    const TemporaryFolder home;
    publish(home.path() / "out", "old");
    write_file(home.path() / "out/stale", "left by the old run");
    publish(home.path() / "out/", "new");
    EXPECT_EQ(names_in(home.path()), Names{"out"});
    EXPECT_EQ(names_in(home.path() / "out"), (Names{".zproof-out", "results.json"}));
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "new");
}

TEST(OutputFolder, RefusesAForeignFolderAndLeavesItAlone) {
    const TemporaryFolder home;
    fs::create_directory(home.path() / "thesis");
    write_file(home.path() / "thesis/chapter1.tex", "three years of work");
    EXPECT_NE(refusal(home.path() / "thesis").find("thesis: exists and was not made by zproof"),
              std::string::npos);
    EXPECT_EQ(names_in(home.path()), Names{"thesis"});
    EXPECT_EQ(content_of(home.path() / "thesis/chapter1.tex"), "three years of work");
}

TEST(OutputFolder, RefusesAFileAndADeadLink) {
    const TemporaryFolder home;
    write_file(home.path() / "file", "text");
    EXPECT_NE(refusal(home.path() / "file").find("not a folder"), std::string::npos);
    EXPECT_EQ(content_of(home.path() / "file"), "text");
    EXPECT_NE(refusal(home.path() / "file/below"), "");
    EXPECT_NE(refusal(""), "");
    EXPECT_EQ(names_in(home.path()), Names{"file"});
}

TEST(OutputFolder, TakesAnEmptyFolder) {
    const TemporaryFolder home;
    fs::create_directory(home.path() / "out");
    publish(home.path() / "out", "new");
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "new");
    EXPECT_EQ(names_in(home.path()), Names{"out"});
}

TEST(OutputFolder, FollowsALink) {
    const TemporaryFolder home;
    publish(home.path() / "real", "old");
    fs::create_directory_symlink(home.path() / "real", home.path() / "link");
    publish(home.path() / "link", "new");
    EXPECT_TRUE(fs::is_symlink(home.path() / "link"));
    EXPECT_EQ(content_of(home.path() / "real/results.json"), "new");
    EXPECT_EQ(names_in(home.path()), (Names{"link", "real"}));
}

TEST(OutputFolder, LeavesNothingWhenAbandoned) {
    const TemporaryFolder home;
    {
        const OutputFolder folder(home.path() / "out");
        write_file(folder.working() / "half", "a result");
    }
    EXPECT_EQ(names_in(home.path()), Names{});
}

TEST(OutputFolder, AFailureLeavesTheOldOne) {
    const TemporaryFolder home;
    publish(home.path() / "out", "old");
    try {
        OutputFolder folder(home.path() / "out");
        write_file(folder.working() / "results.json", "half");
        throw std::runtime_error("the disk is full");
    } catch (const std::runtime_error&) {
    }
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "old");
    EXPECT_EQ(names_in(home.path()), Names{"out"});
}

TEST(OutputFolder, APublishThatFailsPutsTheOldOneBack) {
    const TemporaryFolder home;
    publish(home.path() / "out", "old");
    {
        OutputFolder folder(home.path() / "out");
        fs::remove_all(folder.working());  // so that it cannot be renamed into place
        EXPECT_THROW(folder.publish(), ReportError);
    }
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "old");
    EXPECT_EQ(names_in(home.path()), Names{"out"});
}

TEST(OutputFolder, LooksAgainBeforeItReplaces) {
    const TemporaryFolder home;
    {
        OutputFolder folder(home.path() / "out");
        fs::create_directory(home.path() / "out");
        write_file(home.path() / "out/mine", "made by somebody meanwhile");
        EXPECT_THROW(folder.publish(), ReportError);
    }
    EXPECT_EQ(names_in(home.path() / "out"), Names{"mine"});
    EXPECT_EQ(names_in(home.path()), Names{"out"});
}

TEST(OutputFolder, TwoAtATimeDoNotShareAWorkingFolder) {
    const TemporaryFolder home;
    const OutputFolder first(home.path() / "out"), second(home.path() / "out");
    EXPECT_NE(first.working(), second.working());
}

}  // namespace zproof
