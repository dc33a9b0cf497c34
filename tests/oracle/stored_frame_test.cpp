// Depths of every kind against what the camera file's matrices and the rays of scenes/camera.h say.
#include "oracle/convention/stored_frame.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "frame/convention_text.h"
#include "frame/frame_error.h"
#include "image_io/image_io.h"
#include "scenes/view_document.h"
#include "tests/frame/scratch_folder.h"
#include "tests/image_io/npy.h"

namespace zproof::oracle {
namespace {

using testing::HasSubstr;
using Rows = std::vector<std::vector<double>>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr float none_depth = std::numeric_limits<float>::infinity();

View some_view(Projection projection, double far = 40) {
    View view{.name = "v", .camera = look_at({3, 2, 5}, {0, 1, -1}, {0, 1, 0}), .width = 7, .height = 5};
    view.camera.projection = projection;
    view.camera.window = {.left = -0.3, .right = 0.9, .bottom = -0.5, .top = 0.25};
    if (projection == Projection::parallel) view.camera.shear = {0.25, -0.125};
    view.camera.near_depth = 0.5;
    view.camera.far_depth = far;
    return view;
}

/// The camera-space point at this depth, seen at the centre of pixel (x, y).
glm::dvec3 point_at(const View& view, int x, int y, double depth) {
    const Window& w = view.camera.window;
    const double u = w.left + (w.right - w.left) * (x + 0.5) / view.width;
    const double v = w.top - (w.top - w.bottom) * (y + 0.5) / view.height;
    if (view.camera.projection == Projection::perspective) return depth * glm::dvec3{u, v, -1};
    return glm::dvec3{u, v, 0} + depth * glm::dvec3{view.camera.shear.x, view.camera.shear.y, -1};
}

double ray_length(const View& view, int x, int y, double from, double to) {
    return glm::length(point_at(view, x, y, to) - point_at(view, x, y, from));
}

/// By the matrix that a program under test is told, for this range of z.
double ndc_z(View view, NdcDepth range, const glm::dvec3& p_camera) {
    view.camera.ndc_depth = range;
    const Rows clip = nlohmann::json::parse(camera_document(view)).at("clip_from_camera");
    const auto row = [&](std::size_t i) {
        return clip[i][0] * p_camera.x + clip[i][1] * p_camera.y + clip[i][2] * p_camera.z + clip[i][3];
    };
    return row(2) / row(3);
}

/// What a renderer of this kind stores for a depth.
double stored(const View& view, const std::string& kind, int x, int y, double depth) {
    const glm::dvec3 p = point_at(view, x, y, depth);
    if (kind == "ray_length") return ray_length(view, x, y, 0, depth);
    if (kind == "ray_length_from_near") return ray_length(view, x, y, view.camera.near_depth, depth);
    if (kind == "ndc_z") return ndc_z(view, NdcDepth::minus_one_to_one, p);
    if (kind == "window_z") return ndc_z(view, NdcDepth::zero_to_one, p);
    if (kind == "reversed_z") return ndc_z(view, NdcDepth::zero_to_one_reversed, p);
    if (kind == "inverse") return 1 / depth;
    if (kind == "disparity") return 0.12 * (view.width / 1.2) / depth;
    return depth;
}

class StoredFrames : public ScratchFolder {
  protected:
    /// A frame of these depths, all of triangle 0, as it is read back.
    Frame read(const View& view, const std::vector<double>& depths, const std::string& convention) {
        const std::string shape = std::to_string(view.height) + ", " + std::to_string(view.width);
        write_npy<std::uint32_t>(file("id.npy"), "<u4", shape, std::vector<std::uint32_t>(depths.size()));
        write_npy(file("z.npy"), "<f8", shape, depths);
        return read_named(view, convention);
    }
    Frame read_named(const View& view, const std::string& convention) {
        return read_stored_frame(file("id.npy").string() + "+" + file("z.npy").string(),
                                 convention_from_words(convention, ""), view);
    }

    /// Depths from near to far, another one at every pixel.
    static std::vector<double> depths_in(const View& view) {
        const double reach = std::isinf(view.camera.far_depth) ? 1e4 : view.camera.far_depth;
        std::vector<double> depths;
        for (int i = 0; i < view.width * view.height; ++i)
            depths.push_back(0.5 * std::pow(reach / 0.5, i / double(view.width * view.height - 1)));
        return depths;
    }

