/// Pixels that look elsewhere: grids, windows, samples and cameras.
#include <cmath>

#include "tests/reports_from_the_field/field_frames.h"
#include "tests/reports_from_the_field/field_scenes.h"
#include "tests/reports_from_the_field/ray_caster.h"

namespace zproof::field_reports {

namespace {

using Aim = std::function<glm::dvec2(int x, int y)>;

Shown aimed(const View& view, const Aim& aims_at) {
    const Scene scene = yard();
    return {scene, view, cast(scene, view, {.aims_at = aims_at})};
}

std::function<Shown()> aiming(const View& view, const Aim& aims_at) {
    return [=] { return aimed(view, aims_at); };
}

/// Every corner of the scene is moved before it is drawn.
std::function<Shown()> moved(const std::function<glm::vec3(const glm::vec3&)>& move) {
    return [=] {
        const Scene scene = yard();
        Scene other = scene;
        for (glm::vec3& p : other.vertices.position_world) p = move(p);
        const View view = view_of_yard();
        return Shown{scene, view, cast(other, view)};
    };
}

/// So are those of one part alone.
std::function<Shown()> part_moved(std::size_t part, const glm::vec3& by) {
    return [=] {
        const Scene scene = yard();
        Scene other = scene;
        const Part& p = scene.parts[part];
        for (std::uint32_t t = p.first_triangle; t < p.first_triangle + p.triangle_count; ++t)
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t vertex = scene.triangles[t][corner];
                other.vertices.position_world[vertex] = scene.vertices.position_world[vertex] + by;
            }
        const View view = view_of_yard();
        return Shown{scene, view, cast(other, view)};
    };
}

Aim beside_the_centre(double dx, double dy) {
    return [=](int x, int y) { return glm::dvec2(x + 0.5 + dx, y + 0.5 + dy); };
}

/// Each 2 x 2 pixels show one answer.
Aim of_quads(double at) {
    return [=](int x, int y) { return glm::dvec2((x & ~1) + at, (y & ~1) + at); };
}

struct Rectangle {
    int x0, y0, x1, y1;
};

/// A rectangle still shows the frame before, in which the camera stood elsewhere.
Shown stale(const Rectangle& r) {
    const Scene scene = yard();
    const View view = view_of_yard();
    View before = view;
    before.camera.eye_world += glm::vec3(0.05f, 0.02f, 0.03f);
    Frame frame = cast(scene, view);
    const Frame old = cast(scene, before);
    for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x) {
            frame.primitive.at(x, y) = old.primitive.at(x, y);
            frame.camera_depth.at(x, y) = old.camera_depth.at(x, y);
        }
    return {scene, view, frame};
}

void transpose(Camera& c) {
    const glm::dmat3 rotation = glm::transpose(glm::dmat3(c.right, c.up, c.back));
    c.right = rotation[0];
    c.up = rotation[1];
    c.back = rotation[2];
}

/// A camera amid the scene whose axes were multiplied.
std::function<Shown()> turned(double right, double up, double back) {
    return [=] {
        View view = view_of_yard();
        const Camera level = look_at({-1.5, 0.6, 1.2}, {-1.2, 0.5, -5}, {0, 1, 0});
        view.camera.eye_world = level.eye_world;
        view.camera.right = level.right;
        view.camera.up = level.up;
        view.camera.back = level.back;
        View other = view;
        other.camera.right *= right;
        other.camera.up *= up;
        other.camera.back *= back;
        const Scene scene = yard();
        return Shown{scene, view, cast(scene, other)};
    };
}

/// A window whose centre lies (0.11, -0.07) beside the axis.
std::function<Shown()> offset_taken_for(const glm::dvec2& other) {
    return [=] {
        View view = view_of_yard(), drawn = view;
        const auto move = [](Window& w, const glm::dvec2& by) {
            w = {w.left + by.x, w.right + by.x, w.bottom + by.y, w.top + by.y};
        };
        move(view.camera.window, {0.11, -0.07});
        move(drawn.camera.window, other);
        const Scene scene = yard();
        return Shown{scene, view, cast(scene, drawn)};
    };
}

