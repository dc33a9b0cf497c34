// Frames in conventions other than the contract's, on the real program.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "image_io/image_io.h"
#include "tests/cli/program.h"
#include "tests/image_io/npy.h"

namespace zproof::test {
namespace {

using nlohmann::json;

const std::string source = ZPROOF_SOURCE_DIR;
const std::string declared = "raster,transform=float64,interpolation=float64,depth_roundings=1";

std::string faulty(const std::string& fault) {
    return "python3 '" + source + "/tests/cli/faulty_renderer.py' " + fault + " {scene} {camera} {out}";
}

TEST(Convention, WhatTheContractForbidsMayBeDeclared) {
    const Folder folder;
    for (const auto& [fault, convention] :
         {std::pair{"flipped_in_y", "rows=bottom_first"}, std::pair{"ids_from_one", "id_base=1"}}) {
        const Ran ran = run(
            folder, {"contract-check", faulty(fault), "--precision", declared, "--convention", convention});
        EXPECT_EQ(ran.exit_code, 0) << fault << ran.out << ran.err;
    }
}

TEST(Convention, ADepthAlongTheRayCostsItsRoundings) {
    const Folder folder;
    const auto exit_code_of = [&](const std::string& precision, const std::string& convention) {
        return run(folder,
                   {"run", "off_axis", "--renderer", faulty("depth_is_ray_length"), "--oracle", "none",
                    "--width", "64", "--height", "48", "--precision", precision, "--convention", convention})
            .exit_code;
    };
    EXPECT_EQ(exit_code_of("raster,transform=float64,interpolation=float64,depth_roundings=2",
                           "depth_kind=ray_length"),
              0);
    EXPECT_EQ(exit_code_of(declared, "depth_scale=1.0000001"), 1);
}

/// zproof's own frame, as PyTorch3D would have written it.
class Arrays : public testing::Test {
  protected:
    Arrays() {
        folder.write("two.gltf", two_triangles());
        EXPECT_EQ(
            run(folder, {"render", "two.gltf", "-o", "zproof", "--width", "64", "--height", "48"}).exit_code,
            0);
        const Frame frame = read_frame(folder.path() / "zproof/frame-all.exr");
        std::vector<std::int64_t> ids;
        std::vector<float> depths;
        for (const PrimitiveId id : frame.primitive.pixels())
            ids.push_back(id == PrimitiveId::none ? -1 : std::int64_t(id));
        for (const float depth : frame.camera_depth.pixels())
            depths.push_back(depth == background_depth ? -1 : depth);
        write_npy(folder.path() / "id.npy", "<i8", "1, 48, 64, 1", ids);
        write_npy(folder.path() / "z.npy", "<f4", "1, 48, 64, 1", depths);
        ids[24 * 64 + 32] = 1 - ids[24 * 64 + 32];
        write_npy(folder.path() / "spoilt.npy", "<i8", "48, 64", ids);
    }

