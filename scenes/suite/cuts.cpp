#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"

namespace zproof::suite {

namespace {

/// From NDC (near -1, far 1) to camera space. Planes of the one are planes of the other.
glm::dvec3 from_ndc(const Camera& camera, const glm::dvec3& p_ndc) {
    const Window& w = camera.window;
    const double n = camera.near_depth, f = camera.far_depth, share = 0.5 * (p_ndc.z + 1);
    const bool perspective = camera.projection == Projection::perspective;
    const double depth = perspective ? 1 / (1 / n + share * (1 / f - 1 / n)) : n + share * (f - n);
    const double u = w.left + 0.5 * (p_ndc.x + 1) * (w.right - w.left);
    const double v = w.bottom + 0.5 * (p_ndc.y + 1) * (w.top - w.bottom);
    return perspective ? glm::dvec3{u * depth, v * depth, -depth} : glm::dvec3{u, v, -depth};
}

/// The corners of the hexagon in which the plane normal . p = 0 cuts the cube [-1, 1]^3, around the origin.
/// None of the normal's coordinates may be as large as the other two together.
std::array<glm::dvec3, 6> hexagon_in_cube(const glm::dvec3& normal) {
    std::array<glm::dvec3, 6> corners;
    for (int axis = 0; axis < 3; ++axis) {
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        const double unlike = std::copysign(1.0, -normal[b] * normal[c]);
        glm::dvec3 p(1.0);
        p[c] = unlike;
        p[axis] = -(normal[b] * p[b] + normal[c] * p[c]) / normal[axis];
        corners[std::size_t(2 * axis)] = p;
        corners[std::size_t(2 * axis + 1)] = -p;
    }
    return corners;
}

/// The corners in their order around the origin, seen from the tip of the normal.
std::array<glm::dvec3, 6> around(std::array<glm::dvec3, 6> corners, const glm::dvec3& normal) {
    const glm::dvec3 x = corners[0], y = glm::cross(normal, x);
    const auto angle = [&](const glm::dvec3& p) { return std::atan2(glm::dot(p, y), glm::dot(p, x)); };
    std::ranges::sort(corners, {}, angle);
    return corners;
}

/// Where two lines of a plane meet: the one through a along b - a, the other through c along d - c.
glm::dvec3 meeting(const std::array<glm::dvec3, 2>& ab, const std::array<glm::dvec3, 2>& cd,
                   const glm::dvec3& normal) {
    const glm::dvec3 across = glm::cross(normal, cd[1] - cd[0]), along = ab[1] - ab[0];
    return ab[0] + along * (glm::dot(cd[0] - ab[0], across) / glm::dot(along, across));
}

/// A triangle in NDC that the cube cuts to nine corners: all six planes cut it, and each of its sides cuts a
/// corner, a share of `cut` of the way to the next ones, off the hexagon that they leave. Its own corners
/// keep within z = 3.
std::array<glm::dvec3, 3> cut_to_nine(const glm::dvec3& normal, double cut) {
    const std::array<glm::dvec3, 6> hexagon = around(hexagon_in_cube(normal), normal);
    std::array<std::array<glm::dvec3, 2>, 3> sides;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &before = hexagon[(2 * i + 5) % 6], &corner = hexagon[2 * i],
                         &after = hexagon[2 * i + 1];
        sides[i] = {corner + cut * (before - corner), corner + cut * (after - corner)};
    }
    return {meeting(sides[0], sides[1], normal), meeting(sides[1], sides[2], normal),
            meeting(sides[2], sides[0], normal)};
}

/// A normal for hexagon_in_cube.
glm::dvec3 hexagons_normal(Random& random) {
    const auto coordinate = [&] {
        const double size = random.uniform(0.7, 1.3);
        return random.integer(0, 1) == 0 ? size : -size;
    };
    return {coordinate(), coordinate(), coordinate()};
}

/// A triangle in NDC that crosses a few of the six planes.
std::array<glm::dvec3, 3> crossing(Random& random) {
    const glm::dvec3 low(-2), high(2);
    return {random.in_box(low, high), random.in_box(low, high), random.in_box(low, high)};
}

/// Triangles that the near plane or the top cuts through one of their corners, which lies exactly in it. Near
/// and top must be multiples of 1/2, as the eye must be.
void add_corners_in_planes(MeshBuilder& mesh, const Camera& camera) {
    const double n = camera.near_depth, top = camera.window.top;
    const bool perspective = camera.projection == Projection::perspective;
    const auto at = [&](double u, double v, double depth) {
        const double scale = perspective ? depth : 1;
        return glm::dvec3(camera.eye_world) + glm::dvec3{u * scale, v * scale, -depth};
    };
    for (int i = -3; i < 4; ++i) {
        const double u = 0.25 * i * top, wide = 0.125 * top;
        mesh.lone_triangle(
            {at(u, -0.5 * top, n), at(u + wide, -0.75 * top, 1.25 * n), at(u - wide, -0.25 * top, 0.75 * n)});
        mesh.lone_triangle({at(u, top, 1.125 * n), at(u + wide, 0.5 * top, 1.125 * n),
                            at(u + 0.5 * wide, 1.5 * top, 1.125 * n)});
    }
}

void add_cut_triangles(MeshBuilder& mesh, const Camera& camera, std::uint64_t seed) {
    Random random(seed);
    const auto add = [&](const std::array<glm::dvec3, 3>& ndc) {
        std::array<glm::dvec3, 3> p_world;
        for (std::size_t i = 0; i < 3; ++i)
            p_world[i] = glm::dvec3(camera.eye_world) + from_ndc(camera, ndc[i]);
        mesh.lone_triangle(p_world);
    };
    mesh.begin_part("to nine corners", {0.7, 0.3, 0.3});
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 normal = hexagons_normal(random);
        add(cut_to_nine(normal, random.uniform(0.1, 0.4)));
    }
    mesh.begin_part("corners in a plane", {0.3, 0.4, 0.7});
    add_corners_in_planes(mesh, camera);
    mesh.begin_part("across a few planes", {0.3, 0.6, 0.4});
    for (int i = 0; i < 60; ++i) add(crossing(random));
}

