// transforms.json: cameras look along -z with y up, and matrices take camera space to world space.
#include <array>
#include <cmath>

#include "scenes/import/view_import.h"
#include "scenes/json_text.h"
#include "scenes/scene_error.h"
#include "scenes/scene_files.h"

namespace zproof {
namespace {

constexpr std::uint64_t largest_nerf_file = std::uint64_t{1} << 26;

/// A frame's own value where it has one, else the file's.
class NerfFrame {
  public:
    NerfFrame(LocatedValue root, LocatedValue frame) : root_(std::move(root)), frame_(std::move(frame)) {}

    const LocatedValue& place() const { return frame_; }
    bool has(const char* key) const { return frame_.has(key) || root_.has(key); }
    LocatedValue at(const char* key) const { return frame_.has(key) ? frame_.at(key) : root_.at(key); }
    double number(const char* key, double otherwise) const { return has(key) ? at(key).number() : otherwise; }

  private:
    LocatedValue root_, frame_;
};

void refuse_distortion(const NerfFrame& frame) {
    for (const char* key : {"k1", "k2", "k3", "k4", "p1", "p2"})
        if (frame.number(key, 0) != 0)
            frame.at(key).fail(
                "a distorted image has no straight lines; undistort the images and leave it out");
    if (frame.has("is_fisheye") && frame.at("is_fisheye").value() != false)
        frame.at("is_fisheye").fail("expected a pinhole");
    if (!frame.has("camera_model")) return;
    const LocatedValue model = frame.at("camera_model");
    for (const char* pinhole : {"OPENCV", "PINHOLE", "SIMPLE_PINHOLE"})
        if (model.value() == pinhole) return;
    model.fail("expected a pinhole: OPENCV, PINHOLE or SIMPLE_PINHOLE");
}

int side_of(const NerfFrame& frame, const char* key, const std::optional<int>& otherwise) {
    if (!frame.has(key)) {
        if (otherwise) return *otherwise;
        frame.place().fail(std::string("\"") + key +
                           "\" is missing; --width and --height say the images' size");
    }
    const double side = frame.at(key).number();  // some programs write 800.0
    if (!(side >= 1 && side <= 16384) || side != std::floor(side))
        frame.at(key).fail("expected a whole number from 1 to 16384");
    return int(side);
}

/// The focal length that an angle of view gives.
double focal_of(const LocatedValue& angle, int side) {
    const double radians = angle.number();
    if (!(radians > 0 && radians < 3.14159)) angle.fail("expected an angle below pi, in radians");
    return side / 2.0 / std::tan(radians / 2);
}

void set_intrinsics(const NerfFrame& frame, CalibratedCamera& camera) {
    if (frame.has("fl_x"))
        camera.fx = frame.at("fl_x").number();
    else if (frame.has("camera_angle_x"))
        camera.fx = focal_of(frame.at("camera_angle_x"), camera.width);
    else
        frame.place().fail("expected \"fl_x\" or \"camera_angle_x\", here or at the top");
    camera.fy = camera.fx;
    if (frame.has("fl_y"))
        camera.fy = frame.at("fl_y").number();
    else if (frame.has("camera_angle_y"))
        camera.fy = focal_of(frame.at("camera_angle_y"), camera.height);
    camera.cx = frame.number("cx", camera.width / 2.0);
    camera.cy = frame.number("cy", camera.height / 2.0);
}

/// Columns of the upper three rows.
void set_pose(const LocatedValue& matrix, CalibratedCamera& camera) {
    const std::size_t rows = matrix.value().is_array() ? matrix.value().size() : 0;
    if (rows != 3 && rows != 4) matrix.fail("expected four rows of four numbers");
    std::array<glm::dvec4, 3> row{};
    for (std::size_t i = 0; i < 3; ++i) {
        const nlohmann::json& numbers = matrix.at(i).numbers(4);
        for (int c = 0; c < 4; ++c) row[i][c] = numbers[std::size_t(c)].get<double>();
    }
    if (rows == 4) {
        const nlohmann::json& last = matrix.at(3).numbers(4);
        if (last != nlohmann::json{0, 0, 0, 1})
            matrix.at(3).fail(
                "expected [0, 0, 0, 1]; a matrix that is stored by columns is to be transposed");
    }
    const auto column = [&](int c) { return glm::dvec3{row[0][c], row[1][c], row[2][c]}; };
    camera.right = column(0);
    camera.down = -column(1);
    camera.forward = -column(2);
    camera.eye = column(3);
}

ImportedView view_at(const NerfFrame& frame, const DepthRange& range, const std::optional<glm::ivec2>& size) {
    refuse_distortion(frame);
    CalibratedCamera camera;
    camera.name = view_name_of_image(frame.place().at("file_path").text());
    camera.width = side_of(frame, "w", size ? std::optional(size->x) : std::nullopt);
    camera.height = side_of(frame, "h", size ? std::optional(size->y) : std::nullopt);
    set_intrinsics(frame, camera);
    set_pose(frame.place().at("transform_matrix"), camera);
    try {
        return view_of(camera, range);
    } catch (const SceneError& error) {
        frame.place().fail(error.what());
    }
}

}  // namespace

std::vector<ImportedView> import_nerf(const std::filesystem::path& file, const DepthRange& range,
                                      const std::optional<glm::ivec2>& size) {
    const Bytes bytes = read_file(file, largest_nerf_file);
    const auto content = parse_json(file, text_in(file, bytes));
    const LocatedValue root(file, content, "");
    const LocatedValue list = root.at("frames");
    if (!list.value().is_array()) list.fail("expected an array of frames");
    std::vector<ImportedView> views;
    for (std::size_t i = 0; i < list.value().size(); ++i)
        views.push_back(view_at(NerfFrame{root, list.at(i)}, range, size));
    require_unique_names(file, views);
    return views;
}

}  // namespace zproof
