// Random scenes on the command line: run --random, scenes random, random:KIND:SEED:NUMBER, and what shrinks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json views_in(const Folder& folder, const std::string& out = "zproof-out") {
    return json::parse(folder.read(out + "/results.json")).at("views");
}

std::string faulty(const std::string& fault) {
    return "python3 '" ZPROOF_SOURCE_DIR "/tests/cli/faulty_renderer.py' " + fault +
           " {scene} {camera} {out}";
}

TEST(RandomRun, JudgesAsManyAsAreAskedForAgainstEmbreeAlone) {
    const Folder folder;
    const Ran ran = run(folder, {"run", "--random", "24", "--seed", "7"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    const json views = views_in(folder);
    ASSERT_EQ(views.size(), 24u);
    EXPECT_EQ(views[0].at("scene"), "random:soup:7:0");
    EXPECT_EQ(views[23].at("scene"), "random:mixed:7:23");
    for (const json& view : views) {
        EXPECT_EQ(view.at("oracles"), json::array());
        EXPECT_FALSE(view.contains("shrunk"));
    }
}

TEST(RandomRun, IsTheRunOverItsWordsWhateverTheResolution) {
    const Folder folder;
    run(folder, {"run", "--random", "3", "--kind", "clipped", "-o", "a"});
    run(folder, {"run", "random:clipped:1:0", "random:clipped:1:1", "random:clipped:1:2", "--oracle", "none",
                 "--width", "9", "--height", "9", "-o", "b"});
    json a = views_in(folder, "a"), b = views_in(folder, "b");
    for (json* views : {&a, &b})
        for (json& view : *views) view.erase("times");
    EXPECT_EQ(a, b);
}

TEST(RandomRun, AnOracleThatIsNamedIsAsked) {
    const Folder folder;
    run(folder, {"run", "--random", "1", "--renderer", "embree", "--oracle", "zproof"});
    EXPECT_EQ(views_in(folder)[0].at("oracles")[0].at("name"), "zproof");
}

TEST(RandomRun, RefusesWhatMeansNothing) {
    const Folder folder;
    EXPECT_EQ(run(folder, {"run", "--seed", "7"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"run", "--kind", "soup"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"run", "--random", "0"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"run", "room", "--random", "2"}).exit_code, 2);
    const Ran kind = run(folder, {"run", "--random", "2", "--kind", "fog"});
    EXPECT_EQ(kind.exit_code, 2);
    EXPECT_THAT(kind.err, HasSubstr("any,soup,surface"));
    const Ran word = run(folder, {"run", "random:fog:1:2"});
    EXPECT_EQ(word.exit_code, 3);
    EXPECT_THAT(word.err, HasSubstr("random:KIND:SEED:NUMBER"));
}

TEST(RandomScenesAsFiles, AreTheScenesOfTheirWords) {
    const Folder folder;
    const Ran written = run(folder, {"scenes", "random", "--seed", "4", "--count", "13", "-o", "s"});
    EXPECT_EQ(written.exit_code, 0) << written.err;
    EXPECT_THAT(written.out, HasSubstr("s/random-soup-4-12.view.json"));
    run(folder, {"run", "s", "--oracle", "none", "-o", "files"});
    run(folder, {"run", "--random", "13", "--seed", "4", "-o", "words"});
    std::map<std::string, json> by_name;
    for (const json& view : views_in(folder, "files")) by_name[view.at("scene")] = view;
    ASSERT_EQ(by_name.size(), 13u);
    for (const json& view : views_in(folder, "words")) {
        std::string name = view.at("scene");
        std::ranges::replace(name, ':', '-');
        for (const char* same : {"scene_sha256", "counts", "width", "height", "triangles", "candidate_depth"})
            EXPECT_EQ(by_name.at(name).at(same), view.at(same)) << name << " " << same;
    }
}

TEST(RandomScenesAsFiles, ExplainAndRenderTakeTheWord) {
    const Folder folder;
    EXPECT_EQ(run(folder, {"explain", "random:surface:1:3", "0", "0"}).exit_code, 0);
    EXPECT_EQ(run(folder, {"render", "random:surface:1:3", "-o", "r"}).exit_code, 0);
    EXPECT_THAT(folder.read("r/main.exr"), testing::SizeIs(testing::Gt(100u)));
}

/// A defect that is planted by a renderer, or by a promise that it does not keep.
struct Planted {
    const char* name;
    const char *kind, *seed;
    Words options;
    int exit_code;
};

class ShrinkPlanted : public testing::TestWithParam<Planted> {
  protected:
    Ran run_with(const Folder& folder, Words words) const {
        const Words& more = GetParam().options;
        words.insert(words.end(), more.begin(), more.end());
        return run(folder, words);
    }
};

TEST_P(ShrinkPlanted, LeavesATriangleOrTwoInOnePixelAndACommandThatShowsIt) {
    const auto& [name, kind, seed, options, exit_code] = GetParam();
    const Folder folder;
    const Ran ran = run_with(folder, {"run", "--random", "2", "--kind", kind, "--seed", seed});
    EXPECT_EQ(ran.exit_code, exit_code) << ran.out << ran.err;
    EXPECT_THAT(ran.out, testing::ContainsRegex("shrunk to [12] triangles? at 1 x 1"));
    std::cout << ran.out.substr(0, ran.out.find("\n    ")) << "\n";
    std::vector<json> shrunk;
    for (const json& view : views_in(folder))
        if (view.contains("shrunk")) shrunk.push_back(view.at("shrunk"));
    ASSERT_EQ(shrunk.size(), 1u) << "failures of one kind are shrunk once";
    const std::string file = "zproof-out/" + shrunk[0].at("file").get<std::string>();
    EXPECT_EQ(run_with(folder, {"run", file, "--oracle", "none", "-o", "again"}).exit_code, exit_code);
    EXPECT_THAT(shrunk[0].at("command").get<std::string>(), HasSubstr(file));
}

INSTANTIATE_TEST_SUITE_P(
    Defects, ShrinkPlanted,
    testing::Values(
        Planted{"a_promise_of_finer_pixels", "soup", "9", {"--precision", "raster,subpixel_bits=16"}, 1},
        Planted{"ids_from_one", "surface", "5", {"--renderer", faulty("ids_from_one")}, 1},
        Planted{"a_crash", "tiny", "9", {"--renderer", faulty("crashes")}, 3}),
    [](const auto& p) { return std::string(p.param.name); });

}  // namespace
}  // namespace zproof::test
