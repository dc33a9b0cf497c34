#include "tests/magnitudes/drawn_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace zproof {
namespace {

constexpr double largest_float = std::numeric_limits<float>::max();

/// How far the magnitudes of one draw reach: as far as the numbers do, or about as far as is judged.
struct Reach {
    double coordinate, least_slope, largest_slope, least_near;
};

constexpr Reach everything{largest_float, 1e-310, 1e300, 1e-310};
constexpr Reach judged{1e11, 1e-10, 1e4, 1e-7};

glm::dmat3 turned(Draw& draw) {
    if (draw.one_in(3)) return glm::dmat3(1.0);
    const double a = draw.between(-3, 3), b = draw.between(-3, 3);
    const glm::dvec3 back{std::cos(a) * std::cos(b), std::sin(b), std::sin(a) * std::cos(b)};
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
    return {right, glm::normalize(glm::cross(back, right)), back};
}

/// Around the middle, or so far beside it that little of the difference is left.
void set_sides(Draw& draw, double half, double& low, double& high) {
    const double shift = draw.one_in(2) ? 0 : draw.sign() * half * draw.magnitude(1e-3, 1e7);
    low = shift - half;
    high = shift + half;
}

void set_window(Draw& draw, double low, double high, Window& window) {
    const double half = draw.magnitude(low, high);
    set_sides(draw, half, window.left, window.right);
    const double other = draw.one_in(4) ? draw.magnitude(low, high) : half * draw.between(0.3, 1);
    set_sides(draw, other, window.bottom, window.top);
}

void set_depths(Draw& draw, const Reach& reach, Camera& camera) {
    const bool perspective = camera.projection == Projection::perspective;
    camera.near_depth = draw.magnitude(reach.least_near, reach.coordinate);
    if (draw.one_in(2)) camera.near_depth = draw.magnitude(1e-3, 10);
    const double slab = camera.near_depth * draw.magnitude(1e-7, 1e9);
    camera.far_depth = camera.near_depth + slab;
    if (!perspective && draw.one_in(3)) camera.near_depth = -camera.near_depth;
    if (perspective && draw.one_in(3)) camera.far_depth = std::numeric_limits<double>::infinity();
    if (!(camera.near_depth < camera.far_depth)) camera.far_depth = 2 * camera.near_depth;
}

Camera drawn_camera(Draw& draw, const Reach& reach) {
    Camera camera;
    const glm::dmat3 axes = turned(draw);
    camera.right = axes[0], camera.up = axes[1], camera.back = axes[2];
    camera.projection = draw.one_in(3) ? Projection::parallel : Projection::perspective;
    set_depths(draw, reach, camera);
    if (camera.projection == Projection::perspective) {
        const bool is_wide = draw.one_in(2);
        set_window(draw, is_wide ? 0.05 : reach.least_slope, is_wide ? 5 : reach.largest_slope,
                   camera.window);
    } else {
        const double depth = std::abs(camera.far_depth);
        set_window(draw, std::max(depth * reach.least_slope, 1e-310), std::min(depth * 1e3, reach.coordinate),
                   camera.window);
        if (draw.one_in(2)) camera.shear = {draw.sign() * draw.magnitude(1e-12, 10), draw.between(-1, 1)};
    }
    if (draw.one_in(2))
        for (int i = 0; i < 3; ++i)
            camera.eye_world[i] = float(draw.sign() * draw.magnitude(1e-45, reach.coordinate));
    return camera;
}

/// A place in the image, or beside it, at a depth: in world space.
glm::dvec3 seen_at(const View& view, double x, double y, double depth) {
    const Camera& c = view.camera;
    const double u = c.window.left + (c.window.right - c.window.left) * x / view.width,
                 v = c.window.top - (c.window.top - c.window.bottom) * y / view.height;
    const glm::dvec3 p = c.projection == Projection::perspective
                             ? glm::dvec3(u, v, -1) * depth
                             : glm::dvec3(u + c.shear.x * depth, v + c.shear.y * depth, -depth);
    return glm::dvec3(c.eye_world) + p.x * c.right + p.y * c.up + p.z * c.back;
}

double drawn_depth(Draw& draw, const Camera& c) {
    if (c.projection == Projection::parallel) return draw.between(c.near_depth, c.far_depth);
    const double far = std::min(c.far_depth, 1e3 * c.near_depth);
    return draw.one_in(8) ? c.near_depth * draw.between(0.5, 1.5) : draw.magnitude(c.near_depth, far);
}

/// A triangle of some pixels, level or slanted; or one of any three places.
std::array<glm::dvec3, 3> drawn_triangle(Draw& draw, const View& view, const Reach& reach) {
    std::array<glm::dvec3, 3> corners;
    if (draw.one_in(6)) {
        for (glm::dvec3& p : corners)
            for (int i = 0; i < 3; ++i)
                p[i] = draw.one_in(4) ? 0 : draw.sign() * draw.magnitude(1e-45, reach.coordinate);
        return corners;
    }
    const double size = draw.magnitude(0.1, 100), x = draw.between(0, view.width),
                 y = draw.between(0, view.height);
    const double depth = drawn_depth(draw, view.camera);
    const bool is_level = draw.one_in(2);
    for (glm::dvec3& p : corners)
        p = seen_at(view, x + draw.between(-size, size), y + draw.between(-size, size),
                    is_level ? depth : drawn_depth(draw, view.camera));
    return corners;
}

float rounded(double coordinate, const Reach& reach) {
    return float(std::clamp(coordinate, -reach.coordinate, reach.coordinate));  // NaN stays
}

}  // namespace

double Draw::magnitude(double low, double high) {
    if (one_in(8)) return one_in(2) ? low : high;
    const double exponent = between(std::log10(low), std::log10(high));
    return std::clamp(std::pow(10.0, exponent), low, high);
}

DrawnView drawn_view(std::uint32_t seed) {
    Draw draw(seed);
    const Reach& reach = draw.one_in(4) ? everything : judged;
    DrawnView drawn;
    drawn.view = {.name = "drawn", .camera = drawn_camera(draw, reach), .width = 8, .height = 6};
    drawn.scene.name = "drawn";
    for (std::uint32_t t = 0; t < 12; ++t) {
        for (const glm::dvec3& p : drawn_triangle(draw, drawn.view, reach))
            drawn.scene.vertices.position_world.push_back(
                {rounded(p.x, reach), rounded(p.y, reach), rounded(p.z, reach)});
        drawn.scene.triangles.emplace_back(3 * t, 3 * t + 1, 3 * t + 2);
    }
    return drawn;
}

}  // namespace zproof
