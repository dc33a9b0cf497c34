#include "scenes/judged_ranges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <sstream>

#include "scenes/largest.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

constexpr double largest_slope = 1e4;        ///< sideways per unit of depth: sides of windows, shear
constexpr double least_slope = 1e-10;        ///< of a window; below it Embree's boxes take rays for straight
constexpr double least_window_share = 1e-7;  ///< of what is rounded with it
constexpr double least_slab_share = 1e-6;    ///< of the farther plane's depth
constexpr double least_volume = 1e-22;       ///< scene units cubed

/// A quantity of a camera, the range in which it is judged, and the remedy.
struct RangeCheck {
    const char* quantity;
    double value, least, most;
    const char* remedy;

    bool holds() const { return least <= value && value <= most; }  // false for NaN
    std::string message() const {
        std::ostringstream text;
        text << "camera: " << quantity << " is " << value << "; judged ";
        if (most == unlimited)
            text << "from " << least << " on";
        else if (least == 0)
            text << "up to " << most;
        else
            text << "from " << least << " to " << most;
        text << "; " << remedy << " (docs/scenes.md)";
        return text.str();
    }
};

/// What a window shows in one direction: the sides that float32 rounds, and what is rounded with them.
struct Span {
    double low, high, beside = 0;

    double reach() const { return std::max(std::abs(low), std::abs(high)); }
    double share() const { return (high - low) / (reach() + beside); }
};

/// The farthest plane of a parallel projection.
double farthest_plane(const Camera& camera) {
    return std::max(std::abs(camera.near_depth), std::abs(camera.far_depth));
}

/// NaN where a coordinate is.
double largest_of(const glm::dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return std::isnan(v.x + v.y + v.z) ? v.x + v.y + v.z : largest;
}

/// What float32 rounds along an axis beside the window: a parallel ray's origin coordinate by coordinate, and
/// what its direction comes to at the farther plane.
double rounded_along(const glm::dvec3& axis, double shear, const Camera& camera) {
    if (camera.projection == Projection::perspective) return 0;
    return glm::dot(glm::abs(axis), glm::abs(glm::dvec3(camera.eye_world))) +
           std::abs(shear) * farthest_plane(camera);
}

constexpr const char* scale_down = "scale the scene down, or move it to the origin";
constexpr const char* scale_up = "scale the scene up, or move the near plane away from the eye";
constexpr const char* widen = "widen the window, or move it to the middle of the view";

std::string first_outside(std::initializer_list<RangeCheck> checks) {
    const auto outside = std::ranges::find_if_not(checks, &RangeCheck::holds);
    return outside == checks.end() ? "" : outside->message();
}

std::string outside_of_perspective(const Camera& c, const Span& u, const Span& v) {
    const double near_volume = c.near_depth * (c.near_depth * u.reach()) * (c.near_depth * v.reach());
    return first_outside({
        {"the near plane's depth", c.near_depth, 0, largest_judged_coordinate, scale_down},
        {"the window's farthest side, at depth 1,", std::max(u.reach(), v.reach()), least_slope,
         largest_slope, "choose another field of view"},
        {"the window's nearer pair of sides, at depth 1,", std::min(u.reach(), v.reach()), least_slope,
         largest_slope, "choose another field of view"},
        {"the volume before the near plane, near x half width x half height there,", near_volume,
         least_volume, unlimited, scale_up},
        {"(far - near) / far", 1 - c.near_depth / c.far_depth, least_slab_share, unlimited,
         "move the near and far planes apart"},
    });
}

std::string outside_of_parallel(const Camera& c, const Span& u, const Span& v) {
    const double farthest = farthest_plane(c);
    const double shear = std::max(std::abs(c.shear.x), std::abs(c.shear.y));
    const double wide = std::max(u.reach(), v.reach()), narrow = std::min(u.reach(), v.reach());
    return first_outside({
        {"the depth of the near or far plane", farthest, 0, largest_judged_coordinate, scale_down},
        {"the window's farthest side", wide, 0, largest_judged_coordinate, scale_down},
        {"the shear", shear, 0, largest_slope, "choose a steeper projection"},
        {"the shear at the far plane", shear * farthest, 0, largest_judged_coordinate,
         "choose a steeper projection, or move the planes nearer"},
        {"the window's half side over the farther plane's depth", narrow / farthest, least_slope, unlimited,
         "widen the window, or move the planes nearer"},
        {"the window's volume, half width x half height x the larger of both,", wide * wide * narrow,
         least_volume, unlimited, "scale the scene up"},
        {"(far - near) / the farther plane's depth", (c.far_depth - c.near_depth) / farthest,
         least_slab_share, unlimited, "move the near and far planes apart"},
    });
}

}  // namespace

std::string outside_judged_ranges(const Scene& scene) {
    const Positions& p = scene.vertices.position_world;
    const auto is_judged = [](const glm::vec3& v) {
        return largest_of(glm::dvec3(v)) <= largest_judged_coordinate;
    };
    const std::uint32_t limit = std::bit_cast<std::uint32_t>(float(largest_judged_coordinate));
    const auto* numbers = reinterpret_cast<const unsigned char*>(p.data());
    if (largest(numbers, 3 * p.size(), magnitude_bits) <= limit) return "";
    const auto vertex = std::ranges::find_if_not(p, is_judged);
    std::ostringstream text;
    text << "vertex " << vertex - p.begin() << " of scene '" << scene.name << "' is (" << vertex->x << ", "
         << vertex->y << ", " << vertex->z << "); coordinates are judged up to " << largest_judged_coordinate
         << "; scale the scene down (docs/scenes.md)";
    return text.str();
}

std::string outside_judged_ranges(const View& view) {
    const Camera& c = view.camera;
    const Span u{c.window.left, c.window.right, rounded_along(c.right, c.shear.x, c)},
        v{c.window.bottom, c.window.top, rounded_along(c.up, c.shear.y, c)};
    std::string outside = first_outside({
        {"the eye's largest coordinate", largest_of(glm::dvec3(c.eye_world)), 0, largest_judged_coordinate,
         scale_down},
        {"the window's width over its distance from the middle", u.share(), least_window_share, unlimited,
         widen},
        {"the window's height over its distance from the middle", v.share(), least_window_share, unlimited,
         widen},
    });
    if (!outside.empty()) return outside;
    return c.projection == Projection::perspective ? outside_of_perspective(c, u, v)
                                                   : outside_of_parallel(c, u, v);
}

void require_judged(const Scene& scene) {
    if (std::string outside = outside_judged_ranges(scene); !outside.empty()) throw SceneError(outside);
}

void require_judged(const View& view) {
    if (std::string outside = outside_judged_ranges(view); !outside.empty()) throw SceneError(outside);
}

}  // namespace zproof
