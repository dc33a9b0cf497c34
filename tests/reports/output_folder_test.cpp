#include "reports/output_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <thread>
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
    EXPECT_EQ(folder.publish(), std::vector<fs::path>{});
}

/// Publishes again. The paths in `home` of what was kept.
std::vector<std::string> republish(const TestFolder& home, const std::string& content) {
    OutputFolder folder(home.path() / "out");
    write_file(folder.working() / "results.json", content);
    std::vector<std::string> kept;
    for (const fs::path& file : folder.publish())
        kept.push_back(file.lexically_relative(home.path()).string());
    return kept;
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

TEST(OutputFolder, ThatIsPartialStandsBesideTheLastFullOne) {
    const TestFolder home;
    const auto publish_partial = [&](const std::string& content) {
        OutputFolder folder(home.path() / "out");
        write_file(folder.working() / "results.json", content);
        EXPECT_TRUE(folder.publish(Completeness::partial).empty());
        return folder.suffix();
    };
    EXPECT_EQ(publish_partial("partial"), "");
    EXPECT_EQ(publish_partial("another"), "") << "replaces a partial one";
    publish(home.path() / "out", "full");
    EXPECT_EQ(publish_partial("third"), ".partial");
    EXPECT_EQ(publish_partial("fourth"), ".partial") << "replaces a partial one there as well";
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "full");
    EXPECT_EQ(content_of(home.path() / "out.partial/results.json"), "fourth");
    EXPECT_EQ(names_in(home.path()), (Names{"out", "out.partial"}));
    publish(home.path() / "out", "newer");
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "newer");
    EXPECT_EQ(names_in(home.path()), Names{"out"}) << "a full one ends the partial one";
}

TEST(OutputFolder, ThatIsFullLeavesAForeignPartialFolderAlone) {
    const TestFolder home;
    fs::create_directory(home.path() / "out.partial");
    write_file(home.path() / "out.partial/thesis.tex", "years of work");
    publish(home.path() / "full.partial", "a run's own folder");
    publish(home.path() / "out", "full");
    publish(home.path() / "full", "full");
    EXPECT_EQ(content_of(home.path() / "out.partial/thesis.tex"), "years of work");
    EXPECT_EQ(content_of(home.path() / "full.partial/results.json"), "a run's own folder");
}

TEST(OutputFolder, KeepsWhatOthersPutIntoAPartialOne) {
    const TestFolder home;
    publish(home.path() / "out", "full");
    {
        OutputFolder folder(home.path() / "out");
        EXPECT_TRUE(folder.publish(Completeness::partial).empty());
    }
    write_file(home.path() / "out.partial/notes.txt", "mine");
    EXPECT_EQ(republish(home, "newer"), std::vector<std::string>{"out/notes.txt"});
    EXPECT_EQ(names_in(home.path()), Names{"out"});
}

TEST(OutputFolder, AppearsWholeOnlyWhenPublished) {
    const TestFolder home;
    OutputFolder folder(home.path() / "deep/out");
    write_file(folder.working() / "results.json", "{}");
    EXPECT_FALSE(fs::exists(home.path() / "deep/out"));
    EXPECT_TRUE(folder.publish().empty());
    EXPECT_EQ(names_in(home.path() / "deep"), Names{"out"});
    EXPECT_EQ(names_in(home.path() / "deep/out"), (Names{".zproof-out", "results.json"}));
}

TEST(OutputFolder, ReplacesItsOwnWhole) {
    const TestFolder home;
    {
        OutputFolder folder(home.path() / "out");
        fs::create_directories(folder.working() / "scenes/a");
        write_file(folder.working() / "scenes/a/stale", "left by the old run");
        EXPECT_TRUE(folder.publish().empty());
    }
    publish(home.path() / "out/", "new");
    EXPECT_EQ(names_in(home.path()), Names{"out"});
    EXPECT_EQ(names_in(home.path() / "out"), (Names{".zproof-out", "results.json"}));
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "new");
}

