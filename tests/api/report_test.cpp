// A verdict's report is the program's.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "frame/whole_file.h"
#include "reports/json.h"
#include "tests/support/test_folder.h"
#include "zproof/zproof.h"

namespace zproof::api {
namespace {

namespace fs = std::filesystem;

class ApiReport : public testing::Test {
  protected:
    ApiReport() {
        setenv("ZPROOF_PROGRAM", ZPROOF_PROGRAM_FILE, 1);
        fs::remove_all(folder);
        fs::create_directories(folder);
        id[4000] = background_id, depth[4000] = INFINITY;
        id[7000] = 3;
    }

    Verdict verdict(const std::string& ids = "triangle") const {
        return judge(
            scene, view,
            {.id = id, .depth = depth, .precision = "raster,transform=float64,subpixel_bits=8", .ids = ids});
    }
    static Results results_in(const fs::path& report) {
        return results_from_json(content_of(report / "results.json"));
    }

    const TestFolder own_folder;
    const fs::path folder = own_folder.path();
    const Scene scene = Scene::load("room", {160, 90});
    const View view = scene.views().front();
    const Frame ours = render(scene, view);
    std::vector<std::uint32_t> id{ours.id().begin(), ours.id().end()};
    std::vector<float> depth{ours.depth().begin(), ours.depth().end()};
};

/// The program is told a promise that says nothing of depths.
TEST_F(ApiReport, OfIdsAloneSaysWhatTheVerdictSays) {
    const Verdict said =
        judge(scene, view, {.id = ours.id(), .precision = "bounded,eps_px=0.01,depth_relative=0"});
    EXPECT_TRUE(said.is_proven());
    save(said, (folder / "report").string());
    EXPECT_TRUE(std::ranges::equal(results_in(folder / "report").views[0].counts, said.counts()));
}

TEST_F(ApiReport, SaysWhatTheVerdictSays) {
    const Verdict said = verdict();
    save(said, (folder / "report/").string());
    EXPECT_TRUE(fs::exists(folder / "report/report.html"));
    const Results results = results_in(folder / "report");
    ASSERT_EQ(results.views.size(), 1u);
    EXPECT_EQ(results.views[0].scene, "room");
    EXPECT_EQ(results.views[0].view, view.name());
    EXPECT_TRUE(std::ranges::equal(results.views[0].counts, said.counts()));
    ASSERT_FALSE(results.views[0].worst.empty());
    EXPECT_EQ(results.views[0].worst[0].finding.x, said.worst()->x);
    EXPECT_EQ(results.views[0].worst[0].finding.y, said.worst()->y);
    EXPECT_TRUE(fs::exists(folder / "report-input/room.view.json"));
}

TEST_F(ApiReport, OfLabelsAndOfIdsAloneAndOfDepthAlone) {
    const Candidate depths{.depth = depth, .precision = "raster"}, ids{.id = id, .precision = "raster"};
    const std::vector<std::uint32_t> labels(id.size(), 0);
    const Candidate labelled{.id = labels, .depth = depth, .precision = "raster", .ids = "node"};
    int number = 0;
    for (const Candidate& candidate : {depths, ids, labelled}) {
        const Verdict said = judge(scene, view, candidate);
        const fs::path report = folder / std::to_string(number++);
        save(said, report.string());
        EXPECT_TRUE(std::ranges::equal(results_in(report).views[0].counts, said.counts())) << report;
    }
}

TEST_F(ApiReport, OfManyNamesEach) {
    const std::vector<NamedVerdict> many{{"first", verdict()}, {"second", verdict()}};
    save(many, (folder / "all").string());
    const Results results = results_in(folder / "all");
    ASSERT_EQ(results.views.size(), 2u);
    EXPECT_EQ(results.views[0].scene, "first");
    EXPECT_EQ(results.views[1].scene, "second");
    EXPECT_NE(content_of(folder / "all/report.html").find("second"), std::string::npos);
    EXPECT_TRUE(fs::exists(folder / "all/junit.xml"));
    EXPECT_THROW(save(std::span<const NamedVerdict>{}, (folder / "none").string()), InputError);
}

TEST_F(ApiReport, ANameThatIsNoFilesIsRefusedBeforeAnythingIsWritten) {
    for (const char* name : {"../first", "a/b", "", ".", "first-input"}) {
        const std::vector<NamedVerdict> named{{name, verdict()}};
        EXPECT_THROW(save(named, (folder / "all").string()), InputError) << name;
    }
    const std::vector<NamedVerdict> twice{{"first", verdict()}, {"first", verdict()}};
    EXPECT_THROW(save(twice, (folder / "all").string()), InputError);
    EXPECT_THROW(save(verdict(), ""), InputError);
    EXPECT_THROW(save(verdict(), (folder / "one").string(), "../x"), InputError);
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(ApiReport, HeedsNoSettingsOfOtherRuns) {
    setenv("ZPROOF_REQUIRE", "opengl", 1);
    setenv("ZPROOF_WAIVERS", "/nowhere.toml", 1);
    save(verdict(), (folder / "report").string(), "mine");
    unsetenv("ZPROOF_REQUIRE");
    unsetenv("ZPROOF_WAIVERS");
    EXPECT_EQ(results_in(folder / "report").views[0].scene, "mine");
}

TEST_F(ApiReport, NeverReplacesSomebodysFolder) {
    std::ofstream{folder / "thesis.tex"} << "years of work";
    EXPECT_THROW(save(verdict(), folder.string()), std::runtime_error);
    EXPECT_EQ(content_of(folder / "thesis.tex"), "years of work");
    EXPECT_FALSE(fs::exists(folder / "report.html"));
    fs::create_directories(folder / "own-input");
    std::ofstream{folder / "own-input/room.glb"} << "another room";
    EXPECT_THROW(save(verdict(), (folder / "own").string()), std::runtime_error);
    EXPECT_EQ(content_of(folder / "own-input/room.glb"), "another room");
    fs::remove_all(folder.string() + "-input");
}

TEST_F(ApiReport, WithoutTheProgramSaysWhatIsMissing) {
    setenv("ZPROOF_PROGRAM", "/nowhere/zproof", 1);
    try {
        save(verdict(), (folder / "report").string());
        ADD_FAILURE() << "it was saved";
    } catch (const std::runtime_error& e) {
        EXPECT_NE(std::string(e.what()).find("/nowhere/zproof"), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace zproof::api
