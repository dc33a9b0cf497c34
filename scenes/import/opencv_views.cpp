#include "scenes/import/view_import.h"
#include "scenes/json_text.h"
#include "scenes/scene_error.h"
#include "scenes/scene_files.h"

namespace zproof {
namespace {

constexpr std::uint64_t largest_opencv_file = std::uint64_t{1} << 24;

int side_at(const LocatedValue& side) {
    if (!side.value().is_number_unsigned() || side.value() > 16384)
        side.fail("expected an integer from 1 to 16384");
    return side.value().get<int>();
}

/// The rows of a 3 x 3 matrix.
std::array<glm::dvec3, 3> rows_at(const LocatedValue& matrix) {
    if (!matrix.value().is_array() || matrix.value().size() != 3)
        matrix.fail("expected three rows of three numbers");
    return {matrix.at(std::size_t{0}).vector(), matrix.at(1).vector(), matrix.at(2).vector()};
}

void set_intrinsics(const LocatedValue& place, CalibratedCamera& camera) {
    const auto [x, y, w] = rows_at(place);
    if (x.y != 0) place.fail("expected no skew: K[0][1] = 0");
    if (y.x != 0 || w != glm::dvec3(0, 0, 1)) place.fail("expected [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]");
    camera.fx = x.x;
    camera.fy = y.y;
    camera.cx = x.z;
    camera.cy = y.z;
}

PixelCentre centre_of(const LocatedValue& view) {
    constexpr const char* expected =
        "expected \"integer\" (OpenCV: the first pixel's centre is (0, 0)) or \"half\"";
    if (!view.has("pixel_centre")) view.fail(std::string("\"pixel_centre\" is missing; ") + expected);
    const LocatedValue place = view.at("pixel_centre");
    if (place.value() == "integer") return PixelCentre::integer;
    if (place.value() == "half") return PixelCentre::half;
    place.fail(expected);
}

void refuse_distortion(const LocatedValue& view) {
    if (!view.has("distortion")) return;
    const LocatedValue list = view.at("distortion");
    if (!list.value().is_array()) list.fail("expected an array of numbers");
    for (std::size_t i = 0; i < list.value().size(); ++i)
        if (list.at(i).number() != 0)
            list.at(i).fail(
                "a distorted image has no straight lines; undistort the images (cv2.undistort) and "
                "leave it out");
}

ImportedView view_at(const LocatedValue& place, const DepthRange& range) {
    place.allow({"name", "width", "height", "pixel_centre", "K", "R", "t", "distortion"});
    refuse_distortion(place);
    CalibratedCamera camera;
    camera.name = view_name_of_image(place.at("name").text());
    camera.width = side_at(place.at("width"));
    camera.height = side_at(place.at("height"));
    camera.pixel_centre = centre_of(place);
    set_intrinsics(place.at("K"), camera);
    const auto [right, down, forward] = rows_at(place.at("R"));
    const glm::dvec3 t = place.at("t").vector();
    camera.right = right;
    camera.down = down;
    camera.forward = forward;
    camera.eye = -(t.x * right + t.y * down + t.z * forward);
    try {
        return view_of(camera, range);
    } catch (const SceneError& error) {
        place.fail(error.what());
    }
}

}  // namespace

std::vector<ImportedView> import_opencv(const std::filesystem::path& file, const DepthRange& range) {
    const Bytes bytes = read_file(file, largest_opencv_file);
    const auto content = parse_json(file, text_in(file, bytes));
    const LocatedValue root(file, content, "");
    root.allow({"views"});
    const LocatedValue list = root.at("views");
    if (!list.value().is_array()) list.fail("expected an array of views");
    std::vector<ImportedView> views;
    for (std::size_t i = 0; i < list.value().size(); ++i) views.push_back(view_at(list.at(i), range));
    require_unique_names(file, views);
    return views;
}

}  // namespace zproof