/// A triangle of which the plane at camera depth `cut_depth` leaves the tip alone: about two pixels around
/// (u, v), the tangents of a pixel's centre.
void add_tip(MeshBuilder& mesh, const glm::dvec2& uv, double pixel, double tip_depth, double cut_depth) {
    const glm::dvec3 tip{(uv + pixel * glm::dvec2{0.1, 1}) * tip_depth, -tip_depth};
    const glm::dvec3 a{(uv + pixel * glm::dvec2{-1, -0.7}) * cut_depth, -cut_depth};
    const glm::dvec3 b{(uv + pixel * glm::dvec2{0.9, -0.8}) * cut_depth, -cut_depth};
    mesh.lone_triangle({tip, tip + 12.0 * (a - tip), tip + 12.0 * (b - tip)});
}

/// A triangle that reaches into the window |u| < half.x, |v| < half.y by a pixel and a half, at camera depth
/// 2: through the side that `outwards` points at.
void add_tip_through_side(MeshBuilder& mesh, const glm::dvec2& on_side, const glm::dvec2& outwards,
                          double pixel) {
    const glm::dvec2 along{-outwards.y, outwards.x};
    const auto at = [](const glm::dvec2& uv, double depth) { return glm::dvec3{uv * depth, -depth}; };
    const glm::dvec2 base = on_side + 60 * pixel * outwards;
    mesh.lone_triangle({at(on_side - 1.5 * pixel * outwards, 2), at(base - 30 * pixel * along, 2.01),
                        at(base + 34 * pixel * along, 2.02)});
}

}  // namespace

Loaded frustum_cuts(ImageSize size) {
    const View perspective =
        perspective_view("perspective", size, {}, {.half_height = 0.5, .near_depth = 1, .far_depth = 2});
    const View parallel =
        parallel_view("parallel", size, {.eye_world = {64, 0, 0}, .target_world = {64, 0, -1}},
                      {.half_height = 4, .near_depth = 2, .far_depth = 10});
    MeshBuilder mesh("frustum_cuts");
    add_cut_triangles(mesh, perspective.camera, 31);
    add_cut_triangles(mesh, parallel.camera, 32);
    return mesh.finish({perspective, parallel});
}

Loaded clipped_tips(ImageSize size) {
    constexpr double half_height = 0.5, near_depth = 1, far_depth = 3;
    const Window window = centred_window(size, half_height);
    const double pixel = 2 * half_height / size.height;
    const auto centre_of = [&](int x, int y) {
        return glm::dvec2{window.left + (x + 0.5) * pixel, window.top - (y + 0.5) * pixel};
    };
    MeshBuilder mesh("clipped_tips");
    mesh.begin_part("through the near plane", {0.8, 0.5, 0.3});
    for (int y = 6; y < size.height - 6; y += 12)
        for (int x = 6; x < size.width - 6; x += 24)
            add_tip(mesh, centre_of(x, y), pixel, near_depth * 1.125, near_depth);
    mesh.begin_part("through the far plane", {0.3, 0.5, 0.8});
    for (int y = 6; y < size.height - 6; y += 12)
        for (int x = 18; x < size.width - 6; x += 24)
            add_tip(mesh, centre_of(x, y), pixel, far_depth * 0.875, far_depth);
    mesh.begin_part("through the sides", {0.4, 0.7, 0.4});
    for (int x = 4; x < size.width; x += 8) {
        add_tip_through_side(mesh, {centre_of(x, 0).x, window.top}, {0, 1}, pixel);
        add_tip_through_side(mesh, {centre_of(x, 0).x, window.bottom}, {0, -1}, pixel);
    }
    for (int y = 4; y < size.height; y += 8) {
        add_tip_through_side(mesh, {window.left, centre_of(0, y).y}, {-1, 0}, pixel);
        add_tip_through_side(mesh, {window.right, centre_of(0, y).y}, {1, 0}, pixel);
    }
    mesh.begin_part("wall", {0.5, 0.5, 0.5});
    mesh.lone_triangle({{{-0.2, -40, -2.75}, {40, 0, -2.75}, {-0.2, 40, -2.75}}});
    return mesh.finish({perspective_view(
        "ahead", size, {}, {.half_height = half_height, .near_depth = near_depth, .far_depth = far_depth})});
}

}  // namespace zproof::suite