TEST(OutputFolder, KeepsWhatItDidNotWrite) {
    const TestFolder home;
    publish(home.path() / "out", "old");
    fs::create_directories(home.path() / "out/models/deep");
    write_file(home.path() / "out/models/deep/mine.gltf", "a model");
    fs::create_symlink("nowhere", home.path() / "out/link");
    EXPECT_EQ(republish(home, "new"), (Names{"out/link", "out/models/deep/mine.gltf"}));
    EXPECT_EQ(republish(home, "newer"), (Names{"out/link", "out/models/deep/mine.gltf"}));
    EXPECT_EQ(content_of(home.path() / "out/models/deep/mine.gltf"), "a model");
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "newer");
    EXPECT_EQ(names_in(home.path()), Names{"out"});
}

TEST(OutputFolder, KeepsItsOwnFileWhereSomebodyChangedIt) {
    const TestFolder home;
    publish(home.path() / "out", "old");
    write_file(home.path() / "out/results.json", "0ld");
    EXPECT_EQ(republish(home, "new"), Names{"out/results.json.kept"});
    write_file(home.path() / "out/results.json", "n3w");
    std::vector<std::string> kept = republish(home, "newer");
    std::ranges::sort(kept);
    EXPECT_EQ(kept, (Names{"out/results.json.kept", "out/results.json.kept-2"}));
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "newer");
}

TEST(OutputFolder, RefusesOneWithoutAListAndLeavesItAlone) {
    const TestFolder home;
    fs::create_directory(home.path() / "out");
    write_file(home.path() / "out/.zproof-out", "zproof made this folder and replaces it whole.\n");
    EXPECT_NE(refusal(home.path() / "out").find("kept no list of its files"), std::string::npos);
    EXPECT_EQ(names_in(home.path()), Names{"out"});
}

/// Somebody looks all the time: PATH is there whenever.
TEST(OutputFolder, IsNeverMissingWhileItIsReplaced) {
    const TestFolder home;
    publish(home.path() / "out", "first");
    std::atomic<bool> over = false;
    std::size_t missing = 0;
    std::thread watcher([&] {
        while (!over) missing += !fs::exists(home.path() / "out/results.json");
    });
    for (int i = 0; i < 200; ++i) publish(home.path() / "out", std::to_string(i));
    over = true;
    watcher.join();
    EXPECT_EQ(missing, 0u);
}

TEST(OutputFolder, TidiesUpAfterRunsThatWereKilled) {
    const TestFolder home;
    publish(home.path() / "out", "old");
    write_file(home.path() / "out/mine", "a file of somebody");
    fs::rename(home.path() / "out", home.path() / "out.old-123");  // killed between two renames
    fs::create_directory(home.path() / "out.tmp-77");
    write_file(home.path() / "out.tmp-77/.zproof-out", "zproof has not finished this folder.\n");
    fs::create_directory(home.path() / "out.tmp-mine");
    write_file(home.path() / "out.tmp-mine/.zproof-out", "zproof has not finished this folder.\n");
    fs::create_directory(home.path() / "out.tmp-5");
    write_file(home.path() / "out.tmp-5/thesis.tex", "years of work");
    { const OutputFolder folder(home.path() / "out"); }
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "old");
    EXPECT_EQ(content_of(home.path() / "out/mine"), "a file of somebody");
    EXPECT_EQ(names_in(home.path()), (Names{"out", "out.tmp-5", "out.tmp-mine"}));
}

TEST(OutputFolder, RemovesTheEmptyFolderOfADeadProcess) {
    const TestFolder home;
    fs::create_directory(home.path() / "out.tmp-99999999");  // no process has such a number
    fs::create_directory(home.path() / "out.old-99999999-2");
    fs::create_directory(home.path() / "out.tmp-1");  // a living one's: it may be about to lock it
    { const OutputFolder folder(home.path() / "out"); }
    EXPECT_EQ(names_in(home.path()), Names{"out.tmp-1"});
}

