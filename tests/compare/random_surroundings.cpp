#include "random_surroundings.h"

#include <cmath>

#include "test_scene.h"

namespace zproof {

namespace {

using Corners3 = std::array<glm::dvec3, 3>;  ///< raster x, y in px from the pixel's centre, and depth

glm::dmat3 turned(double yaw, double pitch) {
    const glm::dvec3 back{std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
    return {right, glm::cross(back, right), back};
}

/// World position of what is seen at an offset from the pixel's centre, at a depth.
glm::vec3 position(const View& view, int x, int y, const glm::dvec3& seen) {
    const ViewRay<double> ray(view, x, y);
    const auto across = seen.x * ray.step_x + seen.y * ray.step_y;
    const bool perspective = view.camera.projection == Projection::perspective;
    const auto origin = perspective ? ray.origin : ray.origin + across;
    const auto direction = perspective ? ray.direction + across : ray.direction;
    const auto p = origin + seen.z * direction;
    return {float(p.x), float(p.y), float(p.z)};
}

/// The offsets that matter: the centre itself, within the square, or far away.
double random_offset(Rng& rng) {
    switch (rng.below(5)) {
        case 0:
            return 0;
        case 1:
            return rng.between(-1, 1) * 0x1p-8;
        case 2:
            return rng.between(-1, 1) * 0x1p-10;
        default:
            return rng.between(-6, 6);
    }
}

double random_depth(Rng& rng) {
    constexpr std::array depths{2.0, 4.0, 4.0, 4.0 + 0x1p-20, 8.0};
    return rng.below(3) ? depths[std::size_t(rng.below(5))] : rng.between(0.5, 12);
}

Corners3 random_corners(Rng& rng) {
    Corners3 corners;
    const double flat = random_depth(rng);
    const bool is_flat = rng.below(2) == 0;
    for (glm::dvec3& c : corners)
        c = {random_offset(rng), random_offset(rng), is_flat ? flat : random_depth(rng)};
    if (rng.below(3) == 0) {  // around the centre for certain, far out
        const double size = std::exp2(rng.between(-9, 4));
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i].x = size * std::array{-3, 3, -3}[i];
            corners[i].y = size * std::array{-3, -3, 3}[i];
        }
    }
    return corners;
}

void make_sliver(Corners3& c, Rng& rng) {
    c[2] = glm::mix(c[0], c[1], rng.between(-1, 2));
    c[2].y += rng.between(-1, 1) * std::exp2(rng.between(-24, -4));
}

/// Takes corners of an earlier triangle: one, two (a shared edge), or a point of its plane.
void join(CornersWorld& p, const Scene& scene, Rng& rng) {
    const auto& all = scene.vertices.position_world;
    const auto first = std::size_t(3 * rng.below(int(all.size() / 3)));
    const auto turn = std::size_t(rng.below(3));
    switch (rng.below(4)) {
        case 0:
            p[0] = all[first + turn];
            break;
        case 1:
            p[2] = all[first] + all[first + 1] - all[first + 2];  // often exactly in its plane
            [[fallthrough]];
        case 2:
            p[0] = all[first + turn];
            p[1] = all[first + (turn + 1) % 3];
            break;
        default:
            for (std::size_t i = 0; i < 3; ++i) p[i] = 0.5f * (all[first + i] + all[first + (i + 1) % 3]);
    }
}

void push(Scene& scene, const CornersWorld& p) {
    const auto first = std::uint32_t(scene.vertices.position_world.size());
    for (const glm::vec3& corner : p) scene.vertices.position_world.push_back(corner);
    scene.triangles.emplace_back(first, first + 1, first + 2);
}

}  // namespace

