#include "scenes/random/views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scenes/judged_ranges.h"

namespace zproof::random {
namespace {

using suite::Random;

constexpr double no_far_plane = std::numeric_limits<double>::infinity();

int side(Random& dice) {
    constexpr std::array special{1, 2, 3, 5, 7, 15, 16, 17, 31, 32, 33, 63, 64, 65, 127, 128};
    return dice.integer(0, 2) == 0 ? special[std::size_t(dice.integer(0, int(special.size()) - 1))]
                                   : dice.integer(4, 72);
}

glm::vec3 eye(Random& dice) {
    switch (dice.integer(0, 7)) {
        case 0:
            return glm::vec3(1e6 * dice.direction());
        case 1:
            return glm::vec3(dice.in_box(glm::dvec3(-100), glm::dvec3(100)));
        case 2:
        case 3:
            return glm::vec3(glm::floor(dice.in_box(glm::dvec3(-8), glm::dvec3(9))));
        default:
            return glm::vec3(0);
    }
}

/// Along the axes of the world, in any of the 24 ways.
glm::dmat3 upright_axes(Random& dice) {
    const int first = dice.integer(0, 2), second = (first + dice.integer(1, 2)) % 3;
    const double a = dice.integer(0, 1) ? 1 : -1, b = dice.integer(0, 1) ? 1 : -1;
    glm::dvec3 right(0), up(0);
    right[first] = a;
    up[second] = b;
    return {right, up, glm::cross(right, up)};
}

glm::dmat3 axes(Random& dice) {
    switch (dice.integer(0, 7)) {
        case 0:
            return upright_axes(dice);
        case 1: {  // as far from right angles as a camera may be
            glm::dmat3 turned = dice.rotation();
            turned[0] += 0x1p-43 * dice.direction();
            return turned;
        }
        case 2:
        case 3:
            return dice.rotation();
        default:
            return glm::dmat3(1);
    }
}

void set_pose(Camera& camera, const glm::vec3& eye, const glm::dmat3& axes) {
    camera.eye_world = eye;
    camera.right = axes[0];
    camera.up = axes[1];
    camera.back = axes[2];
}

/// Half the height of a perspective window: the tangent of half the field of view.
double half_field(Random& dice) {
    switch (dice.integer(0, 7)) {
        case 0:
            return dice.binade(-12, -4);
        case 1:
            return dice.integer(0, 1) ? dice.binade(-30, -13) : dice.binade(-12, -8);
        case 2:
            return dice.binade(2, 11);
        default:
            return dice.uniform(0.2, 1.2);
    }
}

/// With square pixels or others, around the axis or beside it.
Window window(Random& dice, const View& view, double half_height) {
    const double pixel_shape = dice.integer(0, 2) == 0 ? dice.binade(-3, 2) : 1;
    const double half_width = half_height * view.width / view.height * pixel_shape;
    double across = 0, up = 0;
    if (dice.integer(0, 3) == 0) {
        across = half_width * dice.uniform(-8, 8);
        up = half_height * dice.uniform(-8, 8);
    }
    return {across - half_width, across + half_width, up - half_height, up + half_height};
}

double near_depth(Random& dice) {
    switch (dice.integer(0, 7)) {
        case 0:
        case 1:
            return dice.binade(-20, -10);
        case 2:
            return dice.binade(4, 20);
        case 3:
            return 1;
        default:
            return dice.binade(-4, 1);
    }
}

double far_depth(Random& dice, double near) {
    switch (dice.integer(0, 7)) {
        case 0:
        case 1:
            return no_far_plane;
        case 2:
            return near * dice.binade(20, 30);
        case 3:
            return near * (1 + dice.binade(-12, -2));
        default:
            return near * dice.binade(1, 10);
    }
}

void set_perspective(Random& dice, View& view) {
    Camera& c = view.camera;
    c.projection = Projection::perspective;
    c.window = window(dice, view, half_field(dice));
    c.near_depth = near_depth(dice);
    c.far_depth = far_depth(dice, c.near_depth);
}

/// Half of them look behind their eye as well.
void set_parallel(Random& dice, View& view) {
    Camera& c = view.camera;
    c.projection = Projection::parallel;
    const double scale = dice.integer(0, 3) == 0 ? dice.binade(-10, 10) : dice.binade(-1, 2);
    c.window = window(dice, view, scale);
    const double depth = scale * dice.binade(-2, 4);
    c.near_depth = dice.integer(0, 1) ? -depth * dice.uniform(0, 2) : depth * dice.uniform(0, 0.5);
    c.far_depth = c.near_depth + depth;
    if (dice.integer(0, 1)) c.shear = {dice.uniform(-2, 2), dice.uniform(-2, 2)};
}

View drawn_view(Random& dice) {
    View view;
    view.name = "main";
    view.width = side(dice);
    view.height = side(dice);
    const bool is_perspective = dice.integer(0, 9) < 7;
    is_perspective ? set_perspective(dice, view) : set_parallel(dice, view);
    const glm::vec3 at = eye(dice);
    set_pose(view.camera, at, axes(dice));
    view.camera.ndc_depth = static_cast<NdcDepth>(dice.integer(0, 2));
    return view;
}

}  // namespace

View any_view(Random& dice) {
    for (;;) {
        const View view = drawn_view(dice);
        if (outside_judged_ranges(view).empty()) return view;
    }
}

double largest_coordinate(const glm::vec3& eye_world) {
    return std::max({std::abs(eye_world.x), std::abs(eye_world.y), std::abs(eye_world.z)});
}

bool is_resolved(const View& view) {
    const Camera& c = view.camera;
    const Window& w = c.window;
    const bool is_perspective = c.projection == Projection::perspective;
    const double scale = is_perspective ? c.near_depth : 1;  // of the window
    const double pixel = scale * std::min((w.right - w.left) / view.width, (w.top - w.bottom) / view.height);
    const double depth =
        is_perspective ? c.near_depth : std::max(std::abs(c.near_depth), std::abs(c.far_depth));
    const double reach = std::max({std::abs(w.left), std::abs(w.right), std::abs(w.bottom), std::abs(w.top)});
    const double shear = std::max(std::abs(c.shear.x), std::abs(c.shear.y));
    const double rounded = largest_coordinate(c.eye_world) + scale * reach + depth * (1 + shear);
    return 0x1p-24 * rounded <= 0x1p-10 * pixel;
}

View aligned_view(Random& dice) {
    View view;
    view.name = "main";
    view.width = side(dice);
    view.height = side(dice);
    Camera& c = view.camera;
    c.projection = dice.integer(0, 2) == 0 ? Projection::parallel : Projection::perspective;
    const double half_pixel = std::ldexp(1.0, dice.integer(-8, -4));
    const double x = half_pixel * view.width, y = half_pixel * view.height;
    const double across = 2 * half_pixel * dice.integer(-8, 8), up = 2 * half_pixel * dice.integer(-8, 8);
    c.window = {across - x, across + x, up - y, up + y};
    c.near_depth = c.projection == Projection::parallel ? -1 : 0.5;
    c.far_depth = c.projection == Projection::parallel ? 8 : 64;
    const glm::vec3 at(glm::floor(dice.in_box(glm::dvec3(-4), glm::dvec3(5))));
    set_pose(c, at, upright_axes(dice));
    return view;
}

}  // namespace zproof::random
