// The waiver file under several writers at a time, and on a disk that is full.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

namespace fs = std::filesystem;

/// No file of a program that is started meanwhile may become longer than so many bytes: what a full disk
/// does.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limited{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limited);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    rlimit before_{};
};

class WaiverFileOnDisk : public testing::Test {
  protected:
    WaiverFileOnDisk() {
        folder.write("two.gltf", two_triangles());
        run(folder, {"run", "two.gltf", "--width", "64", "--height", "48", "--oracle", "none", "--config",
                     "none", "--precision", "raster,subpixel_bits=16", "--no-diagnosis", "-o", "a", "-q"});
        const auto results = nlohmann::json::parse(folder.read("a/results.json"));
        const auto& worst = results.at("views")[0].at("worst")[0];
        const auto number = [&](const char* key) { return std::to_string(worst.at(key).get<int>()); };
        add = {"waive",     "add",
               "--waivers", "w.toml",
               "--from",    "a",
               "--config",  "none",
               "--scene",   "two",
               "--view",    "frame-all",
               "--pixel",   number("x") + "," + number("y"),
               "--reason",  "known",
               "--link",    "a link",
               "--expires", "2026-04-10",
               "--now",     "2026-01-20"};
    }
    Words prune(const std::string& day) const {
        return {"waive", "prune", "--waivers", "w.toml", "--config", "none", "--now", day};
    }
    int waivers() const {
        const std::string text = folder.read("w.toml");
        int count = 0;
        for (std::size_t at = 0; (at = text.find("[[waiver]]", at)) != std::string::npos; ++at) ++count;
        return count;
    }
    Folder folder;
    Words add;
};

TEST_F(WaiverFileOnDisk, KeepsWhatSixAddAtOnce) {
    std::vector<pid_t> writers;
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    for (int i = 0; i < 6; ++i) writers.push_back(start(folder, add, {nowhere, nowhere}));
    for (const pid_t writer : writers) EXPECT_EQ(exit_code_of(writer), 0);
    close(nowhere);
    EXPECT_EQ(waivers(), 6);
    EXPECT_EQ(folder.names(), (Words{"a", "two.gltf", "w.toml"})) << "nothing else is left behind";
}

TEST_F(WaiverFileOnDisk, IsAsItWasWhereTheDiskIsFull) {
    for (int i = 0; i < 4; ++i) ASSERT_EQ(run(folder, add).exit_code, 0);
    const std::string before = folder.read("w.toml");
    {
        const FullDisk full(before.size() - 100);
        EXPECT_EQ(run(folder, add).exit_code, 3);
        const Ran report = run(folder, {"report", "a", "-o", "w.toml", "--format", "json"});
        EXPECT_EQ(report.exit_code, 3) << report.out << report.err;
        EXPECT_NE(report.err.find("w.toml: cannot be written"), std::string::npos) << report.err;
    }
    EXPECT_EQ(folder.read("w.toml"), before);
    {
        const FullDisk full(60);
        EXPECT_EQ(run(folder, prune("2026-04-10")).exit_code, 0) << "nothing has to be written";
        EXPECT_EQ(run(folder, prune("2026-05-01")).exit_code, 3);
    }
    EXPECT_EQ(folder.read("w.toml"), before);
    EXPECT_EQ(folder.names(), (Words{"a", "two.gltf", "w.toml"}));
}

TEST_F(WaiverFileOnDisk, KeepsItsPermissionsAndItsLink) {
    folder.write("shared/w.toml", "format = 1\n");
    fs::permissions(folder.path() / "shared/w.toml", fs::perms(0640));
    fs::create_symlink("shared/w.toml", folder.path() / "w.toml");
    ASSERT_EQ(run(folder, add).exit_code, 0);
    EXPECT_TRUE(fs::is_symlink(folder.path() / "w.toml"));
    EXPECT_EQ(fs::status(folder.path() / "shared/w.toml").permissions(), fs::perms(0640));
    EXPECT_EQ(waivers(), 1);
}

TEST_F(WaiverFileOnDisk, IsNotReplacedWhereItCannotBeLookedAt) {
    fs::create_symlink("w.toml", folder.path() / "w.toml");
    const Ran ran = run(folder, add);
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
    EXPECT_TRUE(fs::is_symlink(folder.path() / "w.toml"));
}

}  // namespace
}  // namespace zproof::test