View random_view(Rng& rng) {
    View view{.name = "random", .camera = {}, .width = 16, .height = 16};
    Camera& c = view.camera;
    const bool plain = rng.below(2) == 0;
    if (rng.below(2)) c.projection = Projection::parallel;
    c.window = {.left = 0, .right = 16, .bottom = -16, .top = 0};
    c.near_depth = std::array{0.25, 2.0, 4.0}[std::size_t(rng.below(3))];
    c.far_depth = std::array{8.0, 100.0, 5.0}[std::size_t(rng.below(3))];
    if (plain) return view;
    const glm::dmat3 axes = turned(rng.between(-3, 3), rng.between(-1.4, 1.4));
    c.right = axes[0], c.up = axes[1], c.back = axes[2];
    c.eye_world = glm::vec3(rng.between(-9, 9), rng.between(-9, 9), rng.between(-9, 9));
    c.window = {.left = -0.9, .right = 0.7, .bottom = -0.8, .top = 0.6};
    if (c.projection == Projection::parallel)
        c.shear = {rng.between(-0.5, 0.5), 0.25 * rng.below(2)};
    else if (rng.below(3) == 0)
        c.far_depth = std::numeric_limits<double>::infinity();
    return view;
}

View view_from_far_away(Rng& rng) {
    View view = random_view(rng);
    Camera& c = view.camera;
    c.projection = Projection::parallel;
    c.eye_world = glm::vec3(rng.between(-1, 1) * 0x1p20 * c.right + rng.between(-1, 1) * 0x1p20 * c.up);
    const double u = -glm::dot(c.right, glm::dvec3(c.eye_world)),
                 v = -glm::dot(c.up, glm::dvec3(c.eye_world));
    c.window = {.left = u - 1, .right = u + 1, .bottom = v - 1, .top = v + 1};
    return view;
}

Scene random_crowd(Rng& rng, const View& view, int x, int y) {
    Scene scene;
    const int count = 1 + rng.below(5);
    for (int i = 0; i < count; ++i) {
        Corners3 seen = random_corners(rng);
        const int kind = rng.below(12);
        if (kind == 0) make_sliver(seen, rng);
        if (kind == 1) seen[std::size_t(rng.below(3))].z = rng.between(-3, 1);
        if (kind == 2) seen[0].z = seen[1].z = 0;
        CornersWorld p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = position(view, x, y, seen[k]);
        if (kind == 3) p[std::size_t(rng.below(3))] *= std::exp2(float(rng.between(-60, 60)));
        if (kind >= 6 && i > 0) join(p, scene, rng);
        push(scene, p);
    }
    return scene;
}

Neighbourhood surroundings(const Scene& scene, const View& view, const ViewBounds& bounds,
                           const PixelCoord& place, double least_eps_px) {
    SearchPixel search_pixel{place.x, place.y, least_eps_px, {}};
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) search_pixel.triangles.push_back(t);
    return neighbourhood_of(scene, view, bounds, search_pixel, least_eps_px);
}

Surroundings random_surroundings(std::uint32_t seed) {
    Rng rng(seed);
    Surroundings s{random_view(rng), {}, rng.below(16), rng.below(16), {}};
    s.scene = random_crowd(rng, s.view, s.x, s.y);
    const bool raster = rng.below(2) == 0;
    RasterPrecision with_bits;
    with_bits.transform = rng.below(2) ? Arithmetic::float32 : Arithmetic::float64;
    const Precision precision = raster ? Precision(with_bits) : Precision(RayPrecision{});
    const ViewBounds bounds(s.view, precision);
    s.around = surroundings(s.scene, s.view, bounds, {s.x, s.y}, rng.below(4) ? 0x1p-9 : 0);
    return s;
}

Scene random_walls(Rng& rng, const View& view) {
    std::vector<Triangle> walls;
    const double slope = std::ldexp(rng.between(-1, 1), -rng.below(24));
    for (int count = 2 + rng.below(3); count > 0; --count) {
        const double depth = rng.below(4) == 0 ? 16 : 8, tilt = rng.below(2) ? slope : 0;
        const double aside = rng.below(6) == 0 ? 4 : 0,
                     lift = rng.below(3) == 0 ? std::ldexp(1.0, -rng.below(40)) : 0;
        const auto corner = [&](double x, double y) {
            return Corner{x + aside, y, depth + tilt * (x - 1.5) + lift};
        };
        walls.push_back({corner(0, -64), corner(64, 200), corner(-64, 200)});
    }
    return scene_of(view, walls);
}

}  // namespace zproof
