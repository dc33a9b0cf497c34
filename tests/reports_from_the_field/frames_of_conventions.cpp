/// Poses, intrinsics and pictures that were taken for those of another convention.
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "tests/reports_from_the_field/field_frames.h"
#include "tests/reports_from_the_field/field_scenes.h"
#include "tests/reports_from_the_field/ray_caster.h"

namespace zproof::field_reports {

namespace {

/// Pixel (x, y) holds what belongs to the index-th pixel; beyond all pixels nothing.
std::function<Shown()> stored(const View& view, const std::function<int(int x, int y)>& index_at) {
    return [=] {
        const Scene scene = yard();
        const Frame good = cast(scene, view);
        Frame frame = good;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const auto from = std::size_t(index_at(x, y));
                if (from >= good.primitive.pixels().size()) {
                    frame.primitive.at(x, y) = PrimitiveId::none;
                    frame.camera_depth.at(x, y) = background_depth;
                    continue;
                }
                frame.primitive.at(x, y) = good.primitive.pixels()[from];
                frame.camera_depth.at(x, y) = good.camera_depth.pixels()[from];
            }
        return Shown{scene, view, frame};
    };
}

/// A camera amid the scene that looks to the left and down a little, as another one sees it.
std::function<Shown()> posed(const std::function<void(Camera&, const glm::dmat3& axes)>& change) {
    View view = view_of_yard();
    const Camera aimed = look_at({0.4, 0.5, 1.5}, {0.1, 0.35, 0}, {0, 1, 0});
    Camera& c = view.camera;
    c.eye_world = aimed.eye_world;
    c.right = aimed.right, c.up = aimed.up, c.back = aimed.back;
    return seen_by(view, [=](Camera& other) { change(other, glm::dmat3(c.right, c.up, c.back)); });
}

void set_axes(Camera& c, const glm::dmat3& axes) { c.right = axes[0], c.up = axes[1], c.back = axes[2]; }

std::vector<FieldFrame> of_read_backs() {
    const View view = view_of_yard(72, 48), narrow = view_of_yard(70, 48), square = view_of_yard(64, 64);
    const int w = view.width, h = view.height, side = square.width;
    return {
        {"columns_first",
         {"columns are stored, and read as rows"},
         "MATLAB and Fortran store columns",
         stored(view, [=](int x, int y) { return (y * w + x) % h * w + (y * w + x) / h; })},
        {"rows_read_as_columns",
         {"rows are stored, and read as columns"},
         "numpy: reshape(W, H).T of rows",
         stored(view, [=](int x, int y) { return x * h + y; })},
        {"turned_left",
         {"the image is turned by a quarter turn, counterclockwise"},
         "numpy.rot90",
         stored(square, [=](int x, int y) { return x * side + side - 1 - y; })},
        {"turned_right",
         {"the image is turned by a quarter turn, clockwise"},
         "a phone's picture without its EXIF orientation",
         stored(square, [=](int x, int y) { return (side - 1 - x) * side + y; })},
        {"rows_padded",
         {"rows are read without their padding"},
         "GL_PACK_ALIGNMENT: rows begin at multiples of four bytes",
         stored(narrow,
                [=](int x, int y) {
                    const int at = y * narrow.width + x, pitch = narrow.width + 2;
                    return at % pitch < narrow.width ? at / pitch * narrow.width + at % pitch : -1;
                })},
        {"rows_not_padded",
         {"rows are read with padding that they do not have"},
         "a row pitch that was asked of another surface",
         stored(view, [=](int x, int y) { return y * (w + 1) + x; })},
        {"rows_from_below_off_by_one",
         {"the image is flipped in y, a row aside"},
         "row H - y for H - 1 - y",
         stored(view, [=](int x, int y) { return std::min(h - 1, h - y) * w + x; })},
    };
}

std::vector<FieldFrame> of_poses() {
    const auto mirrored = [](const glm::dmat3& axes, const glm::dvec3& sign, const glm::dvec3& of_axes) {
        return glm::dmat3(of_axes.x * sign * axes[0], of_axes.y * sign * axes[1], of_axes.z * sign * axes[2]);
    };
    return {
        {"pose_inverted",
         {"the camera's pose is inverted"},
         "NeRF: world-to-camera for camera-to-world",
         posed([](Camera& c, const glm::dmat3& axes) {
             c.eye_world = glm::vec3(-(glm::transpose(axes) * glm::dvec3(c.eye_world)));
             set_axes(c, glm::transpose(axes));
         })},
        {"rotation_transposed_alone",
         {"the view matrix's rotation is transposed"},
         "PyTorch3D: R for its transpose beside the right T",
         posed([](Camera& c, const glm::dmat3& axes) {
             c.eye_world = glm::vec3(glm::transpose(axes) * (glm::transpose(axes) * glm::dvec3(c.eye_world)));
             set_axes(c, glm::transpose(axes));
         })},
        {"translation_as_eye",
         {"the view matrix's translation is taken for the eye"},
         "COLMAP: t is no camera centre",
         posed([](Camera& c, const glm::dmat3& axes) {
             c.eye_world = glm::vec3(-(glm::transpose(axes) * glm::dvec3(c.eye_world)));
         })},
        {"pitch_negated",
         {"the camera's pitch has the wrong sign"},
         "an angle counted downwards",
         posed([=](Camera& c, const glm::dmat3& axes) {
             set_axes(c, mirrored(axes, {1, -1, 1}, {1, -1, 1}));
         })},
        {"yaw_negated",
         {"the camera's yaw has the wrong sign"},
         "an angle counted clockwise",
         posed([=](Camera& c, const glm::dmat3& axes) {
             set_axes(c, mirrored(axes, {-1, 1, 1}, {-1, 1, 1}));
         })},
        {"rolled_left",
         {"the camera is turned by a quarter turn"},
         "a camera held upright",
         posed(
             [](Camera& c, const glm::dmat3& axes) { set_axes(c, glm::dmat3(axes[1], -axes[0], axes[2])); })},
        {"rolled_right",
         {"the camera is turned by a quarter turn"},
         "a camera held upright",
         posed(
             [](Camera& c, const glm::dmat3& axes) { set_axes(c, glm::dmat3(-axes[1], axes[0], axes[2])); })},
        {"quaternion_of_scalar_first",
         {"the camera's quaternion is read as (x, y, z, w)"},
         "Blender and COLMAP have w first",
         posed([](Camera& c, const glm::dmat3& axes) {
             const glm::dquat q = glm::quat_cast(axes);
             set_axes(c, glm::mat3_cast(glm::dquat(q.z, q.w, q.x, q.y)));
         })},
        {"quaternion_of_scalar_last",
         {"the camera's quaternion is read as (w, x, y, z)"},
         "glTF, ROS and SciPy have w last",
         posed([](Camera& c, const glm::dmat3& axes) {
             const glm::dquat q = glm::quat_cast(axes);
             set_axes(c, glm::mat3_cast(glm::dquat(q.x, q.y, q.z, q.w)));
         })},
    };
}

std::vector<FieldFrame> of_intrinsics() {
    const View view = view_of_yard(96, 60);
    const auto quarter = [](bool is_lower) {
        return [=](Camera& c) {
            Window& w = c.window;
            w.right = (w.left + w.right) / 2;
            (is_lower ? w.top : w.bottom) = (w.bottom + w.top) / 2;
        };
    };
    return {
        {"lower_left_quarter",
         {"the image is the lower left quarter"},
         "a dense display's framebuffer is twice as large",
         seen_by(view, quarter(true))},
        {"upper_left_quarter",
         {"the image is the upper left quarter"},
         "intrinsics of an image twice as large",
         seen_by(view, quarter(false))},
        {"degrees_for_radians",
         {"the field of view is in degrees, read as radians"},
         "tan(50 / 2)",
         seen_by(view,
                 [](Camera& c) {
                     const double high = std::abs(std::tan(25.0)), wide = high * 96 / 60;
                     c.window = {-wide, wide, -high, high};
                     if (std::tan(25.0) < 0) c.right = -c.right, c.up = -c.up;
                 })},
        {"aspect_of_4_by_3",
         {"the aspect is 4 : 3"},
         "the example program's window is 800 x 600",
         seen_by(view,
                 [](Camera& c) {
                     c.window.left = c.window.bottom * 4 / 3;
                     c.window.right = c.window.top * 4 / 3;
                 })},
        {"cx_and_cy_exchanged",
         {"the principal point's x and y are exchanged"},
         "intrinsics in the order fx, fy, cy, cx",
         seen_by(view,
                 [](Camera& c) {
                     const double per_px = (c.window.right - c.window.left) / 96;
                     c.window = {-30 * per_px, 66 * per_px, -12 * per_px, 48 * per_px};
                 })},
    };
}

}  // namespace

std::vector<FieldFrame> frames_of_conventions() {
    std::vector<FieldFrame> all = of_read_backs();
    for (const auto& more : {of_poses(), of_intrinsics()}) all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace zproof::field_reports