TEST(OutputFolder, RetiresWhatAKilledRunHadReplaced) {
    const TestFolder home;
    publish(home.path() / "out", "old");
    write_file(home.path() / "out/mine", "a file of somebody");
    fs::rename(home.path() / "out", home.path() / "out.tmp-9");  // killed after the exchange
    publish(home.path() / "other", "new");
    fs::rename(home.path() / "other", home.path() / "out");
    EXPECT_EQ(republish(home, "newer"), (Names{"out/mine", "out/mine"}));
    EXPECT_EQ(names_in(home.path()), Names{"out"});
    EXPECT_EQ(names_in(home.path() / "out"), (Names{".zproof-out", "mine", "results.json"}));
}

TEST(OutputFolder, RefusesAForeignFolderAndLeavesItAlone) {
    const TestFolder home;
    fs::create_directory(home.path() / "thesis");
    write_file(home.path() / "thesis/chapter1.tex", "three years of work");
    EXPECT_NE(refusal(home.path() / "thesis").find("thesis: exists and was not made by zproof"),
              std::string::npos);
    EXPECT_EQ(names_in(home.path()), Names{"thesis"});
    EXPECT_EQ(content_of(home.path() / "thesis/chapter1.tex"), "three years of work");
}

TEST(OutputFolder, RefusesAFileAndADeadLink) {
    const TestFolder home;
    write_file(home.path() / "file", "text");
    EXPECT_NE(refusal(home.path() / "file").find("not a folder"), std::string::npos);
    EXPECT_EQ(content_of(home.path() / "file"), "text");
    EXPECT_NE(refusal(home.path() / "file/below"), "");
    EXPECT_NE(refusal(""), "");
    EXPECT_EQ(names_in(home.path()), Names{"file"});
}

TEST(OutputFolder, TakesAnEmptyFolder) {
    const TestFolder home;
    fs::create_directory(home.path() / "out");
    publish(home.path() / "out", "new");
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "new");
    EXPECT_EQ(names_in(home.path()), Names{"out"});
}

TEST(OutputFolder, FollowsALink) {
    const TestFolder home;
    publish(home.path() / "real", "old");
    fs::create_directory_symlink(home.path() / "real", home.path() / "link");
    publish(home.path() / "link", "new");
    EXPECT_TRUE(fs::is_symlink(home.path() / "link"));
    EXPECT_EQ(content_of(home.path() / "real/results.json"), "new");
    EXPECT_EQ(names_in(home.path()), (Names{"link", "real"}));
}

TEST(OutputFolder, LeavesNothingWhenAbandoned) {
    const TestFolder home;
    {
        const OutputFolder folder(home.path() / "out");
        write_file(folder.working() / "half", "a result");
    }
    EXPECT_EQ(names_in(home.path()), Names{});
}

TEST(OutputFolder, AFailureLeavesTheOldOne) {
    const TestFolder home;
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
    const TestFolder home;
    publish(home.path() / "out", "old");
    {
        OutputFolder folder(home.path() / "out");
        fs::remove_all(folder.working());  // so that it cannot be renamed into place
        EXPECT_THROW((void)folder.publish(), ReportError);
    }
    EXPECT_EQ(content_of(home.path() / "out/results.json"), "old");
    EXPECT_EQ(names_in(home.path()), Names{"out"});
}

TEST(OutputFolder, LooksAgainBeforeItReplaces) {
    const TestFolder home;
    {
        OutputFolder folder(home.path() / "out");
        fs::create_directory(home.path() / "out");
        write_file(home.path() / "out/mine", "made by somebody meanwhile");
        EXPECT_THROW((void)folder.publish(), ReportError);
    }
    EXPECT_EQ(names_in(home.path() / "out"), Names{"mine"});
    EXPECT_EQ(names_in(home.path()), Names{"out"});
}

TEST(OutputFolder, TwoAtATimeDoNotShareAWorkingFolder) {
    const TestFolder home;
    const OutputFolder first(home.path() / "out"), second(home.path() / "out");
    EXPECT_NE(first.working(), second.working());
    EXPECT_TRUE(fs::exists(first.working())) << "the second took the first for dead";
}

}  // namespace zproof
