#include "oracle/external.h"

#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "image_io/image_io.h"
#include "oracle/oracle_error.h"
#include "oracle/scratch_folder.h"
#include "scenes/gltf/gltf.h"

namespace zproof::oracle {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

Scene one_triangle() {
    Scene scene;
    scene.name = "../a name that no file can have";
    scene.vertices.position_world = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    scene.triangles = {{0, 1, 2}};
    scene.parts = {{.node = "n", .mesh = "m", .first_triangle = 0, .triangle_count = 1}};
    scene.materials = {{}};
    return scene;
}

View small_view() { return {.name = "v", .camera = {}, .width = 4, .height = 3}; }

/// A stored answer, for programs that only copy it.
class ExternalRenderer : public testing::Test {
  protected:
    ExternalRenderer() : answer_({4, 3}) {
        answer_.primitive.at(1, 2) = PrimitiveId{(1u << 24) + 1};
        answer_.camera_depth.at(1, 2) = 0.1f;
        write_frame(file("it's an answer.exr"), answer_);
    }

    std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
    std::string copy() const { return "cp " + folder_.path().string() + "/it*.exr {out}"; }
    Frame ask(const std::string& command) const {
        return External{scene_, command, 20s}.render(small_view());
    }
    std::string refusal(const std::string& command) const {
        try {
            ask(command);
        } catch (const OracleError& e) {
            return e.what();
        }
        return "nothing was refused";
    }

    ScratchFolder folder_;
    Scene scene_ = one_triangle();
    Frame answer_;
};

TEST_F(ExternalRenderer, AnswersBitForBit) {
    const Frame frame = ask(copy());
    EXPECT_EQ(frame.primitive.at(1, 2), PrimitiveId{(1u << 24) + 1});
    EXPECT_EQ(frame.camera_depth.at(1, 2), 0.1f);
    EXPECT_EQ(frame.primitive.at(0, 0), PrimitiveId::none);
}

TEST_F(ExternalRenderer, IsHandedSceneCameraAndSize) {
    const std::string seen = file("seen").string();
    ask("cp {scene} " + seen + ".glb && cp {camera} " + seen + ".json && echo {width}x{height} >" + seen +
        " && " + copy());
    const Scene back = load_gltf(seen + ".glb").scene;
    EXPECT_EQ(back.triangles, scene_.triangles);
    EXPECT_TRUE(std::ranges::equal(back.vertices.position_world, scene_.vertices.position_world));
    std::string size;
    std::getline(std::ifstream{seen} >> std::ws, size);
    EXPECT_EQ(size, "4x3");
    EXPECT_TRUE(std::filesystem::file_size(seen + ".json") > 0);
}

TEST_F(ExternalRenderer, WhatItIsHandedIsNotReadAsPlaceholders) {
    EXPECT_THAT(refusal("echo '{wid''th}' >&2; exit 1"), HasSubstr("it said: {width}"));
}

TEST_F(ExternalRenderer, AFailureIsToldInItsOwnWords) {
    EXPECT_THAT(refusal("echo out of memory >&2; exit 3; {out}"),
                testing::AllOf(HasSubstr("exit status 3"), HasSubstr("out of memory")));
    EXPECT_THAT(refusal("no-such-program {out}"), HasSubstr("exit status 127"));
    EXPECT_THAT(refusal("true {out}"), HasSubstr("{out}: no such file"));
    EXPECT_THAT(refusal("echo P6 >{out}"), HasSubstr("{out}: not a readable OpenEXR file"));
}

TEST_F(ExternalRenderer, IsStoppedAtItsTimeLimit) {
    const External slow{scene_, "sleep 600; {out}", 1s};
    EXPECT_THROW(
        try { slow.render(small_view()); } catch (const OracleError& e) {
            EXPECT_THAT(e.what(), HasSubstr("stopped at its time limit of 1"));
            throw;
        },
        OracleError);
}

TEST_F(ExternalRenderer, ARunThatWritesNothingDoesNotPassWithTheLastOnesFrame) {
    const std::string once = file("once").string();
    const External forgetful{scene_, "test -e " + once + " || " + copy() + "; touch " + once, 20s};
    EXPECT_EQ(forgetful.render(small_view()).primitive.at(1, 2), PrimitiveId{(1u << 24) + 1});
    EXPECT_THROW(forgetful.render(small_view()), OracleError);
}

TEST_F(ExternalRenderer, AFrameOfAnotherSizeIsRefused) {
    View larger = small_view();
    larger.width = 5;
    EXPECT_THROW(
        try { External(scene_, copy(), 20s).render(larger); } catch (const OracleError& e) {
            EXPECT_THAT(e.what(), HasSubstr("{out}: 4 x 3 pixels; the view 'v' has 5 x 3"));
            throw;
        },
        OracleError);
}

}  // namespace
}  // namespace zproof::oracle
