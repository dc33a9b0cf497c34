#include "oracle/povray_scene.h"

#include <cmath>

#include "oracle/povray_geometry.h"
#include "oracle/povray_text.h"

namespace zproof::oracle {
namespace {

/// Rays are aimed this far beside the pixels' centres, in px: POV-Ray asks each triangle by itself whether it
/// holds a point, so where an edge passes a centre exactly, rounding may let the ray slip between two
/// triangles. Scenes have such edges on purpose; none is an odd 4e-9 px off.
constexpr glm::dvec2 aim_offset_px{0x1p-28, -0.618 * 0x1p-28};

/// POV-Ray's camera has no handedness of its own where right, up and direction are all given, nor must these
/// be at right angles: a window off the axis and a sheared line of sight are a direction like any other.
std::string camera_text(const View& view, const PovrayUnits& units) {
    const Camera& camera = view.camera;
    const Window& w = camera.window;
    const bool perspective = camera.projection == Projection::perspective;
    const double size = perspective ? 1 : units.scale;
    const double across = w.right - w.left, along = w.top - w.bottom;
    const glm::dvec3 to_centre =
        size * (((w.left + w.right) / 2 + across * aim_offset_px.x / view.width) * camera.right +
                ((w.bottom + w.top) / 2 - along * aim_offset_px.y / view.height) * camera.up);
    const glm::dvec3 ahead = camera.shear.x * camera.right + camera.shear.y * camera.up - camera.back;
    const glm::dvec3 location = perspective ? glm::dvec3(0) : to_centre + units.start * ahead;
    const glm::dvec3 direction = perspective ? to_centre + ahead : ahead;
    std::string text = perspective ? "camera{perspective" : "camera{orthographic";
    text += " location " + vector_text(location) + " direction " + vector_text(direction);
    text += " right " + vector_text(size * across * camera.right);
    return text += " up " + vector_text(size * along * camera.up) + "}\n";
}

std::string depth_expression(const Camera& camera) {
    const glm::dvec3 ahead = -camera.back;
    return number_text(ahead.x) + "*x+" + number_text(ahead.y) + "*y+" + number_text(ahead.z) + "*z";
}

std::string clip_text(const Camera& camera, const PovrayUnits& units) {
    std::string text = "clipped_by{plane{" + vector_text(camera.back) + "," + number_text(-units.near) + "}";
    if (std::isfinite(units.far))
        text += "plane{" + vector_text(-camera.back) + "," + number_text(units.far) + "}";
    return text + "}";
}

void append_triangle(std::string& text, const PovrayTriangle& triangle, const PovrayCode& code) {
    const auto [red, green] = code.colour_of(triangle.primitive);
    text += "triangle{" + vector_text(triangle.corner[0]) + "," + vector_text(triangle.corner[1]) + "," +
            vector_text(triangle.corner[2]) + "pigment{average pigment_map{[2 rgb<" + number_text(2 * red) +
            "," + number_text(2 * green) + ",0>][1 Lower][1 Upper]}}}\n";
}

/// The box is there for its size alone: it is in no picture (no_image), yet in the merge's own box, which
/// POV-Ray would otherwise draw too tight for its own arithmetic. (In a union, no_image does not count.)
void append_cluster(std::string& text, const PovrayCluster& cluster, const PovrayCode& code,
                    const std::string& clip) {
    text += "merge{box{" + vector_text(cluster.lowest) + "," + vector_text(cluster.highest) + "no_image}\n";
    for (const PovrayTriangle& triangle : cluster.triangles) append_triangle(text, triangle, code);
    if (cluster.cut == Cut::by_near_or_far) text += clip;
    text += "}\n";
}

}  // namespace

PovrayScene povray_scene(const Scene& scene, const View& view) {
    const Camera& camera = view.camera;
    const PovrayGeometry geometry = povray_geometry(scene, view);
    const PovrayUnits& units = geometry.units;
    const bool perspective = camera.projection == Projection::perspective;
    PovrayCode code(scene.triangles.size(), perspective ? DepthSteps::logarithmic : DepthSteps::linear,
                    units.low, units.high);
    std::string text =
        "#version 3.7;\n"
        "global_settings{assumed_gamma 1}\n"
        "#default{finish{ambient 0 diffuse 0 emission 1}}\n"
        "background{rgb 0}\n" +
        camera_text(view, units) + code.depth_pigments(depth_expression(camera));
    const std::string clip = clip_text(camera, units);
    for (const PovrayCluster& cluster : geometry.clusters) append_cluster(text, cluster, code, clip);
    return {std::move(text), code, units.scale};
}

}  // namespace zproof::oracle
