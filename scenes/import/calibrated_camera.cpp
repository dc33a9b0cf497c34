#include "scenes/import/calibrated_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "scenes/scene_error.h"
#include "scenes/view_document.h"

namespace zproof {
namespace {

[[noreturn]] void refuse_camera(const char* field, const char* expected) {
    throw SceneError(std::string("camera ") + field + ": expected " + expected);
}

double largest_component(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Raster x is the coordinate of the principal point plus this.
double offset_of(PixelCentre centre) { return centre == PixelCentre::integer ? 0.5 : 0; }

Window window_of_pixels(const CalibratedCamera& c) {
    const double cx = c.cx + offset_of(c.pixel_centre), cy = c.cy + offset_of(c.pixel_centre);
    return {.left = -cx / c.fx,
            .right = (c.width - cx) / c.fx,
            .bottom = (cy - c.height) / c.fy,
            .top = cy / c.fy};
}

struct CameraAxes {
    glm::dvec3 right, up, back;
};

/// Off a rotation by at most this, in any product of two axes.
double defect_of(const CameraAxes& axes) {
    const auto& [right, up, back] = axes;
    const glm::dvec3 squares{glm::dot(right, right) - 1, glm::dot(up, up) - 1, glm::dot(back, back) - 1};
    const glm::dvec3 products{glm::dot(right, up), glm::dot(up, back), glm::dot(back, right)};
    return std::max(largest_component(squares), largest_component(products));
}

/// Twice: the second time removes what the first left by rounding.
CameraAxes orthonormal(CameraAxes axes) {
    for (int i = 0; i < 2; ++i) {
        axes.back = glm::normalize(axes.back);
        axes.right = glm::normalize(axes.right - glm::dot(axes.right, axes.back) * axes.back);
        axes.up = glm::cross(axes.back, axes.right);
    }
    return axes;
}

CameraAxes rotation_of(const CalibratedCamera& c) {
    const CameraAxes stated{c.right, -c.down, -c.forward};
    constexpr double five_digits = 1e-4, of_a_camera = 1e-12;
    const double defect = defect_of(stated);
    if (!(defect <= five_digits))
        refuse_camera("pose", "a rotation: axes of length 1 at right angles, within 1e-4");
    if (glm::dot(glm::cross(stated.right, stated.up), stated.back) < 0)
        refuse_camera("pose", "a rotation; this one is a mirror image");
    return defect <= of_a_camera / 2 ? stated : orthonormal(stated);
}

void check(const CalibratedCamera& c) {
    for (const double focal : {c.fx, c.fy})
        if (!(focal > 0) || std::isinf(focal))
            refuse_camera("focal length", "a finite number above 0, in pixels");
    if (!std::isfinite(c.cx) || !std::isfinite(c.cy)) refuse_camera("principal point", "finite numbers");
    constexpr int largest_side = 16384;  // of a view file
    if (c.width < 1 || c.height < 1 || c.width > largest_side || c.height > largest_side)
        refuse_camera("size", "1 to 16384 pixels on either side");
}

}  // namespace

ImportedView view_of(const CalibratedCamera& c, const DepthRange& range) {
    check(c);
    const CameraAxes axes = rotation_of(c);
    View view{.name = c.name, .camera = {}, .width = c.width, .height = c.height};
    view.camera.eye_world = glm::vec3(c.eye);
    view.camera.right = axes.right;
    view.camera.up = axes.up;
    view.camera.back = axes.back;
    view.camera.window = window_of_pixels(c);
    view.camera.near_depth = range.near_depth;
    view.camera.far_depth = range.far_depth;
    validate(view.camera);
    const Adjustment adjustment{
        .eye = largest_component(glm::dvec3(view.camera.eye_world) - c.eye),
        .axes = std::max({largest_component(axes.right - c.right), largest_component(axes.up + c.down),
                          largest_component(axes.back + c.forward)})};
    return {view, adjustment};
}

std::string view_name_of_image(const std::string& file) {
    const auto path = std::filesystem::path(file).lexically_normal().replace_extension();
    return view_name(path.generic_string());
}

}  // namespace zproof
