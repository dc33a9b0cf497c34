// zproof with --ids: frames without ids, and frames whose ids are materials or somebody's labels.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "image_io/image_io.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;

class FramesOfLabels : public testing::Test {
  protected:
    FramesOfLabels() {
        folder.write("two.gltf", two_triangles());
        EXPECT_EQ(
            run(folder, {"render", "two.gltf", "-o", "zproof", "--width", "64", "--height", "48"}).exit_code,
            0);
        good = read_frame(folder.path() / "zproof/frame-all.exr");
    }

    /// Depths alone: PFM has one channel, rows from the bottom.
    void write_depths(const std::string& name, const Frame& frame) const {
        std::ofstream out(folder.path() / name, std::ios::binary);
        out << "Pf\n64 48\n-1.0\n";
        for (int y = 47; y >= 0; --y) {
            const auto row = frame.camera_depth.row(y);
            out.write(reinterpret_cast<const char*>(row.data()), std::streamsize(row.size_bytes()));
        }
    }
    json results() const { return json::parse(folder.read("zproof-out/results.json")); }

    Folder folder;
    Frame good;
};

TEST_F(FramesOfLabels, WithoutIdsAreJudgedByDepthAlone) {
    write_depths("z.pfm", good);
    const Ran ran = run(folder, {"compare", "z.pfm", "two.gltf", "--ids", "none"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("1 view, depth only; report"), std::string::npos) << ran.out;
    EXPECT_EQ(results().at("run").at("renderers").at(0).at("ids"), "none");
    EXPECT_EQ(results().at("run").at("renderers").at(1).at("ids"), "triangle");
    EXPECT_NE(folder.read("zproof-out/report.html").find("depth only"), std::string::npos);
}

TEST_F(FramesOfLabels, WithoutIdsAreRefusedWhereIdsAreExpected) {
    write_depths("z.pfm", good);
    const Ran ran = run(folder, {"compare", "z.pfm", "two.gltf"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
    EXPECT_NE(ran.err.find("channel 'id' is missing"), std::string::npos) << ran.err;
}

TEST_F(FramesOfLabels, AWrongDepthFailsAndItsCommandExplainsIt) {
    good.camera_depth.at(32, 24) *= 1.01f;
    write_depths("z.pfm", good);
    const Ran ran = run(folder, {"compare", "z.pfm", "two.gltf", "--ids", "none"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    const json worst = results().at("views").at(0).at("worst").at(0);
    const std::string command = worst.at("command"), sentence = worst.at("explanation");
    EXPECT_NE(command.find("--ids none"), std::string::npos) << command;
    EXPECT_NE(sentence.find("; the frame has no ids"), std::string::npos) << sentence;
    const Ran told = run(folder, {"explain", "two.gltf", "32", "24", "--candidate", "z.pfm", "--ids", "none",
                                  "--width", "64", "--height", "48"});
    EXPECT_EQ(told.exit_code, 1) << told.out << told.err;
    EXPECT_NE(told.out.find("the frame has no ids"), std::string::npos) << told.out;
}

TEST_F(FramesOfLabels, FromAFileAreJudgedByIt) {
    for (PrimitiveId& id : good.primitive.pixels())
        if (id != PrimitiveId::none) id = PrimitiveId(std::uint32_t(id) == 0 ? 70 : 50);
    write_frame(folder.path() / "labels.exr", good);
    folder.write("labels.json", "[70, 50]");
    const Ran ran = run(folder, {"compare", "labels.exr", "two.gltf", "--ids", "labels.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_EQ(results().at("run").at("renderers").at(0).at("ids"), "labels.json");
    folder.write("labels.json", "[50, 70]");
    EXPECT_EQ(run(folder, {"compare", "labels.exr", "two.gltf", "--ids", "labels.json"}).exit_code, 1);
    folder.write("labels.json", "[50]");
    const Ran refused = run(folder, {"compare", "labels.exr", "two.gltf", "--ids", "labels.json"});
    EXPECT_EQ(refused.exit_code, 3) << refused.out << refused.err;
    EXPECT_NE((refused.out + refused.err).find("labels for 1 triangles; the scene has 2"), std::string::npos);
}

TEST_F(FramesOfLabels, OfRenderersThatZproofKnowsAreMadeFromTheirTriangles) {
    for (const std::string ids : {"none", "primitive", "node", "material", "cryptomatte-object"}) {
        const Ran ran = run(folder, {"run", "two.gltf", "--ids", ids, "--oracle", "none"});
        EXPECT_EQ(ran.exit_code, 0) << ids << ran.out << ran.err;
    }
}

TEST_F(FramesOfLabels, AWordThatIsNoneIsAUsageError) {
    const Ran ran = run(folder, {"run", "two.gltf", "--ids", "materials"});
    EXPECT_EQ(ran.exit_code, 2) << ran.out << ran.err;
    EXPECT_NE(ran.err.find("material"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace zproof::test
