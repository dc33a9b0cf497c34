// The renderer contract from both sides: the examples keep it, and each way of breaking it is told in words.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

const std::string source = ZPROOF_SOURCE_DIR;
const std::string declared = "raster,transform=float64,interpolation=float64,depth_roundings=1";

std::string faulty(const std::string& fault) {
    return "python3 '" + source + "/tests/cli/faulty_renderer.py' " + fault + " {scene} {camera} {out}";
}

Ran checked(const Folder& folder, const std::string& command) {
    return run(folder, {"contract-check", command, "--precision", declared});
}

TEST(Contract, ThePythonExampleIsProvenOnThreeScenes) {
    const Folder folder;
    const Ran ran = checked(
        folder, "python3 '" + source + "/examples/zbuffer.py' {scene} {camera} {width} {height} {out}");
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    for (const char* scene : {"room/", "off_axis/", "oblique/"})
        EXPECT_NE(ran.out.find(scene), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("The contract is kept."), std::string::npos) << ran.out;
}

TEST(Contract, TheCppExampleIsProvenInBothProjections) {
    const Folder folder;
    const Ran ran = run(folder, {"run", "guard_band", "oblique", "--width", "40", "--height", "24",
                                 "--oracle", "none", "--precision", "ray,arithmetic=float64", "--renderer",
                                 "'" ZPROOF_CASTER "' {scene} {camera} {width} {height} {out}"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
}

TEST(Contract, ThePythonModuleRefusesIdsOfAnotherType) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    folder.write("float_ids.py",
                 "import sys\nfrom array import array\nsys.path.insert(0, '" + source +
                     "/examples/contract')\nimport zproof_contract as contract\n"
                     "def render(triangles, camera):\n"
                     "    frame = contract.Frame(camera.width, camera.height)\n"
                     "    frame.id = array('f', frame.id)\n    return frame\ncontract.main(render)\n");
    const Ran ran = run(folder, {"run", "one.gltf", "--width", "8", "--height", "6", "--oracle", "none",
                                 "--renderer", "python3 float_ids.py {scene} {camera} {out}"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("expected 8 x 6 values of type uint32"), std::string::npos) << ran.out;
}

TEST(Contract, NamesThePromiseWhereAFrameIsWrongAndNothingWasPromised) {
    const Folder folder;
    const Ran ran = run(folder, {"contract-check", faulty("ids_from_one")});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.out.find("--precision opengl or another (docs/presets.md)"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("likely cause: "), std::string::npos) << ran.out;
}

/// A frame that keeps the form of the contract and not its meaning.
struct WrongFrame {
    const char* fault;
    const char* said;
};

void PrintTo(const WrongFrame& c, std::ostream* out) { *out << c.fault; }

class WrongFrames : public testing::TestWithParam<WrongFrame> {};

TEST_P(WrongFrames, AreDiagnosedInWords) {
    const Folder folder;
    const Ran ran = run(folder, {"run", "room", "-x", "--width", "160", "--height", "100", "--oracle", "none",
                                 "--precision", declared, "--renderer", faulty(GetParam().fault)});
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    EXPECT_NE(ran.out.find(std::string{"likely cause: "} + GetParam().said), std::string::npos) << ran.out;
}

INSTANTIATE_TEST_SUITE_P(Contract, WrongFrames,
                         testing::Values(WrongFrame{"flipped_in_y", "the image is flipped in y"},
                                         WrongFrame{"ids_from_one", "ids are too large by one"},
                                         WrongFrame{"depth_is_ndc_z", "depth is NDC z"},
                                         WrongFrame{"depth_is_ray_length", "depth is the ray's length"},
                                         WrongFrame{"one_nan", "depth is not a number"}),
                         [](const auto& c) { return std::string{c.param.fault}; });

TEST(Contract, WhatLiesBehindTheEyeIsAskedForAndToldWhereItIsMissing) {
    const Folder folder;
    const std::string command = faulty("nothing_behind_the_eye");
    const Ran ran = checked(folder, command);
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("near lies behind the eye of this parallel view"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("\"nothing_behind_the_eye\": true"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("8 pictures: 1 wrong, 0 missing."), std::string::npos) << ran.out;
    const Ran declaring =
        run(folder, {"contract-check", command, "--precision", declared + ",nothing_behind_the_eye=true"});
    EXPECT_EQ(declaring.exit_code, 0) << declaring.out << declaring.err;
}

/// No frame at all.
struct NoFrame {
    const char* fault;
    const char* said;
};

void PrintTo(const NoFrame& c, std::ostream* out) { *out << c.fault; }

class NoFrames : public testing::TestWithParam<NoFrame> {
  protected:
    NoFrames() { folder.write("one.gltf", one_triangle()); }
    Folder folder;
};

TEST_P(NoFrames, EndARunWithStatus3AndWords) {
    const Ran ran = run(folder, {"run", "one.gltf", "--width", "16", "--height", "12", "--oracle", "none",
                                 "--renderer", faulty(GetParam().fault), "--time-limit", "5"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
    EXPECT_NE(ran.out.find(GetParam().said), std::string::npos) << ran.out;
    const auto view = nlohmann::json::parse(folder.read("zproof-out/results.json")).at("views").at(0);
    EXPECT_EQ(view.at("outcome"), "unreadable");
    EXPECT_NE(view.at("message").get<std::string>().find(GetParam().said), std::string::npos) << view.dump();
}

INSTANTIATE_TEST_SUITE_P(
    Contract, NoFrames,
    testing::Values(NoFrame{"exits_with_status_7", "exit status 7; it said: no licence"},
                    NoFrame{"crashes", "it said: Aborted"}, NoFrame{"never_ends", "time limit of 5"},
                    NoFrame{"writes_nothing", "{out}: no such file"},
                    NoFrame{"writes_no_exr", "{out}: not a readable OpenEXR file"},
                    NoFrame{"writes_half_a_file", "{out}: channel 'id' cannot be read"},
                    NoFrame{"another_size", "{out}: 17 x 12 pixels; the view '"},
                    NoFrame{"ids_are_float", "{out}: channel 'id' is of type float; expected uint"},
                    NoFrame{"depths_are_uint", "{out}: channel 'Z' is of type uint; expected float"},
                    NoFrame{"no_id_channel", "{out}: channel 'id' is missing; the file holds Z, ix"},
                    NoFrame{"no_depth_channel", "{out}: channel 'Z' is missing; the file holds Y, id"}),
    [](const auto& c) { return std::string{c.param.fault}; });

TEST(Contract, AMissingAnswerIsNotAWrongOne) {
    const Folder folder;
    const Ran ran = run(folder, {"contract-check", "true {out}"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out;
    EXPECT_NE(ran.out.find("8 missing"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace zproof::test
