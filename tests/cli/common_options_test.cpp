// -j, --color, -q and -o: of every command of the tree, and with one meaning.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "program/command_line/outline.h"
#include "tests/cli/outline_of_zproof.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// How a command is called on the files of CommonOptionsOnFiles.
struct Call {
    enum class Told { alike, with_times };    ///< may what it prints differ from call to call?
    enum class Work { at_once, of_seconds };  ///< the latter is called once, in a slow test
    Words words;
    Told told = Told::alike;
    Work work = Work::at_once;
};

const std::string program_word = std::string{ZPROOF_CASTER} + " {scene} {camera} {width} {height} {out}";

/// A command without a row is a failure below.
const std::map<std::string, Call> calls{
    {"run", {{"two.gltf", "--oracle", "none"}, Call::Told::with_times}},
    {"compare", {{"frames/frame-all.exr", "two.gltf", "--oracle", "none"}, Call::Told::with_times}},
    {"explain", {{"two.gltf", "9", "9"}}},
    {"render", {{"two.gltf"}}},
    {"measure", {{"zproof"}}},
    {"fit", {{"two.gltf"}}},
    {"selfcheck", {{"two.gltf"}}},
    {"conformance", {{"zproof", "--random", "1"}, Call::Told::with_times, Call::Work::of_seconds}},
    {"contract-check", {{program_word, "--precision", "ray"}}},
    {"selftest", {{}, Call::Told::alike, Call::Work::of_seconds}},
    {"plan", {{"two.gltf", "--of", "2"}}},
    {"merge", {{"shard"}, Call::Told::with_times}},
    {"report", {{"shard"}}},
    {"diff-results", {{"shard", "shard"}}},
    {"waive list", {{"--waivers", "w.toml", "--now", "2026-01-21"}}},
    {"waive check", {{"--waivers", "w.toml", "--now", "2026-01-21"}}},
    {"waive prune", {{"--waivers", "w.toml", "--now", "2026-01-21", "-o", "pruned.toml"}}},
    {"waive add", {{}}},  // the pixel is known when there are results
    {"doctor", {{}}},
    {"init", {{"c++"}}},
    {"list", {{}}},
    {"scenes generate", {{"guard_band"}}},
    {"scenes random", {{"--count", "2"}}},
    {"views", {{"colmap", "colmap", "two.gltf", "--near", "0.1", "-o", "v.view.json"}}},
    {"filters run", {{"worked", "--view", "phi-0", "--methods", "nearest"}, Call::Told::with_times}},
    {"filters list", {{}}},
    {"filters scenes", {{"worked"}}},
    {"filters reproduce", {{"crow-1984"}}},
    {"filters table", {{"filters"}}},
    {"filters figure", {{"filters"}}},
    {"filters check", {{"nearest", "worked", "--view", "phi-0"}}},
    {"filters explain", {{"worked", "--view", "phi-0", "--pixel", "9,12", "--method", "ewa-true"}}},
    {"filters normals", {{"--view", "phi-0", "--methods", "nearest"}}},
    {"filters crow", {{}}},
    {"filters selftest", {{}, Call::Told::alike, Call::Work::of_seconds}},
    {"study projection", {{"two.gltf", "--without-povray"}, Call::Told::with_times, Call::Work::of_seconds}},
    {"study depth", {{"two.gltf"}, Call::Told::with_times, Call::Work::of_seconds}},
    {"study shading", {{"two.gltf"}, Call::Told::with_times}},
    {"study cost", {{"two.gltf", "--repeats", "1"}, Call::Told::with_times, Call::Work::of_seconds}},
    {"completion", {{"bash"}}},
    {"man", {{}}},
};

std::vector<OutlineCommand> commands() { return leaves_of(outline_of_zproof()); }

const OutlineOption* option_of(const OutlineCommand& command, const std::string& name) {
    const auto option = std::ranges::find_if(command.options, [&](const OutlineOption& o) {
        return std::ranges::find(o.names, name) != o.names.end();
    });
    return option == command.options.end() ? nullptr : &*option;
}

