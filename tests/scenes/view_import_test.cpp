// Imported cameras against an oracle that projects points by the numbers of the file itself.
#include "scenes/import/view_import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scenes/scene_error.h"
#include "tests/scenes/written_gltf.h"

namespace zproof {
namespace {

using nlohmann::json;

constexpr DepthRange range{.near_depth = 0.1, .far_depth = 100};

/// The pixel position of a point by this program's camera (scenes/camera.h).
glm::dvec2 raster_of(const View& view, const glm::dvec3& p_world) {
    const Camera& c = view.camera;
    const glm::dvec3 d = p_world - glm::dvec3(c.eye_world);
    const double depth = -glm::dot(d, c.back);
    const double u = glm::dot(d, c.right) / depth, v = glm::dot(d, c.up) / depth;
    return {(u - c.window.left) / (c.window.right - c.window.left) * view.width,
            (c.window.top - v) / (c.window.top - c.window.bottom) * view.height};
}

/// OpenCV's: K (R p + t), in the coordinates of its own pixels.
struct Pinhole {
    double fx, fy, cx, cy;
    glm::dmat3 r;  ///< r[column][row]
    glm::dvec3 t;

    glm::dvec2 operator()(const glm::dvec3& p_world) const {
        const glm::dvec3 p = r * p_world + t;
        return {fx * p.x / p.z + cx, fy * p.y / p.z + cy};
    }
};

/// A rotation by Rodrigues' formula.
glm::dmat3 rotation(const glm::dvec3& axis, double angle) {
    const glm::dvec3 a = glm::normalize(axis);
    const glm::dmat3 cross{0, a.z, -a.y, -a.z, 0, a.x, a.y, -a.x, 0};
    return glm::dmat3(1.0) + std::sin(angle) * cross + (1 - std::cos(angle)) * cross * cross;
}

/// Its eye is where float32 has it: (0.5, -1.25, 3).
Pinhole some_pinhole() {
    const glm::dmat3 r = rotation({1, 2, -0.5}, 0.7);
    return {612.25, 598.5, 331.7, 222.1, r, -(r * glm::dvec3{0.5, -1.25, 3})};
}

std::vector<glm::dvec3> points_before(const Pinhole& pinhole) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(-1, 1), depth(0.2, 30);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 200; ++i) {
        const double z = depth(random);
        points.push_back(glm::transpose(pinhole.r) *
                         (glm::dvec3{side(random) * z, side(random) * z, z} - pinhole.t));
    }
    return points;
}

/// The imported view sees every point where the file's numbers put it, `offset` pixels further.
void expect_same_pixels(const View& view, const Pinhole& pinhole, double offset) {
    double worst = 0;
    for (const glm::dvec3& p : points_before(pinhole)) {
        const glm::dvec2 off = raster_of(view, p) - pinhole(p) - offset;
        worst = std::max({worst, std::abs(off.x), std::abs(off.y)});
    }
    EXPECT_LT(worst, 1e-9);
}

json rows_of(const glm::dmat3& m) {
    json rows = json::array();
    for (int r = 0; r < 3; ++r) rows.push_back({m[0][r], m[1][r], m[2][r]});
    return rows;
}

json opencv_view(const Pinhole& p, const std::string& centre) {
    return {{"name", "left/a.png"},
            {"width", 640},
            {"height", 480},
            {"pixel_centre", centre},
            {"K", {{p.fx, 0, p.cx}, {0, p.fy, p.cy}, {0, 0, 1}}},
            {"R", rows_of(p.r)},
            {"t", {p.t.x, p.t.y, p.t.z}}};
}

class ViewImport : public testing::Test {
  protected:
    std::vector<ImportedView> opencv(const json& view) const {
        return import_opencv(folder_.write("cameras.json", json{{"views", {view}}}.dump()), range);
    }
    ImportedViews colmap(const std::string& cameras, const std::string& images) const {
        folder_.write("cameras.txt", cameras);
        folder_.write("images.txt", images);
        return import_colmap(folder_.path(), range);
    }
    std::vector<ImportedView> nerf(const json& file, const std::optional<glm::ivec2>& size = {}) const {
        return import_nerf(folder_.write("transforms.json", file.dump()), range, size);
    }

