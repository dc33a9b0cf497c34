// What is no regular file, as the file of every option and operand of the real program: refused at once.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

namespace fs = std::filesystem;

/// The words of a command line; '@' in one stands for the file's name without its ending.
struct FileOption {
    const char* name;
    Words words;
};

void PrintTo(const FileOption& option, std::ostream* out) { *out << option.name; }

const FileOption options[] = {
    {"RunPrecision", {"run", "one.gltf", "--precision", "./@.json"}},
    {"RunConvention", {"run", "one.gltf", "--renderer", "true {out}", "--convention", "@.json"}},
    {"RunIds", {"run", "one.gltf", "--ids", "@.json"}},
    {"RunWaivers", {"run", "one.gltf", "--waivers", "@.toml"}},
    {"RunConfig", {"run", "one.gltf", "--config", "@.toml"}},
    {"RenderScene", {"render", "@.gltf"}},
    {"RenderViewFile", {"render", "@.view.json"}},
    {"CompareFrame", {"compare", "@.exr", "one.gltf"}},
    {"CompareArray", {"compare", "@.npy", "one.gltf"}},
    {"CompareIdsAndDepths", {"compare", "@.exr+@.exr", "one.gltf"}},
    {"CompareReference", {"compare", "@.exr", "@.exr", "--scene", "one.gltf"}},
    {"ExplainCandidate", {"explain", "one.gltf", "3", "3", "--candidate", "@.exr"}},
    {"ExplainReference", {"explain", "one.gltf", "3", "3", "--reference", "@.exr"}},
    {"ContractIds", {"contract-check", "true {scene} {out}", "--ids", "@.json"}},
    {"MeasurePrecision", {"measure", "zproof", "--precision", "@.json"}},
    {"FitCandidate", {"fit", "one.gltf", "--candidate", "@.exr"}},
    {"FiltersPhotograph", {"filters", "run", "@.png"}},
    {"FiltersPicture",
     {"filters", "check", "trilinear-gl", "worked", "--view", "phi-0", "--picture", "@.exr"}},
    {"FiltersExplainPicture",
     {"filters", "explain", "worked", "--view", "phi-0", "--pixel", "9,30", "--method", "nearest",
      "--picture", "@.exr"}},
    {"FiltersTable", {"filters", "table", "@"}},
    {"MergeShard", {"merge", "@.json"}},
    {"ReportResults", {"report", "@.json"}},
    {"DiffResults", {"diff-results", "@.json", "@.json"}},
    {"WaiveList", {"waive", "list", "--waivers", "@.toml"}},
    {"WaivePrune", {"waive", "prune", "--waivers", "@.toml"}},
    {"WaiveCheck", {"waive", "check", "--waivers", "empty.toml", "--from", "@.json"}},
    {"DoctorConfig", {"doctor", "--config", "@.toml"}},
    {"StudyScene", {"study", "projection", "@.gltf"}},
    {"ViewsOfOpenCv", {"views", "opencv", "@.json", "one.gltf", "--near", "0.1", "-o", "a.view.json"}},
    {"ViewsOfNerf", {"views", "nerf", "@.json", "one.gltf", "--near", "0.1", "-o", "a.view.json"}},
    {"ViewsOfColmap", {"views", "colmap", "@", "one.gltf", "--near", "0.1", "-o", "a.view.json"}},
};

Words with_file(Words words, const std::string& name) {
    for (std::string& word : words)
        for (std::size_t at; (at = word.find('@')) != std::string::npos;) word.replace(at, 1, name);
    return words;
}

/// A program that takes a device for a file fills no more than this.
class LimitedMemory {
  public:
    LimitedMemory() {
        getrlimit(RLIMIT_AS, &before_);
        const rlimit limit{rlim_t{4} << 30, before_.rlim_max};
        setrlimit(RLIMIT_AS, &limit);
    }
    ~LimitedMemory() { setrlimit(RLIMIT_AS, &before_); }

  private:
    rlimit before_{};
};