    Folder folder;
};

TEST_F(Arrays, AreJudgedInTheConventionThatIsNamed) {
    const Ran ran = run(folder, {"compare", "id.npy+z.npy", "two.gltf", "--convention", "pytorch3d"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    const Ran other =
        run(folder, {"compare", "id.npy+z.npy", "two.gltf", "--convention", "pytorch3d,depth_background=0"});
    EXPECT_EQ(other.exit_code, 1) << other.out << other.err;
    const Ran none = run(folder, {"compare", "id.npy+z.npy", "two.gltf"});
    EXPECT_EQ(none.exit_code, 3) << none.out << none.err;
}

TEST_F(Arrays, TheCommandOfADefectNamesItsConvention) {
    const Ran ran =
        run(folder, {"compare", "spoilt.npy+z.npy", "id.npy+z.npy", "--scene", "two.gltf", "--convention",
                     "pytorch3d", "--channels", "depth=0", "--reference-convention", "pytorch3d"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    const json results = json::parse(folder.read("zproof-out/results.json"));
    const std::string command = results.at("views").at(0).at("worst").at(0).at("command");
    EXPECT_NE(command.find("--convention pytorch3d --channels depth=0"), std::string::npos) << command;
    EXPECT_NE(command.find("--reference-convention pytorch3d"), std::string::npos) << command;
    const Ran told = run(folder, {"explain", "two.gltf", "32", "24", "--candidate", "spoilt.npy+z.npy",
                                  "--convention", "pytorch3d", "--width", "64", "--height", "48"});
    EXPECT_EQ(told.exit_code, 1) << told.out << told.err;
}

TEST_F(Arrays, AProgramMayWriteTwoFiles) {
    const std::string here = folder.path().string();
    const auto with = [&](const std::string& command) {
        return run(folder, {"run", "two.gltf", "--renderer", command, "--oracle", "none", "--width", "64",
                            "--height", "48", "--convention", "pytorch3d"});
    };
    const Ran two = with("cp " + here + "/id.npy {out}.id.npy; cp " + here + "/z.npy {out}.depth.npy");
    EXPECT_EQ(two.exit_code, 0) << two.out << two.err;
    const Ran one = with("cp " + here + "/z.npy {out}.npy");
    EXPECT_EQ(one.exit_code, 3) << one.out << one.err;
    EXPECT_NE(one.err.find("'0' is of type float; expected an integer"), std::string::npos) << one.err;
}

/// zproof's own frame, as BOP stores it: ids from 1, depths as a whole number of steps.
class StepsOfDepth : public Arrays {
  protected:
    static constexpr double step = 0.004;

    void write_steps(const std::string& name, const std::function<double(double)>& whole) {
        const Frame frame = read_frame(folder.path() / "zproof/frame-all.exr");
        std::vector<std::uint16_t> ids, steps;
        for (const PrimitiveId id : frame.primitive.pixels())
            ids.push_back(std::uint16_t(id == PrimitiveId::none ? 0 : std::uint32_t(id) + 1));
        for (const float depth : frame.camera_depth.pixels())
            steps.push_back(std::uint16_t(depth == background_depth ? 0 : whole(double(depth) / step)));
        write_npy(folder.path() / "ids.npy", "<u2", "48, 64", ids);
        write_npy(folder.path() / name, "<u2", "48, 64", steps);
    }

    Ran judged(const std::string& depths, const std::string& convention) const {
        return run(folder, {"compare", "ids.npy+" + depths, "two.gltf", "--oracle", "none", "--convention",
                            "id_channel=0,depth_channel=0,id_background=0,id_base=1,depth_background=0,"
                            "depth_scale=0.004" +
                                convention});
    }
};

TEST_F(StepsOfDepth, ArePartOfThePromiseWhereTheConventionSaysWholeNumbers) {
    write_steps("rounded.npy", [](double steps) { return std::nearbyint(steps); });
    write_steps("cut.npy", [](double steps) { return std::floor(steps); });
    const Ran rounded = judged("rounded.npy", ",depth_coding=integer");
    EXPECT_EQ(rounded.exit_code, 0) << rounded.out << rounded.err;
    EXPECT_EQ(judged("rounded.npy", "").exit_code, 1);
    EXPECT_EQ(judged("cut.npy", ",depth_coding=integer").exit_code, 1);
    const json results = json::parse(folder.read("zproof-out/results.json"));
    EXPECT_EQ(results.at("run").at("renderers").at(0).at("precision").at("depth_step"), step);
}

TEST_F(StepsOfDepth, AreNotThoseOfFloatsNorOfAnotherKindOfDepth) {
    write_steps("rounded.npy", [](double steps) { return std::nearbyint(steps); });
    const Ran floats = judged("z.npy", ",depth_coding=integer");
    EXPECT_EQ(floats.exit_code, 3);
    EXPECT_NE(floats.err.find("of type float; expected an integer of up to 32 bits"), std::string::npos)
        << floats.err;
    const Ran inverse = judged("rounded.npy", ",depth_coding=integer,depth_kind=inverse");
    EXPECT_EQ(inverse.exit_code, 2);
    EXPECT_NE(inverse.err.find("/depth_coding"), std::string::npos) << inverse.err;
}

TEST_F(Arrays, WhatIsNotUnderstoodIsRefusedBeforeAnythingIsWritten) {
    for (const auto& [convention, status] :
         {std::pair{"pytorch", 2}, std::pair{"depth_kind=z", 2}, std::pair{"none.json", 3}}) {
        const Ran ran =
            run(folder, {"run", "two.gltf", "--renderer", "cp a {out}", "--convention", convention});
        EXPECT_EQ(ran.exit_code, status) << ran.out << ran.err;
    }
    EXPECT_EQ(std::ranges::count(folder.names(), "zproof-out"), 0);
    EXPECT_EQ(run(folder, {"run", "two.gltf", "--convention", "bop"}).exit_code, 2);
}

TEST(Views, OfColmapAreJudged) {
    const Folder folder;
    folder.write("two.gltf", two_triangles());
    folder.write("sparse/cameras.txt", "1 PINHOLE 64 48 50 50 32 24\n");
    folder.write("sparse/images.txt", "1 0 1 0 0 0 0 3 1 a.png\n\n");  // looks along -z, from z = 3
    const Ran ran =
        run(folder, {"views", "colmap", "sparse", "two.gltf", "--near", "0.1", "-o", "two.view.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    const Ran judged = run(folder, {"run", "two.view.json", "--oracle", "none"});
    EXPECT_EQ(judged.exit_code, 0) << judged.out << judged.err;
    const json view = json::parse(folder.read("zproof-out/results.json")).at("views").at(0);
    EXPECT_EQ(view.at("view"), "a");
    EXPECT_GT(view.at("counts").at("agree"), 0);
}

}  // namespace
}  // namespace zproof::test
