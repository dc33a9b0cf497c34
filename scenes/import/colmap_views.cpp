// COLMAP's text files: https://colmap.github.io/format.html
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "frame/input_file.h"
#include "scenes/import/view_import.h"
#include "scenes/refusal.h"
#include "scenes/scene_error.h"

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
        ++number_;
        return bool(std::getline(in_, line_));
    }
    /// The next line that is neither empty nor a comment; false at the end.
    bool next_record() {
        while (next_line())
            if (const auto at = line_.find_first_not_of(" \t\r"); at != std::string::npos && line_[at] != '#')
                return true;
        return false;
    }
    const std::string& text() const { return line_; }
    [[noreturn]] void fail(const std::string& why) const {
        refuse(file_, "line " + std::to_string(number_), why);
    }

  private:
    fs::path file_;
    std::ifstream in_;
    std::string line_;
    int number_ = 0;
};

/// The parameters of a model: how many focal lengths it has, and how many numbers of distortion.
struct ColmapModel {
    const char* name;
    int focal_lengths, distortions;
};
constexpr ColmapModel colmap_models[] = {{"SIMPLE_PINHOLE", 1, 0}, {"PINHOLE", 2, 0}, {"SIMPLE_RADIAL", 1, 1},
                                         {"RADIAL", 1, 2},         {"OPENCV", 2, 4},  {"FULL_OPENCV", 2, 8}};

const ColmapModel& model_named(const std::string& name, const ColmapLines& lines) {
    for (const ColmapModel& model : colmap_models)
        if (model.name == name) return model;
    lines.fail("camera model " + name +
               "; expected a pinhole: colmap image_undistorter makes PINHOLE cameras");
}

CalibratedCamera camera_of(std::istream& words, const ColmapLines& lines) {
    CalibratedCamera camera;
    std::string name;
    words >> name >> camera.width >> camera.height;
    const ColmapModel& model = model_named(name, lines);
    words >> camera.fx;
    camera.fy = camera.fx;
    if (model.focal_lengths == 2) words >> camera.fy;
    words >> camera.cx >> camera.cy;
    bool is_distorted = false;
    for (int i = 0; i < model.distortions; ++i) {
        double distortion = 0;
        words >> distortion;
        is_distorted = is_distorted || distortion != 0;
    }
    if (!words || !(words >> std::ws).eof())
        lines.fail("expected CAMERA_ID MODEL WIDTH HEIGHT and the numbers of " + name);
    if (is_distorted)
        lines.fail("a distorted image has no straight lines; colmap image_undistorter makes PINHOLE cameras");
    return camera;
}

std::map<long, CalibratedCamera> cameras_in(const fs::path& file) {
    std::map<long, CalibratedCamera> cameras;
    ColmapLines lines(file);
    while (lines.next_record()) {
        std::istringstream words(lines.text());
        long id = 0;
        if (!(words >> id)) lines.fail("expected CAMERA_ID MODEL WIDTH HEIGHT PARAMS");
        cameras[id] = camera_of(words, lines);
    }
    return cameras;
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

ImportedView image_at(const ColmapLines& lines, const std::map<long, CalibratedCamera>& cameras,
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
    CalibratedCamera camera = found->second;
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

std::vector<ImportedView> import_colmap(const fs::path& folder, const DepthRange& range) {
    const auto cameras = cameras_in(folder / "cameras.txt");
    ColmapLines lines(folder / "images.txt");
    std::vector<ImportedView> views;
    while (lines.next_record()) {
        views.push_back(image_at(lines, cameras, range));
        lines.next_line();  // the image's points, of which there may be none
    }
    require_unique_names(folder / "images.txt", views);
    return views;
}

}  // namespace zproof