std::vector<FieldFrame> of_grids() {
    const View small = view_of_yard(64, 48);
    const double w = small.width, h = small.height;
    const RayPrecision ray{.arithmetic = Arithmetic::float32};
    return {
        {"corner_to_corner",
         {"the pixel grid is stretched by W/(W - 1)"},
         "trimesh #758: rays by grid_linspace from side to side of the picture",
         aiming(small, [=](int x, int y) { return glm::dvec2(x * w / (w - 1), y * h / (h - 1)); })},
        {"corner_to_corner_inverse",
         {"the pixel grid is shrunk by (W - 1)/W"},
         "zproof #43: the inverse of trimesh #758",
         aiming(small,
                [=](int x, int y) {
                    return glm::dvec2((x + 0.5) * (w - 1) / w + 0.5, (y + 0.5) * (h - 1) / h + 0.5);
                })},
        {"viewport_one_less",
         {"the pixel grid is stretched by W/(W - 1) from the top left corner"},
         "pytorch3d #548: pixels W - 1 and H - 1 are mapped to 1",
         aiming(small,
                [=](int x, int y) { return glm::dvec2((x + 0.5) * w / (w - 1), (y + 0.5) * h / (h - 1)); })},
        {"viewport_one_less_in_x",
         {"the pixel grid is stretched by W/(W - 1) from the left side"},
         "pytorch3d #548, in x alone",
         aiming(small, [=](int x, int y) { return glm::dvec2((x + 0.5) * w / (w - 1), y + 0.5); })},
        {"pixel_corner",
         {"the image is shifted by (+1/2, +1/2) px"},
         "raysect #391, VisRTX #327: rays through the pixel's corner instead of its centre",
         aiming(view_of_yard(), beside_the_centre(-0.5, -0.5))},
        {"sample_0_of_4",
         {"pixels are sampled at sample 0 of 4"},
         "zproof #43: multisample position (0.375, 0.125) instead of the centre",
         aiming(view_of_yard(), beside_the_centre(-0.125, -0.375))},
        {"sample_2_of_8",
         {"pixels are sampled at sample 2 of 8"},
         "zproof #43: another multisample position",
         aiming(view_of_yard(), beside_the_centre(5.0 / 16, 1.0 / 16))},
        {"sample_0_of_2",
         {"pixels are sampled at sample 0 of 2"},
         "zproof #43: another multisample position",
         aiming(view_of_yard(), beside_the_centre(4.0 / 16, 4.0 / 16))},
        {"sample_11_of_16_of_a_caster",
         {"pixels are sampled at sample 11 of 16"},
         "zproof #43: another multisample position, of a renderer that declares rays",
         aiming(view_of_yard(), beside_the_centre(-6.0 / 16, 4.0 / 16)),
         ray},
        {"corner_to_corner_of_a_caster",
         {"the pixel grid is stretched by W/(W - 1)"},
         "trimesh #758, of a renderer that declares rays",
         aiming(small, [=](int x, int y) { return glm::dvec2(x * w / (w - 1), y * h / (h - 1)); }),
         ray},
        {"viewport_one_more",
         {"the pixel grid is shrunk by (W - 1)/W from the top left corner"},
         "zproof #43: the inverse of pytorch3d #548",
         aiming(small,
                [=](int x, int y) { return glm::dvec2((x + 0.5) * (w - 1) / w, (y + 0.5) * (h - 1) / h); })},
        {"pixel_to_the_right",
         {"the image is shifted by (-1, 0) px"},
         "zproof #43: a whole pixel aside",
         aiming(view_of_yard(), beside_the_centre(1, 0))},
        {"rows_from_below",
         {"the image is flipped in y"},
         "nvdiffrast #91: row 0 is the lowest",
         aiming(small, [=](int x, int y) { return glm::dvec2(x + 0.5, h - 0.5 - y); })},
        {"coarse_pixels_of_a_caster",
         {"2 x 2 pixels show what belongs to their common corner"},
         "zproof #43: 2x2 coarse pixels, of a renderer that declares rays",
         aiming(view_of_yard(), of_quads(1)),
         ray},
        {"coarse_pixels_of_4",
         {"4 x 4 pixels show what belongs to their common corner"},
         "zproof #43: 4x4 coarse pixels",
         aiming(view_of_yard(), [](int x, int y) { return glm::dvec2((x & ~3) + 2, (y & ~3) + 2); })},
        {"shift_of_7_12",
         {"the image is shifted by a fraction of a pixel"},
         "zproof #43: a shift of 7/12 px",
         aiming(view_of_yard(), beside_the_centre(7.0 / 12, -1.0 / 12))},
        {"coarse_pixels",
         {"2 x 2 pixels show what belongs to their common corner"},
         "zproof #43: 2x2 coarse pixels",
         aiming(view_of_yard(), of_quads(1))},
        {"coarse_pixels_first",
         {"2 x 2 pixels show what belongs to the first"},
         "zproof #43: 2x2 coarse pixels, sampled at the first",
         aiming(view_of_yard(), of_quads(0.5))},
        {"tear",
         {"part of the picture shows another view"},
         "zproof #43: a rectangle of another frame",
         [] {
             return stale({10, 20, 70, 50});
         }},
        {"stale_tile",
         {"tiles of 32 px show another view"},
         "a tile of the frame before",
         [] {
             return stale({32, 32, 64, 64});
         }},
    };
}

