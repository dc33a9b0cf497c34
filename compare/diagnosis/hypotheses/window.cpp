#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/other_world.h"

namespace zproof {

namespace {

Hypothesis seen_in(const DiagnosisInput& input, const Cause& cause, const View& view) {
    return shown_instead(input, cause, declared_scene(input), view);
}

/// The window with half-sides of these lengths, about the same centre.
View with_half_sides(const View& view, double half_width, double half_height) {
    View other = view;
    const Window& w = view.camera.window;
    const double u = (w.left + w.right) / 2, v = (w.bottom + w.top) / 2;
    other.camera.window = {u - half_width, u + half_width, v - half_height, v + half_height};
    return other;
}

/// Half-sides of the window by name.
std::vector<Hypothesis> of_windows(const DiagnosisInput& input) {
    const Window& w = input.view.camera.window;
    const double wide = (w.right - w.left) / 2, high = (w.top - w.bottom) / 2;
    const double aspect = wide / high;
    const auto window = [&](const Cause& cause, double half_width, double half_height) {
        return seen_in(input, cause, with_half_sides(input.view, half_width, half_height));
    };
    const char* halves = "Look at whether a number is a half-size or a size: xmag and ymag are half-sizes.";
    const char* scale = "Look at the projection's scale of that axis, and at the aspect.";
    const char* ratio = "Look at the aspect: it is the window's width by its height, not the picture's.";
    const char* square = "Look at the aspect: it comes from the camera, or is width by height, not 1.";
    const char* yfov = "Look at the axis that the field of view is of: glTF's yfov is the vertical one.";
    std::vector<Hypothesis> all{
        window({"the window is half as large", "Width and height are taken for half of themselves.", halves},
               wide / 2, high / 2),
        window({"the window is twice as large", "Width and height are taken for their halves.", halves},
               2 * wide, 2 * high),
        window({"the window is half as wide", "The width is taken for half of itself.", scale}, wide / 2,
               high),
        window({"the window is twice as wide", "The width is taken for its half.", scale}, 2 * wide, high),
        window({"the window is half as high", "The height is taken for half of itself.", scale}, wide,
               high / 2),
        window({"the window is twice as high", "The height is taken for its half.", scale}, wide, 2 * high)};
    for (const bool is_lower : {true, false}) {
        View quarter = input.view;
        quarter.camera.window.right = (w.left + w.right) / 2;
        (is_lower ? quarter.camera.window.top : quarter.camera.window.bottom) = (w.bottom + w.top) / 2;
        all.push_back(
            seen_in(input,
                    {is_lower ? "the image is the lower left quarter" : "the image is the upper left quarter",
                     "It is that of an image twice as wide and high.",
                     "Look at the framebuffer's size on dense displays, and at intrinsics of another size."},
                    quarter));
    }
    if (input.view.camera.projection == Projection::perspective) {
        const double times = std::tan(glm::degrees(std::atan(high))) / high;  // below 0 it turns the image
        View other = with_half_sides(input.view, std::abs(wide * times), std::abs(high * times));
        if (times < 0) other.camera.right = -other.camera.right, other.camera.up = -other.camera.up;
        all.push_back(seen_in(input,
                              {"the field of view is in degrees, read as radians",
                               "Tan of half the angle is that of its number of degrees.",
                               "Look at the angle's unit: tan takes radians."},
                              other));
    }
    const double width = input.view.width, height = input.view.height;
    if (wide * 3 != high * 4)
        all.push_back(window({"the aspect is 4 : 3", "The window is 4/3 times as wide as high.", square},
                             high * 4 / 3, high));
    if (wide * height != high * width) {
        all.push_back(window({"pixels are taken for square: the width follows the height",
                              "The window is as wide as square pixels of its height are.", ratio},
                             high * width / height, high));
        all.push_back(window({"pixels are taken for square: the height follows the width",
                              "The window is as high as square pixels of its width are.", ratio},
                             wide, wide * height / width));
    }
    if (wide == high) return all;
    all.push_back(
        window({"the window's width and height are exchanged", "The picture is as wide as it should be high.",
                "Look at the projection's arguments: x and y are exchanged."},
               high, wide));
    all.push_back(window({"the window is square: its height is its width as well",
                          "The aspect is taken for 1, and the width follows the height.", square},
                         high, high));
    all.push_back(window({"the window is square: its width is its height as well",
                          "The aspect is taken for 1, and the height follows the width.", square},
                         wide, wide));
    all.push_back(window({"the field of view belongs to the other axis",
                          "The angle that spans the height spans the width, or the other way round.", yfov},
                         high, high / aspect));
    all.push_back(window({"the field of view belongs to the other axis",
                          "The angle that spans the width spans the height, or the other way round.", yfov},
                         wide * aspect, wide));
    return all;
}

/// Numbers of a camera that are 0 in most.
std::vector<Hypothesis> of_offsets(const DiagnosisInput& input) {
    const View& view = input.view;
    const Window& w = view.camera.window;
    const glm::dvec2 offset((w.left + w.right) / 2, (w.bottom + w.top) / 2);
    const auto with_offset = [&](const glm::dvec2& other) {
        View moved = view;
        const glm::dvec2 step = other - offset;
        moved.camera.window = {w.left + step.x, w.right + step.x, w.bottom + step.y, w.top + step.y};
        return moved;
    };
    const auto with_shear = [&](const glm::dvec2& shear) {
        View sheared = view;
        sheared.camera.shear = shear;
        return sheared;
    };
    const glm::dvec2 per_px((w.right - w.left) / view.width, (w.top - w.bottom) / view.height);
    const glm::dvec2 centre_px(view.width / 2.0, view.height / 2.0),
        principal_px = centre_px + glm::dvec2(-offset.x, offset.y) / per_px;
    const glm::dvec2 aside_px = glm::dvec2(principal_px.y, principal_px.x) - centre_px;
    const char* sides =
        "Look at the projection's arguments: left, right, bottom and top need not lie about the axis.";
    const char* oblique = "Look at the projection of an oblique view: depth moves points aside.";
    std::vector<Hypothesis> all;
    if (principal_px.x != principal_px.y)
        all.push_back(seen_in(input,
                              {"the principal point's x and y are exchanged", "cx is taken for cy.",
                               "Look at the order of the intrinsics: rows are y."},
                              with_offset(glm::dvec2(-aside_px.x, aside_px.y) * per_px)));
    if (length(offset) > 0) {
        all.push_back(seen_in(
            input, {"the window's offset is ignored", "The window stands about the view axis.", sides},
            with_offset(glm::dvec2(0))));
        if (offset.x != 0 && offset.y != 0) {
            all.push_back(seen_in(
                input,
                {"the window's offset is ignored in x", "The window stands about the view axis in x.", sides},
                with_offset({0, offset.y})));
            all.push_back(seen_in(
                input,
                {"the window's offset is ignored in y", "The window stands about the view axis in y.", sides},
                with_offset({offset.x, 0})));
        }
        for (const glm::dvec2& sign : {glm::dvec2(-1, -1), glm::dvec2(-1, 1), glm::dvec2(1, -1)})
            if (sign * offset != offset)
                all.push_back(seen_in(input,
                                      {"the window's offset has the wrong sign",
                                       "The window stands on the other side of the view axis.", sides},
                                      with_offset(sign * offset)));
    }
    const glm::dvec2& shear = view.camera.shear;
    if (length(shear) > 0) {
        all.push_back(seen_in(input, {"the shear is ignored", "The view ray is the view axis.", oblique},
                              with_shear(glm::dvec2(0))));
        if (shear.x != 0 && shear.y != 0) {
            all.push_back(
                seen_in(input, {"the shear is ignored in x", "The view ray leans up or down alone.", oblique},
                        with_shear({0, shear.y})));
            all.push_back(seen_in(input,
                                  {"the shear is ignored in y", "The view ray leans aside alone.", oblique},
                                  with_shear({shear.x, 0})));
        }
        for (const glm::dvec2& sign : {glm::dvec2(-1, -1), glm::dvec2(-1, 1), glm::dvec2(1, -1)})
            if (sign * shear != shear)
                all.push_back(seen_in(
                    input, {"the shear has the wrong sign", "The view ray leans to the other side.", oblique},
                    with_shear(sign * shear)));
    }
    return all;
}

/// The declared camera sees the scene with every point p at turned(p): as if it stood elsewhere itself.
template <class Back>
View before_turned_scene(const View& view, Back turned_back) {
    View other = view;
    Camera& c = other.camera;
    c.eye_world = glm::vec3(turned_back(glm::dvec3(c.eye_world)));
    c.right = turned_back(c.right);
    c.up = turned_back(c.up);
    c.back = turned_back(c.back);
    return other;
}

std::vector<Hypothesis> of_scenes(const DiagnosisInput& input) {
    using Point = glm::dvec3;
    const auto turned = [&](const Cause& cause, auto turned_back) {
        return seen_in(input, cause, before_turned_scene(input.view, turned_back));
    };
    const char* handedness = "Look at the conversion between left-handed and right-handed axes.";
    return {turned({"z is up instead of y", "The scene is turned: (x, y, z) lies at (x, -z, y).",
                    "Look at the import: the file's y is up, and the scene was turned as if z were."},
                   [](const Point& p) { return Point(p.x, p.z, -p.y); }),
            turned({"y is up instead of z", "The scene is turned: (x, y, z) lies at (x, z, -y).",
                    "Look at the import: the scene was turned from z up to y up although y was up."},
                   [](const Point& p) { return Point(p.x, -p.z, p.y); }),
            turned({"the scene's z is negated: left-handed", "(x, y, z) lies at (x, y, -z).", handedness},
                   [](const Point& p) { return Point(p.x, p.y, -p.z); }),
            turned({"the scene's x is negated", "(x, y, z) lies at (-x, y, z).", handedness},
                   [](const Point& p) { return Point(-p.x, p.y, p.z); }),
            turned({"the scene's y is negated", "(x, y, z) lies at (x, -y, z).", handedness},
                   [](const Point& p) { return Point(p.x, -p.y, p.z); })};
}

glm::dvec3 mirrored(glm::dvec3 v, int axis) {
    v[axis] = -v[axis];
    return v;
}

std::vector<Hypothesis> of_cameras(const DiagnosisInput& input) {
    const Camera& c = input.view.camera;
    const char* forward = "Look at the camera's forward axis: it looks along -z.";
    const char* pose = "Look at the pose: camera-to-world is the inverse of world-to-camera.";
    const char* roll = "Look at the camera's axes, and at the picture's orientation.";
    const char* angles = "Look at the angles' signs and order.";
    const glm::dmat3 axes(c.right, c.up, c.back), turned_back = transpose(axes);
    const glm::dvec3 eye(c.eye_world), minus_translation = turned_back * eye;
    const auto pose_of = [&](const Cause& cause, const glm::dmat3& other_axes, const glm::dvec3& other_eye) {
        View view = input.view;
        Camera& other = view.camera;
        other.eye_world = glm::vec3(other_eye);
        other.right = other_axes[0], other.up = other_axes[1], other.back = other_axes[2];
        return seen_in(input, cause, view);
    };
    const auto camera = [&](const Cause& cause, const glm::dmat3& other_axes) {
        return pose_of(cause, other_axes, eye);
    };
    const glm::dquat q = glm::quat_cast(axes);
    return {
        camera({"the camera's rotation is transposed", "Its matrix is taken for its inverse.",
                "Look at the view matrix: rows against columns, or the camera's pose taken for its inverse."},
               transpose(glm::dmat3(c.right, c.up, c.back))),
        camera({"the camera looks backwards, upside down",
                "Its y and z are negated: axes of computer vision, y down and z ahead.",
                "Look at the camera's axes: OpenCV has y down and z ahead, OpenGL y up and z back."},
               glm::dmat3(c.right, -c.up, -c.back)),
        camera(
            {"the camera looks backwards", "Its x and z are negated: it is turned by half a turn.", forward},
            glm::dmat3(-c.right, c.up, -c.back)),
        camera({"the camera looks backwards, mirrored", "Its z is negated.", forward},
               glm::dmat3(c.right, c.up, -c.back)),
        camera({"the camera is turned by a quarter turn", "Its right axis is its up axis.", roll},
               glm::dmat3(c.up, -c.right, c.back)),
        camera({"the camera is turned by a quarter turn", "Its up axis is its right axis.", roll},
               glm::dmat3(-c.up, c.right, c.back)),
        pose_of({"the camera's pose is inverted", "The pose is taken for its inverse.", pose}, turned_back,
                -minus_translation),
        pose_of({"the view matrix's rotation is transposed", "Its translation is kept.", pose}, turned_back,
                turned_back * minus_translation),
        pose_of({"the view matrix's translation is taken for the eye", "Its rotation is right.", pose}, axes,
                -minus_translation),
        camera(
            {"the camera's pitch has the wrong sign", "It looks as far down as it should look up.", angles},
            glm::dmat3(mirrored(c.right, 1), -mirrored(c.up, 1), mirrored(c.back, 1))),
        camera(
            {"the camera's yaw has the wrong sign", "It looks as far left as it should look right.", angles},
            glm::dmat3(-mirrored(c.right, 0), mirrored(c.up, 0), mirrored(c.back, 0))),
        camera({"the camera's quaternion is read as (x, y, z, w)", "It is stored as (w, x, y, z).", angles},
               glm::mat3_cast(glm::dquat(q.z, q.w, q.x, q.y))),
        camera({"the camera's quaternion is read as (w, x, y, z)", "It is stored as (x, y, z, w).", angles},
               glm::mat3_cast(glm::dquat(q.x, q.y, q.z, q.w)))};
}

/// The other kind of projection, through a window of the same numbers.
std::vector<Hypothesis> of_projections(const DiagnosisInput& input) {
    View view = input.view;
    Camera& c = view.camera;
    if (c.projection == Projection::perspective) {
        if (!std::isfinite(c.far_depth)) return {};
        c.projection = Projection::parallel;
        return {seen_in(input,
                        {"a perspective is drawn as a parallel view", "Nothing is divided by depth.",
                         "Look at the division by w, and at which of the two matrices is used."},
                        view)};
    }
    if (c.near_depth <= 0) return {};
    c.projection = Projection::perspective;
    return {seen_in(input,
                    {"a parallel view is drawn as a perspective", "x and y are divided by depth.",
                     "Look at the division by w, which is 1, and at which matrix is used."},
                    view)};
}

/// Vertices of larger index than 16 bits hold.
std::vector<Hypothesis> of_short_indices(const DiagnosisInput& input) {
    if (input.scene.vertices.position_world.size() <= 0x10000) return {};
    const auto scene = std::make_shared<Scene>();
    scene->vertices.position_world = input.scene.vertices.position_world;
    for (const glm::uvec3& t : input.scene.triangles) scene->triangles.push_back(t & 0xFFFFu);
    return {shown_instead(
        input,
        {"vertex indices keep their low 16 bits",
         "Corners are those of the vertices whose index is the right one modulo 2^16.",
         "Look at the index buffer's type: 16 bits hold 65 536 vertices; use 32, or split the mesh."},
        scene, input.view)};
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_window(const DiagnosisInput& input) {
    std::vector<Hypothesis> all = of_windows(input);
    for (const auto& more : {of_offsets(input), of_scenes(input), of_cameras(input), of_projections(input),
                             of_short_indices(input)})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace zproof