    template <class Import>
    static std::string refusal(const Import& import) {
        try {
            import();
        } catch (const SceneError& error) {
            return error.what();
        }
        return "imported";
    }
    template <class Import>
    static void expect_refusal(const Import& import, const std::string& said) {
        const std::string refused = refusal(import);
        EXPECT_NE(refused.find(said), std::string::npos) << refused;
    }

    TestFolder folder_;
};

TEST_F(ViewImport, OpenCvsPointsLandOnTheirPixels) {
    const Pinhole pinhole = some_pinhole();
    for (const auto& [centre, offset] : {std::pair{"integer", 0.5}, std::pair{"half", 0.0}}) {
        const ImportedView imported = opencv(opencv_view(pinhole, centre)).at(0);
        EXPECT_EQ(imported.view.name, "left_a");
        EXPECT_EQ(imported.view.width, 640);
        EXPECT_EQ(imported.view.camera.near_depth, 0.1);
        EXPECT_LT(imported.adjustment.eye, 1e-15);
        EXPECT_LT(imported.adjustment.axes, 1e-15);
        expect_same_pixels(imported.view, pinhole, offset);
    }
}

TEST_F(ViewImport, AnEyeThatFloat32DoesNotHaveIsRoundedAndSaid) {
    Pinhole pinhole = some_pinhole();
    pinhole.t = -(pinhole.r * glm::dvec3{0.1, 0, 0});
    const ImportedView imported = opencv(opencv_view(pinhole, "integer")).at(0);
    EXPECT_NEAR(imported.adjustment.eye, double(0.1f) - 0.1, 1e-15);
    EXPECT_EQ(imported.view.camera.eye_world.x, 0.1f);
}

TEST_F(ViewImport, ARotationOfSixDigitsIsMadeOneAndSaid) {
    Pinhole pinhole = some_pinhole();
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) pinhole.r[c][r] = std::round(pinhole.r[c][r] * 1e6) / 1e6;
    const ImportedView imported = opencv(opencv_view(pinhole, "integer")).at(0);
    EXPECT_GT(imported.adjustment.axes, 1e-9);
    EXPECT_LT(imported.adjustment.axes, 2e-6);
    EXPECT_NO_THROW(validate(imported.view.camera));
}

