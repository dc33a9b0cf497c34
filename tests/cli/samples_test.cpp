// Frames of samples on the real program: rendered, judged, explained and refused (docs/samples.md).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

const Words small{"--width", "64", "--height", "48"};
const std::string source = ZPROOF_SOURCE_DIR;

class Samples : public testing::Test {
  protected:
    Samples() { folder.write("two.gltf", two_triangles()); }

    Ran run_small(Words words) const {
        words.insert(words.end(), small.begin(), small.end());
        return run(folder, words);
    }
    void render(const std::string& sample) const {
        const Ran ran = run_small({"render", "two.gltf", "-o", "drawn", "--sample", sample});
        ASSERT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    }
    json views() const { return json::parse(folder.read("zproof-out/results.json")).at("views"); }

    Folder folder;
};

TEST_F(Samples, AreViewsOfTheirOwnInOneVerdict) {
    render("standard:4");
    const Ran ran = run(folder, {"compare", "drawn/frame-all.sample-{sample}.exr", "two.gltf", "--sample",
                                 "standard:4", "--oracle", "none"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    std::vector<std::string> names;
    for (const json& view : views()) names.push_back(view.at("view"));
    EXPECT_THAT(names, ElementsAre("frame-all.sample-0", "frame-all.sample-1", "frame-all.sample-2",
                                   "frame-all.sample-3"));
    EXPECT_EQ(views().at(1).at("notes").back(),
              "sampled beside the pixels' centres: sample 1 of 0 to 3, (0.375, -0.125) px, x right, y down");
}

TEST_F(Samples, OfAnotherPlaceHaveDefectsAndTheCommandExplainsOne) {
    render("standard:2");
    const auto path = folder.path() / "drawn";
    std::filesystem::rename(path / "frame-all.sample-0.exr", path / "1.exr");
    std::filesystem::rename(path / "frame-all.sample-1.exr", path / "0.exr");
    const Ran ran = run(
        folder, {"compare", "drawn/{sample}.exr", "two.gltf", "--sample", "standard:2", "--oracle", "none"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    const json worst = views().at(1).at("worst").at(0);
    EXPECT_THAT(worst.at("command").get<std::string>(),
                HasSubstr("--view frame-all --candidate drawn/1.exr --sample standard:2:1"));
    const Ran told = run_small({"explain", "two.gltf", std::to_string(worst.at("x").get<int>()),
                                std::to_string(worst.at("y").get<int>()), "--candidate", "drawn/1.exr",
                                "--sample", "standard:2:1"});
    EXPECT_EQ(told.exit_code, 1) << told.out << told.err;
    const Ran at_its_own = run_small({"explain", "two.gltf", std::to_string(worst.at("x").get<int>()),
                                      std::to_string(worst.at("y").get<int>()), "--candidate", "drawn/1.exr",
                                      "--sample", "standard:2:0"});
    EXPECT_EQ(at_its_own.exit_code, 0) << at_its_own.out << at_its_own.err;
}

TEST_F(Samples, MayBeOnePlace) {
    render("-0.125,0.375");
    const Words compare{"compare", "drawn/frame-all.at_-0.125_0.375.exr", "two.gltf", "--oracle", "none"};
    Words at_its_place = compare;
    at_its_place.insert(at_its_place.end(), {"--sample", "-0.125,0.375"});
    EXPECT_EQ(run(folder, at_its_place).exit_code, 0);
    EXPECT_EQ(views().at(0).at("view"), "frame-all.at_-0.125_0.375");
    EXPECT_EQ(run(folder, compare).exit_code, 1);
}

TEST_F(Samples, OfAProgramThatIsToldThePlaceInItsCamera) {
    const std::string program = "python3 '" + source + "/examples/zbuffer.py' {scene} {camera} {out}";
    const Words run_words{"run",         "two.gltf",
                          "--oracle",    "none",
                          "--sample",    "standard:16",
                          "--renderer",  program,
                          "--precision", "raster,transform=float64,interpolation=float64,depth_roundings=1"};
    const Ran ran = run_small(run_words);
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_EQ(views().size(), 16u);
}

TEST_F(Samples, OfAProgramThatIsToldThemInItsCommand) {
    const Ran ran = run_small({"run", "two.gltf", "--oracle", "none", "--sample", "standard:2", "--renderer",
                               "echo {sample} {sample_x} {sample_y} >> told; false {out}"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
    EXPECT_EQ(folder.read("told"), "0 0.25 0.25\n1 -0.25 -0.25\n");
}

TEST_F(Samples, AreNotAskedOfWhoSamplesCentresOnly) {
    const Ran ran = run_small({"run", "two.gltf", "--sample", "0.25,0.25", "--oracle", "opengl"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_THAT(views().at(0).at("oracles").at(0).at("absent").get<std::string>(),
                HasSubstr("samples pixels at their centres only"));
    const Ran as_candidate =
        run_small({"run", "two.gltf", "--sample", "0.25,0.25", "--oracle", "none", "--renderer", "povray"});
    EXPECT_EQ(as_candidate.exit_code, 3) << as_candidate.out << as_candidate.err;
}

TEST_F(Samples, ThatAreNoneAreRefused) {
    render("0,0");
    const auto refused = [&](const std::string& sample, const std::string& said) {
        const Ran ran = run(folder, {"compare", "drawn/frame-all.exr", "two.gltf", "--sample", sample});
        EXPECT_EQ(ran.exit_code, 2) << sample << ran.out << ran.err;
        EXPECT_THAT(ran.err, HasSubstr(said)) << sample;
        EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << ran.err;
    };
    refused("standard:17", "a standard pattern has 1, 2, 4, 8 or 16 samples");
    refused("standard:4:4", "expected the index of a sample, 0 to 3");
    refused("standard:4:x", "expected the index of a sample, 0 to 3");
    refused("0.5,0", "from -0.5 to below 0.5");
    refused("0,-0.75", "from -0.5 to below 0.5");
    refused("0.1,0", "a multiple of 1/256 px");
    refused("0,nan", "a multiple of 1/256 px");
    refused("centre", "expected DX,DY in pixels");
    refused("standard:4", "expected {sample} in its name");
    const Ran unsaid = run(folder, {"compare", "drawn/{sample}.exr", "two.gltf"});
    EXPECT_EQ(unsaid.exit_code, 2);
    EXPECT_THAT(unsaid.err, HasSubstr("expected --sample, e.g. --sample standard:4"));
    const Ran ran = run_small({"explain", "two.gltf", "1", "1", "--sample", "standard:4"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, HasSubstr("expected one, e.g. standard:4:0"));
}

}  // namespace
}  // namespace zproof::test
