// --evidence: which views leave frames, pictures and findings, on the real program.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;

namespace fs = std::filesystem;

/// The room, and its two views with a promise of far finer corners than the rasterizer snaps to.
const Words room{"run", "room", "--width", "96", "--height", "64", "--oracle", "opengl", "--config", "none"};
const Words broken_promise{"--precision", "raster,subpixel_bits=16", "--no-diagnosis"};
const Words of_all{"--evidence", "all"};

Words joined(const std::vector<Words>& parts) {
    Words words;
    for (const Words& part : parts) words.insert(words.end(), part.begin(), part.end());
    return words;
}

/// The views of results.json without what differs from run to run.
json views_in(const Folder& folder, const std::string& out) {
    json views = json::parse(folder.read(out + "/results.json")).at("views");
    for (json& view : views) view.erase("times");
    return views;
}

/// Every file below `out`, but those of the reports.
Words evidence_in(const Folder& folder, const std::string& out) {
    const fs::path root = folder.path() / out;
    Words files;
    if (!fs::exists(root / "scenes")) return files;
    for (const auto& entry : fs::recursive_directory_iterator(root / "scenes"))
        if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), root).string());
    std::ranges::sort(files);
    return files;
}

/// What the page shows of a view that leaves no frames.
const std::set<std::string> of_every_view{"findings.csv", "planes.zvp", "view.webp"};

TEST(Evidence, OfProvenViewsIsWhatThePageShowsAndTheVerdictStays) {
    const Folder folder;
    ASSERT_EQ(run(folder, joined({room, of_all, {"-o", "all"}})).exit_code, 0);
    const Ran ran = run(folder, joined({room, {"--pictures", "-o", "some"}}));
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_FALSE(evidence_in(folder, "all").empty());
    const Words files = evidence_in(folder, "some");
    EXPECT_EQ(files.size(), 2 * of_every_view.size()) << "of both views of the room";
    for (const std::string& file : files) {
        EXPECT_EQ(of_every_view.count(fs::path(file).filename()), 1u) << file;
        if (fs::path(file).filename() == "planes.zvp") continue;  // which holds less
        EXPECT_EQ(folder.read("some/" + file), folder.read("all/" + file)) << file;
    }
    const json all = views_in(folder, "all"), some = views_in(folder, "some");
    ASSERT_EQ(all.size(), some.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(some[i].at("folder"), all[i].at("folder"));
        EXPECT_EQ(some[i].at("worst"), json::array());
        for (const char* same :
             {"outcome", "counts", "candidate_edges", "reference_edges", "oracles", "id_agreement",
              "adjudicated", "reference_defects", "scene_sha256", "candidate_depth", "reference_depth"})
            EXPECT_EQ(some[i].at(same), all[i].at(same)) << same;
        EXPECT_TRUE(some[i].at("candidate_depth").contains("histogram"));
    }
    EXPECT_NE(folder.read("some/report.html").find("were not kept"), std::string::npos);
    EXPECT_NE(folder.read("some/report.html").find("Depth error / bound, candidate"), std::string::npos);
    EXPECT_EQ(folder.read("all/report.html").find("were not kept"), std::string::npos);
}

TEST(Evidence, OfProvenViewsNeedsNoImageModule) {
    const Folder folder;
    const Ran ran = run(folder, joined({room, {"-o", "out"}}), {"ZPROOF_IMAGE_IO=/no/such/module.so"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_EQ(evidence_in(folder, "out").size(), 2 * of_every_view.size());
}

TEST(Evidence, OfViewsWithDefectsIsWhatEveryViewLeaves) {
    const Folder folder;
    ASSERT_EQ(run(folder, joined({room, broken_promise, of_all, {"-o", "all"}})).exit_code, 1);
    ASSERT_EQ(run(folder, joined({room, broken_promise, {"-o", "some"}})).exit_code, 1);
    EXPECT_EQ(views_in(folder, "some"), views_in(folder, "all"));
    const Words files = evidence_in(folder, "all");
    EXPECT_EQ(evidence_in(folder, "some"), files);
    for (const std::string& file : files)
        EXPECT_EQ(folder.read("some/" + file), folder.read("all/" + file)) << file;
}

TEST(Evidence, OfWhichViewsIsAWordOfTwo) {
    const Folder folder;
    const Ran ran = run(folder, joined({room, {"--evidence", "failing"}}));
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("--evidence"), std::string::npos) << ran.err;
    EXPECT_EQ(folder.names(), Words{});
}

}  // namespace
}  // namespace zproof::test