TEST_F(ViewImport, WhatIsNoPinholeOfOpenCvsIsRefused) {
    const json good = opencv_view(some_pinhole(), "integer");
    const auto with = [&](const std::string& key, const json& value, const std::string& said) {
        json view = good;
        if (value.is_null())
            view.erase(key);
        else
            view[key] = value;
        expect_refusal([&] { opencv(view); }, said);
    };
    with("pixel_centre", nullptr, "\"pixel_centre\" is missing; expected \"integer\"");
    with("pixel_centre", "corner", "/views/0/pixel_centre: expected \"integer\"");
    with("distortion", {0, 0.1}, "/views/0/distortion/1: a distorted image");
    with("K", {{600, 1, 300}, {0, 600, 200}, {0, 0, 1}}, "/views/0/K: expected no skew");
    with("K", {{600, 0, 300}, {0, 600, 200}, {0, 0, 2}}, "/views/0/K: expected [[fx");
    with("K", {{-600, 0, 300}, {0, 600, 200}, {0, 0, 1}},
         "camera focal length: expected a finite number above 0");
    with("R", {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, "mirror image");
    with("R", {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, "camera pose: expected a rotation");
    with("R", {1, 0, 0}, "/views/0/R/0: expected an array of 3 numbers");
    with("width", 0, "camera size");
    with("fov", 60, "/views/0/fov: unknown key");
    expect_refusal(
        [&] {
            import_opencv(folder_.write("two.json", json{{"views", {good, good}}}.dump()), range);
        },
        "two are called 'left_a'");
    expect_refusal(
        [&] {
            import_opencv(folder_.write("none.json", json{{"views", json::array()}}.dump()), range);
        },
        "expected at least one image");
}

/// A quaternion of a rotation by Rodrigues' angle and axis.
std::string colmap_image(const glm::dvec3& axis, double angle, const glm::dvec3& t, const std::string& name) {
    const glm::dvec3 v = std::sin(angle / 2) * glm::normalize(axis);
    std::ostringstream line;
    line.precision(17);
    line << "3 " << std::cos(angle / 2) << " " << v.x << " " << v.y << " " << v.z << " " << t.x << " " << t.y
         << " " << t.z << " 9 " << name << "\n";
    return line.str();
}

TEST_F(ViewImport, ColmapsPointsLandOnTheirPixels) {
    const Pinhole pinhole = some_pinhole();
    const std::string image = colmap_image({1, 2, -0.5}, 0.7, pinhole.t, "a b/1.JPG");
    const auto views =
        colmap("# cameras\n9 PINHOLE 640 480 612.25 598.5 331.7 222.1\n8 SIMPLE_RADIAL 10 10 5 5 5 0\n",
               "# images\n" + image + "\n" + colmap_image({0, 1, 0}, 1, {0, 0, 0}, "2") + "1 2 -1 3 4 5\n")
            .views;
    ASSERT_EQ(views.size(), 2u);
    EXPECT_EQ(views[0].view.name, "a_b_1");
    EXPECT_EQ(views[1].view.name, "2");
    expect_same_pixels(views[0].view, pinhole, 0);
}

TEST_F(ViewImport, ColmapsImagesMayStandWithoutALineOfPoints) {
    const auto image = [](const char* name) { return colmap_image({0, 1, 0}, 1, {0, 0, 0}, name); };
    const auto [views, left_out] =
        colmap("9 PINHOLE 640 480 612 598 331 222\n", image("1") + image("2.png") + "# no points\n" +
                                                          image("3 4 5") + "\r\n" + image("b 7") +
                                                          "1.5 -2 -1 3e2 4 5\n" + image("c") + "1 2 -1\n");
    std::string names;
    for (const ImportedView& imported : views) names += imported.view.name + ",";
    EXPECT_EQ(names, "1,2,3_4_5,b_7,c,");
    expect_refusal(
        [&] { colmap("9 PINHOLE 640 480 612 598 331 222\n", image("1") + "1 2 -1 3\n" + image("2")); },
        "images.txt: line 2: expected IMAGE_ID");
}

TEST_F(ViewImport, ColmapsImagesWithoutAPinholeAreLeftOutByName) {
    const auto image = [](int camera, const std::string& name) {
        return std::to_string(camera) + " 1 0 0 0 0 0 0 " + std::to_string(camera) + " " + name + "\n\n";
    };
    const auto [views, left_out] = colmap(
        "\xEF\xBB\xBF"
        "1 SIMPLE_RADIAL 64 48 60 32 24 0\n2 RADIAL 64 48 60 32 24 0 0\n3 RADIAL 64 48 60 32 24 "
        "0.1 0\n4 FOV 64 48 60 60 32 24 1\n5 THIN_PRISM_FISHEYE 64 48\n",
        image(1, "a.png") + image(2, "b.png") + image(3, "c.png") + image(3, "d.png") + image(4, "e.png"));
    ASSERT_EQ(views.size(), 2u);
    EXPECT_EQ(views[0].view.name, "a");
    EXPECT_EQ(views[1].view.name, "b");
    const std::string remedy = "; colmap image_undistorter makes PINHOLE cameras: ";
    EXPECT_EQ(left_out,
              (std::vector<std::string>{"cameras.txt: line 3: a distorted image has no straight lines" +
                                            remedy + "2 images left out: c.png, d.png",
                                        "cameras.txt: line 4: camera model FOV is no pinhole" + remedy +
                                            "1 image left out: e.png"}));
}

TEST_F(ViewImport, WhatIsNoPinholeOfColmapsIsRefusedWithItsLine) {
    const std::string image = colmap_image({0, 1, 0}, 1, {0, 0, 0}, "a.png");
    const auto cameras = [&](const std::string& line, const std::string& said) {
        expect_refusal([&] { colmap("# first\n" + line + "\n", image); }, said);
    };
    cameras("9 SIMPLE_RADIAL 640 480 600 320 240 0.01", "cameras.txt: line 2: a distorted image");
    cameras("9 OPENCV_FISHEYE 640 480 600 600 320 240 0 0 0 0", "camera model OPENCV_FISHEYE is no pinhole");
    cameras("9 PINHOLE 640 480 600 600 320", "cameras.txt: line 2: expected CAMERA_ID");
    cameras("9 PINHOLE 640 480 600 600 320 240 0", "cameras.txt: line 2: expected CAMERA_ID");
    cameras("8 PINHOLE 640 480 600 600 320 240", "images.txt: line 1: cameras.txt has no camera 9");
    const std::string pinhole = "9 PINHOLE 640 480 600 600 320 240\n";
    expect_refusal([&] { colmap(pinhole, "1 1 0 0 0 0 0 0 9\n"); }, "images.txt: line 1: expected IMAGE_ID");
    expect_refusal([&] { colmap(pinhole, "1 2 0 0 0 0 0 0 9 a.png\n"); }, "a quaternion");
    expect_refusal([&] { import_colmap(folder_.path() / "none", range); },
                   "model_converter --output_type TXT");
}

/// The frame of a camera that looks as the pinhole does, with the axes of OpenGL.
json nerf_frame(const Pinhole& pinhole) {
    const glm::dmat3 r = glm::transpose(pinhole.r);  // world from camera
    const glm::dvec3 right = r[0], up = -r[1], back = -r[2], eye = -(r * pinhole.t);
    json rows = json::array();
    for (int i = 0; i < 3; ++i) rows.push_back({right[i], up[i], back[i], eye[i]});
    rows.push_back({0, 0, 0, 1});
    return {{"file_path", "./images/r_0.png"}, {"transform_matrix", rows}};
}

TEST_F(ViewImport, NerfsPointsLandOnTheirPixels) {
    const Pinhole pinhole = some_pinhole();
    const auto views = nerf({{"fl_x", 612.25},
                             {"fl_y", 598.5},
                             {"cx", 331.7},
                             {"cy", 222.1},
                             {"w", 640.0},
                             {"h", 480},
                             {"k1", 0},
                             {"camera_model", "OPENCV"},
                             {"frames", {nerf_frame(pinhole)}}});
    EXPECT_EQ(views.at(0).view.name, "images_r_0");
    EXPECT_EQ(views.at(0).view.width, 640);
    expect_same_pixels(views.at(0).view, pinhole, 0);
}

TEST_F(ViewImport, NerfsAngleOfViewIsAFocalLength) {
    Pinhole pinhole = some_pinhole();
    pinhole.fx = pinhole.fy = 400 / std::tan(0.6911112070083618 / 2);
    pinhole.cx = pinhole.cy = 400;
    const json file{{"camera_angle_x", 0.6911112070083618}, {"frames", {nerf_frame(pinhole)}}};
    expect_same_pixels(nerf(file, glm::ivec2{800, 800}).at(0).view, pinhole, 0);
    expect_refusal([&] { nerf(file); }, "/frames/0: \"w\" is missing; --width and --height say");
}

TEST_F(ViewImport, WhatIsNoPinholeOfNerfsIsRefused) {
    const json good{{"fl_x", 600}, {"w", 640}, {"h", 480}, {"frames", {nerf_frame(some_pinhole())}}};
    const auto with = [&](const std::string& key, const json& value, const std::string& said) {
        json file = good;
        file[key] = value;
        expect_refusal([&] { nerf(file); }, said);
    };
    EXPECT_EQ(refusal([&] { nerf(good); }), "imported");
    with("k1", 0.01, "/k1: a distorted image");
    with("camera_model", "OPENCV_FISHEYE", "/camera_model: expected a pinhole");
    with("is_fisheye", true, "/is_fisheye: expected a pinhole");
    with("w", 640.5, "/w: expected a whole number");
    with("frames", json::array(), "expected at least one image");
    with("frames", {{{"file_path", "a"}, {"transform_matrix", {1, 2}}}},
         "transform_matrix: expected four rows");
    json by_columns = nerf_frame(some_pinhole());
    by_columns["transform_matrix"][3] = {1, 2, 3, 1};
    with("frames", json::array({by_columns}), "transform_matrix/3: expected [0, 0, 0, 1]");
    json without = good;
    without.erase("fl_x");
    expect_refusal([&] { nerf(without); }, "expected \"fl_x\" or \"camera_angle_x\"");
}

}  // namespace
}  // namespace zproof
