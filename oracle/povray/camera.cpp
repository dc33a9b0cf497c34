#include "oracle/povray/camera.h"

#include <cmath>

#include "frame/number_text.h"
#include "oracle/povray/text.h"

namespace zproof::oracle {
namespace {

/// Rays are aimed this far beside the pixels' centres, in px: POV-Ray asks each triangle by itself whether it
/// holds a point, so where an edge passes a centre exactly, rounding may let the ray slip between two
/// triangles. Scenes have such edges on purpose; none is an odd 4e-9 px off.
constexpr glm::dvec2 aim_offset_px{0x1p-28, -0.618 * 0x1p-28};

}  // namespace

/// POV-Ray's camera has no handedness of its own where right, up and direction are all given, nor must these
/// be at right angles: a window off the axis and a sheared view ray are a direction like any other.
std::string povray_camera_text(const View& view, const PovrayUnits& units) {
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

std::string povray_clip_text(const Camera& camera, const PovrayUnits& units) {
    std::string text = "clipped_by{plane{" + vector_text(camera.back) + "," + shortest(-units.near) + "}";
    if (std::isfinite(units.far))
        text += "plane{" + vector_text(-camera.back) + "," + shortest(units.far) + "}";
    return text + "}";
}

}  // namespace zproof::oracle