    /// Every depth comes back as it was, rounded once.
    void expect_exact(const View& view, const std::string& kind, const std::string& more = "",
                      double scale = 1) {
        const std::vector<double> depths = depths_in(view);
        std::vector<double> written;
        for (std::size_t i = 0; i < depths.size(); ++i)
            written.push_back(stored(view, kind, int(i) % view.width, int(i) / view.width, depths[i]) /
                              scale);
        const Frame frame = read(view, written, "depth_background=nan,depth_kind=" + kind + more);
        for (std::size_t i = 0; i < depths.size(); ++i)
            EXPECT_NEAR(frame.camera_depth.pixels()[i], depths[i], depths[i] * 0x1.0001p-24)
                << kind << " at pixel " << i;
    }
};

TEST_F(StoredFrames, EveryKindOfDepthIsTheCamerasWithinOneRounding) {
    for (const Projection projection : {Projection::perspective, Projection::parallel})
        for (const char* kind :
             {"camera", "ray_length", "ray_length_from_near", "ndc_z", "window_z", "reversed_z", "inverse"})
            expect_exact(some_view(projection), kind);
    expect_exact(some_view(Projection::perspective), "disparity", ",baseline=0.12");
}

TEST_F(StoredFrames, AnInfiniteFarPlaneIsNone) {
    const View view = some_view(Projection::perspective, infinity);
    expect_exact(view, "reversed_z");
    expect_exact(view, "ray_length_from_near");
}

TEST_F(StoredFrames, TheScaleComesFirst) {
    const View view = some_view(Projection::perspective);
    expect_exact(view, "camera", ",depth_scale=0.001", 0.001);
    expect_exact(view, "ray_length", ",depth_scale=1000", 1000);
    expect_exact(view, "window_z", ",depth_scale=0.0000152590218966964", 0.0000152590218966964);
}

TEST_F(StoredFrames, WithoutAConventionNoBitChanges) {
    Frame frame({7, 5});
    frame.primitive.at(1, 1) = PrimitiveId{3};
    frame.camera_depth.at(1, 1) = std::bit_cast<float>(0x7F800001u);  // a signalling NaN
    write_frame(file("a.exr"), frame);
    const Frame back = read_stored_frame(file("a.exr"), {}, some_view(Projection::perspective));
    EXPECT_EQ(std::bit_cast<std::uint32_t>(back.camera_depth.at(1, 1)), 0x7F800001u);
}

/// One row of 7 pixels.
View row_view() {
    View view = some_view(Projection::perspective);
    view.height = 1;
    return view;
}

TEST_F(StoredFrames, OnlyTheBackgroundsOwnDepthBecomesBackground) {
    write_npy<std::int32_t>(file("id.npy"), "<i4", "1, 7", {-1, -1, -1, -1, 4, 4, 4});
    write_npy<float>(file("z.npy"), "<f4", "1, 7", {1e10f, 0, NAN, 2, 1e10f, 0, NAN});
    const Frame frame = read_named(row_view(), "id_background=-1,depth_background=1e10|0");
    const auto depth = [&](int x) { return frame.camera_depth.at(x, 0); };
    for (int x = 0; x < 7; ++x)
        EXPECT_EQ(frame.primitive.at(x, 0), x < 4 ? PrimitiveId::none : PrimitiveId{4}) << x;
    EXPECT_EQ(depth(0), none_depth);
    EXPECT_EQ(depth(1), none_depth);
    EXPECT_TRUE(std::isnan(depth(2)));  // nothing is repaired
    EXPECT_EQ(depth(3), 2);
    EXPECT_EQ(depth(4), 1e10f);
    EXPECT_EQ(depth(5), 0);
    EXPECT_TRUE(std::isnan(depth(6)));
}

TEST_F(StoredFrames, TheDepthMaySayWhatIsBackground) {
    write_npy<std::int32_t>(file("id.npy"), "<i4", "1, 7", {0, 0, 0, 4, 4, 4, 4});
    write_npy<float>(file("z.npy"), "<f4", "1, 7", {0, NAN, 2, 0.1f, 0.2f, -1, 40});
    const Frame frame = read_named(row_view(), "background_by=depth,depth_background=0|nan|0.1|far");
    for (const int x : {0, 1, 3, 6}) {
        EXPECT_EQ(frame.primitive.at(x, 0), PrimitiveId::none) << x;
        EXPECT_EQ(frame.camera_depth.at(x, 0), none_depth) << x;
    }
    EXPECT_EQ(frame.primitive.at(2, 0), PrimitiveId{0});
    EXPECT_EQ(frame.camera_depth.at(5, 0), -1);
}

TEST_F(StoredFrames, TheFarPlaneIsBackgroundInEveryKindThatHasOne) {
    for (const auto& [kind, far] : std::vector<std::pair<std::string, double>>{
             {"camera", 40}, {"ndc_z", 1}, {"window_z", 1}, {"reversed_z", 0}, {"inverse", 1 / 40.0}}) {
        const Frame frame = read(row_view(), {far, far * 0.5 + 0.25, far, far, far, far, far},
                                 "background_by=depth,depth_background=far,depth_kind=" + kind);
        EXPECT_EQ(frame.camera_depth.at(0, 0), none_depth) << kind;
        EXPECT_NE(frame.camera_depth.at(1, 0), none_depth) << kind;
    }
}

TEST_F(StoredFrames, WhatIsNoDepthStaysNone) {
    const Frame z = read(row_view(), {NAN, -3, 1.5, 0, 0, 0, 0}, "depth_kind=window_z");
    EXPECT_TRUE(std::isnan(z.camera_depth.at(0, 0)));
    EXPECT_LT(z.camera_depth.at(1, 0), 0.5f);                                    // before near
    EXPECT_TRUE(z.camera_depth.at(2, 0) < 0 || z.camera_depth.at(2, 0) > 40.f);  // behind far
    const Frame inverse = read(row_view(), {0, -0.5, 0, 0, 0, 0, 0}, "depth_kind=inverse");
    EXPECT_EQ(inverse.camera_depth.at(1, 0), -2);
}

TEST_F(StoredFrames, WhatDoesNotFitTheViewIsRefused) {
    const View parallel = some_view(Projection::parallel);
    EXPECT_THAT(complaint<FrameError>(
                    [&] { read(parallel, depths_in(parallel), "depth_kind=disparity,baseline=1"); }),
                HasSubstr("a parallel projection has no disparity"));
    EXPECT_THAT(complaint<FrameError>([&] { read_named(row_view(), "depth_scale=2"); }),
                HasSubstr("7 x 5 pixels; the view 'v' has 7 x 1"));
    EXPECT_THAT(complaint<FrameError>([&] {
                    read_stored_frame(file("z.npy"), convention_from_words("depth_scale=2", ""), parallel);
                }),
                HasSubstr("channel 'id' is missing"));
}

}  // namespace
}  // namespace zproof::oracle
