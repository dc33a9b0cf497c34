// POV-Ray as an oracle: against the triangle-by-triangle caster where they must agree, and with programs in
// its place that do not do as they are told. POV-Ray must be installed: without it these tests fail.
#include "oracle/povray.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "image_io/image_io.h"
#include "oracle/embree.h"
#include "oracle/oracle_error.h"
#include "oracle/povray/scene.h"
#include "oracle/scratch_folder.h"
#include "scenes/suite.h"
#include "scenes_at_random.h"

namespace zproof::oracle {
namespace {

using testing::HasSubstr;

View small_view(Projection projection = Projection::perspective) {
    View view{.name = "small", .camera = {}, .width = 32, .height = 24};
    view.camera.projection = projection;
    view.camera.near_depth = 0.5;
    view.camera.far_depth = 100;
    return view;
}

/// Fills the image at camera depth `depth` and beyond its sides.
Scene wall_at(float depth) {
    return scene_of({{-900, -900, -depth}, {900, -900, -depth}, {0, 1800, -depth}});
}

std::size_t count(const Frame& frame, PrimitiveId id) {
    return std::size_t(std::ranges::count(frame.primitive.pixels(), id));
}

TEST(PovRay, NamesItsVersion) {
    const auto version = povray_version();
    ASSERT_TRUE(version.has_value()) << "POV-Ray is not installed";
    EXPECT_THAT(*version, testing::StartsWith("POV-Ray 3.7"));
    EXPECT_FALSE(povray_version("no-such-program").has_value());
}

TEST(PovRay, AWallHasItsDepthToARoundingEverywhere) {
    for (const float depth : {0.51f, 3.1415927f, 99.9f}) {
        const Scene scene = wall_at(depth);
        const Frame frame = PovRay(scene).render(small_view());
        ASSERT_EQ(count(frame, PrimitiveId{0}), 32u * 24);
        for (const float z : frame.camera_depth.pixels()) ASSERT_NEAR(z / depth, 1, 0x1p-22);
    }
}

TEST(PovRay, WhatLiesOutsideNearAndFarIsNotSeen) {
    for (const float depth : {0.49f, 100.5f}) {
        const Scene scene = wall_at(depth);
        EXPECT_EQ(count(PovRay(scene).render(small_view()), PrimitiveId::none), 32u * 24);
    }
}

/// The floor goes from behind the eye to beyond far: rows between the images of near and far see it.
TEST(PovRay, NearAndFarCutATriangle) {
    const Scene scene = scene_of({{-4000, -1, 900}, {4000, -1, 900}, {0, -1, -2000}});
    View view = small_view();
    view.camera.near_depth = 2;
    view.camera.far_depth = 6;
    const Frame frame = PovRay(scene).render(view);
    for (int y = 0; y < 24; ++y) {
        const double depth = 1 / ((y + 0.5) / 12 - 1);  // where the row's rays meet the floor
        const bool seen = depth > 2 && depth < 6;
        EXPECT_EQ(frame.primitive.at(16, y), seen ? PrimitiveId{0} : PrimitiveId::none) << "row " << y;
    }
}

/// Ids need more than 16 bits here; the one in front is the last.
TEST(PovRay, IdsBeyond16BitsComeBackWhole) {
    Scene scene = wall_at(5);
    scene.triangles.resize(70'000, {0, 0, 0});
    scene.triangles.back() = {0, 1, 2};
    scene.triangles.front() = {0, 0, 0};
    const Frame frame = PovRay(scene).render(small_view());
    EXPECT_EQ(count(frame, PrimitiveId{69'999}), 32u * 24);
    EXPECT_NEAR(frame.camera_depth.at(3, 3), 5, 5 * 0x1p-22);
}

/// A sheet of squares whose corners are the pixels' centres, to a rounding of float32, and beyond the image.
Scene sheet_through_pixel_centres(const View& view, double depth) {
    const Window& w = view.camera.window;
    const auto corner = [&](int x, int y) {
        const double u = w.left + (w.right - w.left) * (x + 0.5) / view.width;
        const double v = w.top - (w.top - w.bottom) * (y + 0.5) / view.height;
        const double size = view.camera.projection == Projection::perspective ? depth : 1;
        return glm::vec3(glm::dvec3(size * u, size * v, -depth));
    };
    std::vector<glm::vec3> corners;
    for (int y = -1; y < view.height; ++y)
        for (int x = -1; x < view.width; ++x) {
            const glm::vec3 a = corner(x, y), b = corner(x + 1, y), c = corner(x + 1, y + 1),
                            d = corner(x, y + 1);
            corners.insert(corners.end(), {a, b, c, a, c, d});
        }
    return scene_of(corners);
}

/// POV-Ray's boxes are float32 and its triangles are asked one by one: both would let rays through here.
TEST(PovRay, NoRaySlipsBetweenTrianglesThatShareAnEdge) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        View view = small_view(projection);
        view.width = view.height = 96;
        view.camera.window = {-0.7, 0.9, -0.6, 1.1};
        const Scene scene = sheet_through_pixel_centres(view, 3.3);
        EXPECT_EQ(count(PovRay(scene).render(view), PrimitiveId::none), 0u);
    }
}

/// An edge that leads exactly through a pixel's centre, in a scene of the suite.
TEST(PovRay, NoRaySlipsThroughTheMosaic) {
    const Loaded mosaic = generate_suite_scene("shared_edges", 480, 270);
    const Frame reference = Embree(mosaic.scene).trace(mosaic.views.at(0));
    EXPECT_EQ(count(PovRay(mosaic.scene).render(mosaic.views.at(0)), PrimitiveId::none),
              count(reference, PrimitiveId::none));
}

TEST(PovRay, AnEmptySceneIsBackground) {
    const Scene scene = scene_of(std::vector<glm::vec3>{});
    EXPECT_EQ(count(PovRay(scene).render(small_view()), PrimitiveId::none), 32u * 24);
}

/// A program in POV-Ray's place: a shell script of these lines.
class FakeProgram {
  public:
    explicit FakeProgram(const std::string& lines) {
        std::ofstream(path()) << "#!/bin/sh\n" << lines << "\n";
        std::filesystem::permissions(path(), std::filesystem::perms::owner_all);
    }
    std::string path() const { return scratch_.path() / "povray"; }
    std::string folder() const { return scratch_.path(); }

  private:
    ScratchFolder scratch_;
};

/// What PovRay says of a program that is none, and that its scratch folder is gone. The fake program notes
/// the folder in which it was run.
std::string complaint_about(const std::string& lines,
                            std::chrono::milliseconds limit = std::chrono::minutes(1)) {
    const FakeProgram fake_program("pwd > \"$(dirname \"$0\")/where\"\n" + lines);
    const Scene scene = wall_at(5);
    std::string complaint = "nothing was thrown";
    try {
        PovRay(scene, {.program = fake_program.path(), .time_limit = limit}).render(small_view());
    } catch (const OracleError& error) {
        complaint = error.what();
    }
    std::string folder;
    std::getline(std::ifstream(fake_program.folder() + "/where"), folder);
    EXPECT_THAT(folder, HasSubstr("zproof-"));
    EXPECT_FALSE(std::filesystem::exists(folder)) << folder;
    return complaint;
}

TEST(PovRayTrouble, AFailureShowsWhatTheProgramSaid) {
    const std::string said = complaint_about("echo 'Parse Error: no such thing' >&2; exit 3");
    EXPECT_THAT(said, HasSubstr("view 'small'"));
    EXPECT_THAT(said, HasSubstr("exit status 3"));
    EXPECT_THAT(said, HasSubstr("Parse Error: no such thing"));
}

TEST(PovRayTrouble, AHangEndsAtTheTimeLimit) {
    EXPECT_THAT(complaint_about("sleep 1000", std::chrono::milliseconds(300)),
                HasSubstr("time limit of 0.3 s"));
}

TEST(PovRayTrouble, APictureThatIsMissingOrWrongIsNamed) {
    const ScratchFolder stored;
    const auto copied = [&](Resolution size, std::size_t bytes_left_out) {
        const std::vector<std::byte> png = encode_png(Plane<Rgb16>(size, {65535, 65535, 65535}));
        const std::string text(reinterpret_cast<const char*>(png.data()), png.size() - bytes_left_out);
        stored.write("stored.png", text);
        return "cp " + (stored.path() / "stored.png").string() + " picture.png";
    };
    EXPECT_THAT(complaint_about("exit 0"), HasSubstr("picture.png: no such file"));
    EXPECT_THAT(complaint_about(copied({32, 25}, 0)), HasSubstr("expected 3 of uint16, 32 x 24"));
    EXPECT_THAT(complaint_about(copied({32, 24}, 30)), HasSubstr("cannot be read"));
    EXPECT_THAT(complaint_about(copied({32, 24}, 0)), HasSubstr("there is no triangle"));
}

TEST(PovRayTrouble, AMissingProgramIsNamed) {
    const Scene scene = wall_at(5);
    EXPECT_THROW(PovRay(scene, {.program = "no-such-povray"}).render(small_view()), OracleError);
}

TEST(PovRayTrouble, ViewsBeyondItsMeansAreRefusedWithTheReason) {
    const Scene scene = scene_of({{-1, -1, 1}, {1, -1, 1}, {0, 0, -1e30f}});
    View view = small_view();
    view.camera.near_depth = 1e-9;
    view.camera.far_depth = std::numeric_limits<double>::infinity();
    EXPECT_THROW(povray_scene(scene, view), OracleError);
}

}  // namespace
}  // namespace zproof::oracle