std::vector<FieldFrame> of_windows() {
    const View wide = parallel_view_of_yard(2, 1, 96, 48), less_wide = parallel_view_of_yard(2, 1.25, 96, 60);
    const View perspective = view_of_yard();
    const auto scaled = [](double x, double y) {
        return [=](Camera& c) {
            const Window& w = c.window;
            c.window = {w.left * x, w.right * x, w.bottom * y, w.top * y};
        };
    };
    return {
        {"xmag_ymag_exchanged",
         {"the window's width and height are exchanged"},
         "zproof #43: xmag 2, ymag 1 exchanged",
         seen_by(wide,
                 [](Camera& c) {
                     c.window = {-1, 1, -2, 2};
                 })},
        {"mag_halved",
         {"the window is half as large"},
         "three.js PR #19221: xmag / -2, xmag / 2 for an orthographic camera of glTF",
         seen_by(wide, scaled(0.5, 0.5))},
        {"mag_doubled",
         {"the window is twice as large"},
         "three.js #24800: orthographic cameras are twice as big",
         seen_by(wide, scaled(2, 2))},
        {"mag_of_y_for_both",
         {"the window is square: its height is its width as well"},
         "glTF-Blender-IO #944: xmag = ymag",
         seen_by(less_wide,
                 [](Camera& c) {
                     c.window = {-1.25, 1.25, -1.25, 1.25};
                 })},
        {"aspect_of_1",
         {"the window is square: its height is its width as well"},
         "OpenJKDF2 #36: the original projects with an aspect of 1",
         seen_by(perspective,
                 [](Camera& c) {
                     c.window = {c.window.bottom, c.window.top, c.window.bottom, c.window.top};
                 })},
        {"principal_point_ignored",
         {"the window's offset is ignored"},
         "zproof #43: a window that is not centred, drawn centred",
         offset_taken_for({0, 0})},
        {"principal_point_on_the_other_side",
         {"the window's offset has the wrong sign"},
         "zproof #43: the offset's y counts down",
         offset_taken_for({0.11, 0.07})},
        {"parallel_as_perspective",
         {"a parallel view is drawn as a perspective"},
         "zproof #43: a matrix of the other kind",
         seen_by(wide, [](Camera& c) { c.projection = Projection::perspective; })},
        {"perspective_as_parallel",
         {"a perspective is drawn as a parallel view"},
         "zproof #43: a matrix of the other kind",
         seen_by(perspective, [](Camera& c) { c.projection = Projection::parallel; })},
        {"twice_as_wide",
         {"the window is twice as wide"},
         "zproof #43: the window scaled in x",
         seen_by(perspective, scaled(2, 1))},
        {"half_as_wide",
         {"the window is half as wide"},
         "zproof #43: the window scaled in x",
         seen_by(perspective, scaled(0.5, 1))},
        {"twice_as_high",
         {"the window is twice as high"},
         "zproof #43: the window scaled in y",
         seen_by(less_wide, scaled(1, 2))},
        {"half_as_high",
         {"the window is half as high"},
         "zproof #43: the window scaled in y",
         seen_by(perspective, scaled(1, 0.5))},
        {"mag_of_x_for_both",
         {"the window is square: its width is its height as well"},
         "glTF-Blender-IO #944: ymag = xmag",
         seen_by(less_wide,
                 [](Camera& c) {
                     c.window = {-2, 2, -2, 2};
                 })},
        {"aspect_of_1_of_a_caster",
         {"the window is square: its height is its width as well"},
         "OpenJKDF2 #36, of a renderer that declares rays",
         seen_by(perspective,
                 [](Camera& c) {
                     c.window = {c.window.bottom, c.window.top, c.window.bottom, c.window.top};
                 }),
         RayPrecision{.arithmetic = Arithmetic::float32}},
        {"field_of_view_of_the_wider_axis",
         {"the field of view belongs to the other axis"},
         "playcanvas #266: horizontal instead of vertical",
         seen_by(perspective, scaled(4.0 / 3, 4.0 / 3))},
        {"field_of_view_of_the_other_axis",
         {"the field of view belongs to the other axis"},
         "tungsten #23, photon-v2 #46: the angle is taken for the other axis",
         seen_by(perspective, scaled(0.75, 0.75))},
    };
}

