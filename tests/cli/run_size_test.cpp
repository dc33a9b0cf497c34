// zproof run --quick and --thorough.
#include "cli/run_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "program/settings.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;

json views_of(const Folder& folder) {
    return json::parse(folder.read("zproof-out/results.json")).at("views");
}

TEST(RunSize, QuickIsSmallAndAsksEmbreeAlone) {
    const Folder folder;
    EXPECT_EQ(run(folder, {"run", "room", "--quick"}).exit_code, 0);
    for (const json& view : views_of(folder)) {
        EXPECT_EQ(view.at("width"), 480);
        EXPECT_EQ(view.at("height"), 270);
        EXPECT_EQ(view.at("oracles"), json::array());
    }
}

TEST(RunSize, QuickAsksTheOraclesThatAreNamed) {
    const Folder folder;
    EXPECT_EQ(run(folder, {"run", "room", "--quick", "--oracle", "zproof", "--renderer", "embree"}).exit_code,
              0);
    for (const json& view : views_of(folder)) EXPECT_EQ(view.at("oracles").at(0).at("name"), "zproof");
}

TEST(RunSize, ThoroughHasFurtherResolutionsAndOraclesAtEveryPixel) {
    const Folder folder;
    folder.write("two.gltf", two_triangles());
    const Ran ran = run(folder, {"run", "two.gltf", "--thorough"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    std::set<std::pair<int, int>> sizes;
    for (const json& view : views_of(folder)) {
        sizes.emplace(view.at("width").get<int>(), view.at("height").get<int>());
        ASSERT_EQ(view.at("oracles").size(), 2u);
        for (const json& oracle : view.at("oracles")) {
            EXPECT_EQ(oracle.at("absent"), "");
            EXPECT_EQ(oracle.at("defects"), 0);
            EXPECT_FALSE(oracle.contains("sample"));
        }
    }
    EXPECT_TRUE(sizes.contains({1920, 1080}) && sizes.contains({1, 1}));
    EXPECT_TRUE(
        std::ranges::any_of(sizes, [](auto size) { return size.first % 2 == 1 && size.second % 2 == 1; }));
    EXPECT_TRUE(std::ranges::any_of(sizes, [](auto size) { return size.first < size.second; }));
}

TEST(RunSize, FurtherResolutionsHaveNamesAndPlacesOfTheirOwnAndMeanTheSameScene) {
    const auto named = select_scenes({"room", "slivers"});
    const auto all = sources_for(RunSize::thorough, default_resolution, named);
    ASSERT_GT(all.size(), 4u);
    std::set<std::string> names;
    for (std::size_t i = 0; i < all.size(); ++i) {
        names.insert(all[i].name);
        EXPECT_EQ(all[i].place, i);
        EXPECT_EQ(word_for(all[i]), i < all.size() / 2 ? "room" : "slivers");
    }
    EXPECT_EQ(names.size(), all.size());
    EXPECT_TRUE(names.contains("room") && names.contains("room.1x1"));
    EXPECT_EQ(sources_for(RunSize::usual, default_resolution, named).size(), 2u);
}

TEST(RunSize, ASceneThatMakesRaysSlowHasASizeOfItsOwnUnlessOneIsNamed) {
    const auto size_of = [](RunSize size, Resolution resolution, const char* scene) {
        return sources_for(size, resolution, select_scenes({scene})).at(0).size;
    };
    EXPECT_EQ(size_of(RunSize::usual, default_resolution, "slivers"), (Resolution{960, 540}));
    EXPECT_EQ(size_of(RunSize::usual, {1280, 720}, "slivers"), std::nullopt);
    EXPECT_EQ(size_of(RunSize::quick, {480, 270}, "slivers"), std::nullopt);
    EXPECT_EQ(size_of(RunSize::thorough, default_resolution, "slivers"), std::nullopt);
    EXPECT_EQ(size_of(RunSize::usual, default_resolution, "room"), std::nullopt);
}

TEST(RunSize, AViewFileStatesItsResolutionAndStandsOnce) {
    const std::vector<SceneSource> named{{SceneSource::Kind::view_file, "v", "v.view.json", "", {}}};
    EXPECT_EQ(sources_for(RunSize::thorough, default_resolution, named).size(), 1u);
}

TEST(RunSize, TheTwoExcludeOneAnotherAndAResolutionOfOnesOwn) {
    const Folder folder;
    for (const Words& words :
         {Words{"run", "--quick", "--thorough"}, Words{"run", "--quick", "--width", "64"},
          Words{"run", "--thorough", "--height", "64"}}) {
        const Ran ran = run(folder, words);
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_NE(ran.err.find("excludes"), std::string::npos) << ran.err;
    }
}

}  // namespace
}  // namespace zproof::test