class FileOptions : public testing::TestWithParam<FileOption> {
  protected:
    FileOptions() {
        folder.write("one.gltf", one_triangle());
        folder.write("empty.toml", "format = 1\n");
        mkfifo((folder.path() / "a_pipe").c_str(), 0600);
        fs::create_directory(folder.path() / "a_folder");
        link("pipe", "a_pipe");
        link("device", "/dev/zero");
        link("folder", "a_folder");
        link("loop", "loop");
        folder.write("bytes.json", not_utf8);
        fs::create_directory(folder.path() / "bytes");
        for (const char* file : {"bytes/cameras.txt", "bytes/images.txt", "bytes/filters.json"})
            folder.write(file, not_utf8);
        for (const char* ending : {".toml", ".gltf", ".view.json", ".exr", ".npy", ".png"})
            folder.write(std::string{"bytes"} + ending, not_utf8);
    }

    /// Links of every ending to the target.
    void link(const std::string& name, const fs::path& target) const {
        for (const char* ending : {".json", ".toml", ".gltf", ".view.json", ".exr", ".npy", ".png"})
            fs::create_symlink(name == target ? fs::path{name + ending} : target,
                               folder.path() / (name + ending));
        for (const char* file : {"cameras.txt", "images.txt", "filters.json"}) {
            fs::create_directory(folder.path() / name);
            fs::create_symlink(name == target ? fs::path{file} : folder.path() / target,
                               folder.path() / name / file);
        }
    }

    void expect_refused(const std::string& name, const std::string& what) const {
        SCOPED_TRACE(name);
        const Ran ran = run(folder, with_file(GetParam().words, name));
        EXPECT_TRUE(ran.exit_code == 2 || ran.exit_code == 3) << ran.exit_code << ran.out << ran.err;
        const std::string said = ran.out + ran.err;
        EXPECT_NE(said.find(name), std::string::npos) << said;
        EXPECT_NE(said.find(what), std::string::npos) << said;
    }

    Folder folder;
    const std::string not_utf8 = "\xB6\xFF {\"a\": \"\xB6\"}";
    const LimitedMemory limited;
};

TEST_P(FileOptions, RefuseWhatIsNoRegularFile) {
    expect_refused("pipe", "is a pipe; expected");
    expect_refused("device", "is a device; expected");
    expect_refused("loop", "is a loop of links; expected");
    expect_refused("folder", "older");
}

TEST_P(FileOptions, RefuseBytesThatAreNoText) { expect_refused("bytes", "bytes"); }

INSTANTIATE_TEST_SUITE_P(Of, FileOptions, testing::ValuesIn(options),
                         [](const auto& tested) { return tested.param.name; });

TEST(ModelOfViews, ThatIsAPipeIsRefused) {
    const Folder folder;
    mkfifo((folder.path() / "pipe.gltf").c_str(), 0600);
    const Ran ran =
        run(folder, {"views", "nerf", "a.json", "pipe.gltf", "--near", "0.1", "-o", "a.view.json"});
    EXPECT_EQ(ran.exit_code, 3) << ran.err;
    EXPECT_NE(ran.err.find("pipe.gltf: is a pipe; expected the model"), std::string::npos) << ran.err;
}

TEST(PromiseInAWord, ThatIsNoUtf8IsRefusedWithItsBytes) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    const Ran ran = run(folder, {"run", "one.gltf", "--precision", "ray,arithmetic=\xB6"});
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_NE(ran.err.find("/arithmetic: expected"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("found \"\\xb6\""), std::string::npos) << ran.err;
}

TEST(SettingsFileOfTheFolder, ThatIsAPipeIsRefused) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    mkfifo((folder.path() / "zproof.toml").c_str(), 0600);
    const Ran ran = run(folder, {"run", "one.gltf"});
    EXPECT_EQ(ran.exit_code, 3) << ran.err;
    EXPECT_NE(ran.err.find("zproof.toml: is a pipe; expected a TOML file"), std::string::npos) << ran.err;
}

TEST(OutputFolder, WhoseListIsAPipeIsLeftAlone) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    fs::create_directory(folder.path() / "out");
    mkfifo((folder.path() / "out/.zproof-out").c_str(), 0600);
    const Ran ran = run(folder, {"run", "one.gltf", "--oracle", "none", "-o", "out"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
}

}  // namespace
}  // namespace zproof::test