std::vector<FieldFrame> of_cameras() {
    const View view = view_of_yard();
    return {
        {"node_of_another_parent",
         {"a part of the scene stands elsewhere"},
         "a parent's translation is left out",
         part_moved(1, {0.25f, 0.125f, 0})},
        {"mesh_that_failed_to_load",
         {"some parts are not drawn"},
         "a file that is missing costs its node",
         part_moved(2, {0, 0, 1000})},
        {"z_up", {"z is up instead of y"}, "zproof #43: y up against z up", moved([](const glm::vec3& p) {
             return glm::vec3(p.x, -p.z, p.y);
         })},
        {"z_up_the_other_way",
         {"y is up instead of z"},
         "zproof #43: the same, turned the other way",
         moved([](const glm::vec3& p) { return glm::vec3(p.x, p.z, -p.y); })},
        {"left_handed",
         {"the scene's z is negated: left-handed"},
         "zproof #43: left-handed",
         moved([](const glm::vec3& p) { return glm::vec3(p.x, p.y, -p.z); })},
        {"mirrored_x",
         {"the scene's x is negated"},
         "zproof #43: one axis negated",
         moved([](const glm::vec3& p) { return glm::vec3(-p.x, p.y, p.z); })},
        {"transposed_rotation",
         {"the camera's rotation is transposed"},
         "pytorch3d #1183: cameras do not transpose the rotation matrix",
         seen_by(view, transpose)},
        {"mirrored_y",
         {"the scene's y is negated"},
         "zproof #43: one axis negated",
         moved([](const glm::vec3& p) { return glm::vec3(p.x, -p.y, p.z); })},
        {"looks_backwards_upside_down",
         {"the camera looks backwards, upside down"},
         "pyrender #228, pytorch3d #522: OpenCV's axes (y down, z ahead), of a camera amid the scene",
         turned(1, -1, -1)},
        {"looks_backwards", {"the camera looks backwards"}, "zproof #43: x and z negated", turned(-1, 1, -1)},
        {"looks_backwards_mirrored",
         {"the camera looks backwards, mirrored"},
         "zproof #43: z negated",
         turned(1, 1, -1)},
    };
}

void turn(Camera& c, double angle) {
    const glm::dvec3 right = c.right, back = c.back;
    c.right = std::cos(angle) * right + std::sin(angle) * back;
    c.back = std::cos(angle) * back - std::sin(angle) * right;
}

/// A pixel lies at the place of its ray times 1 + k1 r^2, at depth 1; or the other way round.
Aim distorted(const View& view, double k1, bool of_the_ray) {
    const glm::dvec2 half(view.camera.window.right, view.camera.window.top);
    const glm::dvec2 half_px(view.width / 2.0, view.height / 2.0);
    std::vector<glm::dvec2> aims;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const glm::dvec2 pixel = (glm::dvec2(x, y) + 0.5 - half_px) / half_px * half;
            glm::dvec2 ray = pixel;
            for (int i = 0; i < 100; ++i) ray = pixel / (1 + k1 * dot(ray, ray));
            if (!of_the_ray) ray = pixel * (1 + k1 * dot(pixel, pixel));
            aims.push_back(ray / half * half_px + half_px);
        }
    return [aims, width = view.width](int x, int y) { return aims[std::size_t(y * width + x)]; };
}