Words words_in(const std::string& path) {
    std::istringstream in{path};
    Words words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

TEST(CommonOptions, AreThoseOfEveryCommandInTheSameWords) {
    const std::vector<OutlineCommand> all = commands();
    for (const OutlineCommand& command : all) {
        for (const char* name : {"--threads", "--color", "--quiet"}) {
            const OutlineOption *here = option_of(command, name), *first = option_of(all.front(), name);
            ASSERT_NE(here, nullptr) << command.path << " " << name;
            EXPECT_EQ(here->names, first->names) << command.path;
            EXPECT_EQ(here->description, first->description) << command.path << " " << name;
            EXPECT_EQ(here->choices, first->choices) << command.path;
        }
        const OutlineOption* out = option_of(command, "-o");
        ASSERT_NE(out, nullptr) << command.path;
        EXPECT_EQ(out->names, (Words{"-o", "--out"})) << command.path;
        EXPECT_TRUE(out->kind == "FILE" || out->kind == "FOLDER") << command.path << " " << out->kind;
        EXPECT_EQ(out->kind == "FOLDER", out->description.starts_with("folder")) << command.path;
    }
}

TEST(CommonOptions, AreTriedOnEveryCommand) {
    std::vector<std::string> paths, tried;
    for (const OutlineCommand& command : commands()) paths.push_back(command.path);
    for (const auto& [path, call] : calls) tried.push_back(path);
    EXPECT_THAT(tried, testing::UnorderedElementsAreArray(paths));
}

/// What the calls need.
class CommonOptionsOnFiles : public testing::Test {
  protected:
    CommonOptionsOnFiles() {
        folder.write("two.gltf", two_triangles());
        folder.write("colmap/cameras.txt", "1 PINHOLE 64 48 50 50 32 24\n");
        folder.write("colmap/images.txt", "1 1 0 0 0 0 0 2 1 a.png\n\n");
        made({"render", "two.gltf", "-o", "frames"});
        made({"run", "two.gltf", "--oracle", "none", "--config", "none", "--shard", "hash:1/1", "--precision",
              "raster,subpixel_bits=16", "-o", "shard"});
        made({"filters", "run", "worked", "--view", "phi-0", "--methods", "nearest", "-o", "filters"});
        const auto results = nlohmann::json::parse(folder.read("shard/results.json"));
        const auto& worst = results.at("views")[0].at("worst")[0];
        pixel_ = std::to_string(worst.at("x").get<int>()) + "," + std::to_string(worst.at("y").get<int>());
        EXPECT_EQ(run(folder, words_of("waive add", {"-o", "w.toml"})).exit_code, 0);
    }

    Ran called(const std::string& path, const Words& more) { return run(folder, words_of(path, more)); }

    Folder folder;

  private:
    void made(Words words) const {
        words.insert(words.end(), {"--width", "24", "--height", "18"});
        run(folder, words);
    }

    /// The whole command line of the call, and more.
    Words words_of(const std::string& path, const Words& more) {
        Words words = words_in(path);
        const Words& own = calls.at(path).words;
        words.insert(words.end(), own.begin(), own.end());
        if (takes_size_.contains(path)) words.insert(words.end(), {"--width", "24", "--height", "18"});
        if (path == "waive add")
            words.insert(words.end(),
                         {"--waivers", "new-" + std::to_string(++waiver_files_) + ".toml", "--from", "shard",
                          "--scene", "two", "--pixel", pixel_, "--reason", "known", "--link", "a link",
                          "--expires", "2026-04-10", "--now", "2026-01-20"});
        const bool has_folder = std::ranges::count(more, "-o") > 0;
        if (path == "init" && !has_folder)
            words.insert(words.end(), {"-o", "begun"});  // here it sets settings
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    const std::set<std::string> takes_size_ = [] {
        std::set<std::string> paths;
        for (const OutlineCommand& command : commands())
            if (command.path != "views" && option_of(command, "--width") != nullptr)
                paths.insert(command.path);
        return paths;
    }();
    std::string pixel_;
    int waiver_files_ = 0;
};

std::ptrdiff_t lines_of(const std::string& text) { return std::ranges::count(text, '\n'); }

TEST_F(CommonOptionsOnFiles, QuietLeavesTheResultAlone) {
    const std::set<std::string> texts{
        "list",       "waive list", "filters list", "filters table",  "filters reproduce",
        "completion", "man",        "plan",         "filters normals"};  // they are their own result
    for (const auto& [path, call] : calls) {
        if (call.work == Call::Work::of_seconds) continue;
        SCOPED_TRACE(path);
        const Ran quiet = called(path, {"-q"});
        EXPECT_EQ(quiet.err, "");
        EXPECT_NE(quiet.out, "");
        const bool is_text = texts.contains(path);
        EXPECT_TRUE(is_text || lines_of(quiet.out) == 1) << quiet.out;
        const Ran loud = called(path, {});
        EXPECT_EQ(loud.exit_code, quiet.exit_code) << loud.out << loud.err;
        EXPECT_GE(loud.out.size(), quiet.out.size()) << loud.out;
        EXPECT_TRUE(!is_text || loud.out == quiet.out) << quiet.out;
    }
}

TEST_F(CommonOptionsOnFiles, QuietLeavesOneLineOfWorkOfSeconds) {
    for (const auto& [path, call] : calls) {
        if (call.work == Call::Work::at_once) continue;
        SCOPED_TRACE(path);
        const Ran quiet = called(path, {"-q"});
        EXPECT_EQ(quiet.err, "");
        EXPECT_EQ(lines_of(quiet.out), 1) << quiet.out;
    }
}

TEST_F(CommonOptionsOnFiles, ColourIsThereOrNot) {
    const std::set<std::string> with_colours{"run", "compare", "merge"};
    for (const auto& [path, call] : calls) {
        if (call.work == Call::Work::of_seconds) continue;
        SCOPED_TRACE(path);
        const Ran plain = called(path, {"--color", "never"}), painted = called(path, {"--color", "always"});
        EXPECT_EQ(plain.exit_code, painted.exit_code) << plain.err << painted.err;
        EXPECT_THAT(plain.out + plain.err, Not(HasSubstr("\x1b")));
        EXPECT_EQ(painted.out.find('\x1b') != std::string::npos, with_colours.contains(path)) << painted.out;
    }
}

TEST_F(CommonOptionsOnFiles, ThreadsChangeNoByte) {
    for (const auto& [path, call] : calls) {
        if (call.work == Call::Work::of_seconds) continue;
        SCOPED_TRACE(path);
        const char* detail = call.told == Call::Told::with_times ? "-q" : "--color=never";
        const Ran one = called(path, {"-j", "1", detail}), three = called(path, {"-j", "3", detail});
        EXPECT_EQ(one.exit_code, three.exit_code) << one.err << three.err;
        EXPECT_EQ(one.out, three.out);
    }
}

/// A command that makes files puts them there; what another one prints is then in the file, and not on
/// stdout.
TEST_F(CommonOptionsOnFiles, OutIsWhereTheOutputGoes) {
    for (const auto& [path, call] : calls) {
        if (call.work == Call::Work::of_seconds || path == "views" || path == "waive prune") continue;
        SCOPED_TRACE(path);
        const std::string name = "out-" + words_in(path).back() + ".html";
        const Ran printed = called(path, {}), kept = called(path, {"-o", name});
        EXPECT_EQ(kept.exit_code, printed.exit_code) << kept.err;
        ASSERT_TRUE(std::filesystem::exists(folder.path() / name));
        if (std::filesystem::is_directory(folder.path() / name) || path == "report" || path == "plan") {
            EXPECT_THAT(kept.out, HasSubstr(name));
        } else if (path == "waive add") {
            EXPECT_THAT(folder.read(name), HasSubstr(kept.out));
        } else {
            EXPECT_EQ(kept.out, "");
            EXPECT_EQ(folder.read(name), printed.out);
        }
        std::filesystem::remove_all(folder.path() / name);
    }
}

TEST(Out, OfACommandThatPrintsIsAFileOrRefused) {
    const Folder folder;
    folder.write("old.txt", "as it was");
    folder.write("folder/a", "");
    EXPECT_EQ(run(folder, {"explain", "nix", "1", "1", "-o", "old.txt"}).exit_code, 3);
    EXPECT_EQ(folder.read("old.txt"), "as it was") << "a command that is refused writes nothing";
    const Ran onto_folder = run(folder, {"list", "-o", "folder"});
    EXPECT_EQ(onto_folder.exit_code, 3);
    EXPECT_THAT(onto_folder.err, HasSubstr("folder: cannot be written: is a folder; expected a file name"));
    const Ran into_nothing = run(folder, {"list", "-o", "absent/a.txt"});
    EXPECT_EQ(into_nothing.exit_code, 3);
    EXPECT_THAT(into_nothing.err, HasSubstr("absent/a.txt: cannot be written: No such file or directory"));
    EXPECT_THAT(run(folder, {"list", "-o", "-"}).out, HasSubstr("room"));
    EXPECT_EQ(folder.names(), (Words{"folder", "old.txt"}));
}

/// ZPROOF_OUT names the folder of a run. What a command prints, and a file of waivers, stay where they are.
TEST(Out, OfTheEnvironmentIsForReports) {
    const Folder folder;
    folder.write("w.toml", "format = 1\n");
    const Ran ran = run(folder, {"waive", "list", "--waivers", "w.toml"}, {"ZPROOF_OUT=reports"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.out, "0 waivers\n");
    EXPECT_EQ(folder.names(), Words{"w.toml"});
}

}  // namespace
}  // namespace zproof::test
