// COLMAP's text files: https://colmap.github.io/format.html
#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <utility>

#include "frame/input_file.h"
#include "scenes/import/view_import.h"
#include "scenes/refusal.h"
#include "scenes/scene_error.h"
#include "scenes/scene_files.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

/// A text file, line by line, that knows where it is.
class ColmapLines {
  public:
    explicit ColmapLines(const fs::path& file) : file_(file) {
        if (const std::string fault = fault_of_input(file); !fault.empty())
            refuse(file, "file",
                   fault +
                       "; expected COLMAP's text files, as 'colmap model_converter --output_type TXT' "
                       "writes them");
        in_.open(file);
    }

    /// The next line, whatever is in it; false at the end.
    bool next_line() {
        if (std::exchange(is_unread_, false)) return true;
        const bool is_there(std::getline(in_, line_));
        if (++number_ == 1 && line_.starts_with(byte_order_mark)) line_.erase(0, byte_order_mark.size());
        return is_there;
    }
    /// Makes this line the next one, too.
    void unread() { is_unread_ = true; }
    /// Does the line hold points of an image, X Y POINT3D_ID each, or none?
    bool holds_points() const {
        if (line_.find_first_not_of("+-.0123456789eE \t\r") != std::string::npos) return false;
        std::istringstream words(line_);
        return std::distance(std::istream_iterator<std::string>(words), {}) % 3 == 0;
    }
    /// The next line that is neither empty nor a comment; false at the end.
    bool next_record() {
        while (next_line())
            if (const auto at = line_.find_first_not_of(" \t\r"); at != std::string::npos && line_[at] != '#')
                return true;
        return false;
    }
    const std::string& text() const { return line_; }
    std::string place() const { return "line " + std::to_string(number_); }
    [[noreturn]] void fail(const std::string& why) const { refuse(file_, place(), why); }

  private:
    fs::path file_;
    std::ifstream in_;
    std::string line_;
    int number_ = 0;
    bool is_unread_ = false;
};

/// The parameters of a model: how many focal lengths it has, and how many numbers of distortion.
struct ColmapModel {
    const char* name;
    int focal_lengths, distortions;
};
constexpr ColmapModel colmap_models[] = {{"SIMPLE_PINHOLE", 1, 0}, {"PINHOLE", 2, 0}, {"SIMPLE_RADIAL", 1, 1},
                                         {"RADIAL", 1, 2},         {"OPENCV", 2, 4},  {"FULL_OPENCV", 2, 8}};

struct ColmapCamera {
    CalibratedCamera calibrated;
    std::string fault = {};                  ///< why it is no pinhole; empty where it is one
    std::vector<std::string> left_out = {};  ///< the images that it took, where it is none
};
using ColmapCameras = std::map<long, ColmapCamera>;

ColmapCamera camera_of(std::istream& words, const ColmapLines& lines) {
    CalibratedCamera camera;
    std::string name;
    words >> name >> camera.width >> camera.height;
    const auto* const model = std::ranges::find(colmap_models, name, &ColmapModel::name);
    const std::string place = "cameras.txt: " + lines.place() + ": ",
                      remedy = "; colmap image_undistorter makes PINHOLE cameras";
    if (model == std::end(colmap_models))
        return {camera, place + "camera model " + name + " is no pinhole" + remedy};
    words >> camera.fx;
    camera.fy = camera.fx;
    if (model->focal_lengths == 2) words >> camera.fy;
    words >> camera.cx >> camera.cy;
    bool is_distorted = false;
    for (int i = 0; i < model->distortions; ++i) {
        double distortion = 0;
        words >> distortion;
        is_distorted = is_distorted || distortion != 0;
    }
    if (!words || !(words >> std::ws).eof())
        lines.fail("expected CAMERA_ID MODEL WIDTH HEIGHT and the numbers of " + name);
    return {camera, is_distorted ? place + "a distorted image has no straight lines" + remedy : ""};
}

ColmapCameras cameras_in(const fs::path& file) {
    ColmapCameras cameras;
    ColmapLines lines(file);
    while (lines.next_record()) {
        std::istringstream words(lines.text());
        long id = 0;
        if (!(words >> id)) lines.fail("expected CAMERA_ID MODEL WIDTH HEIGHT PARAMS");
        cameras[id] = camera_of(words, lines);
    }
    return cameras;
}

/// "camera model FOV is no pinhole; ...: 2 images left out: a.png, b.png".
std::string sentence_of(const ColmapCamera& camera) {
    std::string names;
    for (const std::string& name : camera.left_out) names += (names.empty() ? "" : ", ") + name;
    const std::size_t count = camera.left_out.size();
    return on_one_line(camera.fault + ": " + std::to_string(count) + (count == 1 ? " image" : " images") +
                       " left out: " + names);
}

/// The rows of the rotation of a unit quaternion (Hamilton's), made one of unit length first.
void set_rotation(const glm::dvec4& wxyz, const ColmapLines& lines, CalibratedCamera& camera) {
    const double length = glm::length(wxyz);
    if (!(std::abs(length - 1) < 1e-3)) lines.fail("expected a quaternion QW QX QY QZ of length 1");
    const auto [w, x, y, z] =
        std::array{wxyz[0] / length, wxyz[1] / length, wxyz[2] / length, wxyz[3] / length};
    camera.right = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)};
    camera.down = {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)};
    camera.forward = {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)};
}

/// None where the image's camera is no pinhole.
std::optional<ImportedView> image_at(const ColmapLines& lines, ColmapCameras& cameras,
                                     const DepthRange& range) {
    std::istringstream words(lines.text());
    long image = 0, camera_id = 0;
    glm::dvec4 wxyz{0};
    glm::dvec3 t{0};
    std::string name;
    words >> image >> wxyz[0] >> wxyz[1] >> wxyz[2] >> wxyz[3] >> t.x >> t.y >> t.z >> camera_id >> std::ws;
    if (!words || !std::getline(words, name))
        lines.fail("expected IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME");
    const auto found = cameras.find(camera_id);
    if (found == cameras.end()) lines.fail("cameras.txt has no camera " + std::to_string(camera_id));
    if (!found->second.fault.empty()) return found->second.left_out.push_back(name), std::nullopt;
    CalibratedCamera camera = found->second.calibrated;
    camera.name = view_name_of_image(name);
    set_rotation(wxyz, lines, camera);
    camera.eye = -(t.x * camera.right + t.y * camera.down + t.z * camera.forward);
    try {
        return view_of(camera, range);
    } catch (const SceneError& error) {
        lines.fail(error.what());
    }
}

}  // namespace

ImportedViews import_colmap(const fs::path& folder, const DepthRange& range) {
    ColmapCameras cameras = cameras_in(folder / "cameras.txt");
    const fs::path images = folder / "images.txt";
    ColmapLines lines(images);
    ImportedViews imported;
    while (lines.next_record()) {
        if (const auto view = image_at(lines, cameras, range)) imported.views.push_back(*view);
        if (lines.next_line() && !lines.holds_points()) lines.unread();  // some programs write no such line
    }
    for (const auto& [id, camera] : cameras)
        if (!camera.left_out.empty()) imported.left_out.push_back(sentence_of(camera));
    if (imported.views.empty() && !imported.left_out.empty())
        refuse(images, "views", "none is left: " + imported.left_out.front());
    require_unique_names(images, imported.views);
    return imported;
}

}  // namespace zproof