/// Cameras that are off by a number.
std::vector<FieldFrame> of_other_numbers() {
    const View view = view_of_yard();
    const auto scaled = [=](double x, double y) {
        return seen_by(view, [=](Camera& c) {
            const Window& w = c.window;
            c.window = {w.left * x, w.right * x, w.bottom * y, w.top * y};
        });
    };
    const double half_angle = std::atan(view.camera.window.top);
    const double of_the_angle = std::tan(half_angle / 2) / std::tan(half_angle);
    const auto moved_by = [=](const glm::vec3& step) {
        return seen_by(view, [=](Camera& c) { c.eye_world += step; });
    };
    const RayPrecision ray{.arithmetic = Arithmetic::float32};
    return {
        {"focal_length_of_another_sensor", {"the window is scaled"}, "a factor of 1.15", scaled(1.15, 1.15)},
        {"focal_length_rounded", {"the window is scaled"}, "a factor of 1.0025", scaled(1.0025, 1.0025)},
        {"angle_halved",
         {"the window is scaled"},
         "tan of a quarter of the field of view",
         scaled(of_the_angle, of_the_angle)},
        {"focal_length_of_a_caster",
         {"the window is scaled"},
         "a factor of 0.9, declared rays",
         scaled(0.9, 0.9),
         ray},
        {"fx_alone", {"the window is scaled in x"}, "fx off by 3 %", scaled(0.97, 1)},
        {"fy_alone", {"the window is scaled in y"}, "fy off by 0.5 %", scaled(1, 1.005)},
        {"fx_and_fy", {"the window is scaled in x and in y"}, "two factors", scaled(1.1, 0.93)},
        {"principal_point_by_less_than_a_pixel",
         {"the image is shifted by a fraction of a pixel"},
         "cx off by 0.8 px",
         aiming(view, beside_the_centre(0.8, 0))},
        {"principal_point_by_pixels",
         {"the principal point lies elsewhere"},
         "cx and cy off by 5.2 and -3.25 px",
         aiming(view, beside_the_centre(5.2, -3.25))},
        {"focal_length_and_principal_point",
         {"the window is scaled and lies elsewhere"},
         "fx, fy, cx and cy of another camera",
         aiming(view, [](int x, int y) { return glm::dvec2(1.05 * x + 2.25, 1.05 * y - 1.5); })},
        {"lens_left_in",
         {"the image is distorted radially"},
         "a lens of OpenCV's model, k1 = -0.21",
         aiming(view, distorted(view, -0.21, true))},
        {"lens_of_a_caster",
         {"the image is distorted radially"},
         "the same, k1 = 0.03, of a renderer that declares rays",
         aiming(view, distorted(view, 0.03, true)),
         ray},
        {"lens_undone",
         {"the image is distorted radially"},
         "a lens that there is not is undone, k1 = 0.12",
         aiming(view, distorted(view, 0.12, false))},
        {"eye_moved", {"the camera stands elsewhere"}, "the other eye of a pair", moved_by({0.0625f, 0, 0})},
        {"camera_turned",
         {"the camera is turned"},
         "half a degree about its up axis",
         seen_by(view, [](Camera& c) { turn(c, 0.00873); })},
        {"camera_of_another_frame",
         {"the camera stands elsewhere and is turned"},
         "the pose of the next frame",
         seen_by(view,
                 [](Camera& c) {
                     c.eye_world += glm::vec3(0.05f, 0.02f, 0.03f);
                     turn(c, -0.0125);
                 })},
    };
}

}  // namespace

std::function<Shown()> seen_by(const View& view, const std::function<void(Camera&)>& change) {
    return [=] {
        View other = view;
        change(other.camera);
        const Scene scene = yard();
        return Shown{scene, view, cast(scene, other)};
    };
}

std::vector<FieldFrame> frames_of_place() {
    std::vector<FieldFrame> all = of_grids();
    for (const auto& more : {of_windows(), of_cameras(), of_other_numbers(), frames_of_conventions()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace zproof::field_reports
