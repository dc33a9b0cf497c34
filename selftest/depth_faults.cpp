#include <array>
#include <cmath>

#include "selftest/catalogue.h"
#include "selftest/fault_pixel.h"

namespace zproof::selftest {
namespace {

/// The view ray through a pixel's centre is (u, v, -1) per unit of depth (scenes/camera.h).
glm::dvec2 tangents(const View& view, int x, int y) {
    const Window& w = view.camera.window;
    return {w.left + (w.right - w.left) * (x + 0.5) / view.width,
            w.top - (w.top - w.bottom) * (y + 0.5) / view.height};
}

struct Seen {
    const Fixture& fixture;
    int x, y;
    PrimitiveId id;
    double depth;
};

/// Every depth that is not background becomes another; ids stay.
std::function<Frame(const Fixture&)> each_depth(const std::function<double(const Seen&)>& changed) {
    return [=](const Fixture& fixture) {
        Frame frame = fixture.good;
        for (int y = 0; y < fixture.view.height; ++y)
            for (int x = 0; x < fixture.view.width; ++x) {
                const PrimitiveId id = fixture.good.primitive.at(x, y);
                if (id == PrimitiveId::none) continue;
                float& depth = frame.camera_depth.at(x, y);
                depth = float(changed({fixture, x, y, id, double(depth)}));
            }
        return frame;
    };
}

double ray_length(const Seen& seen) {
    const glm::dvec2 t = tangents(seen.fixture.view, seen.x, seen.y);
    return seen.depth * std::sqrt(1 + t.x * t.x + t.y * t.y);
}

/// What a perspective projection makes of depth, with these values at near and far.
double ndc(const Camera& camera, double depth, double at_near, double at_far) {
    const double near = camera.near_depth, far = camera.far_depth;
    const double share = (1 / near - 1 / depth) / (1 / near - 1 / far);
    return at_near + (at_far - at_near) * share;
}

std::function<double(const Seen&)> as_ndc(double at_near, double at_far) {
    return [=](const Seen& seen) { return ndc(seen.fixture.view.camera, seen.depth, at_near, at_far); };
}

/// The depth after a depth buffer that holds [0, 1] in whole steps.
double quantized(const Seen& seen, int bits) {
    const Camera& camera = seen.fixture.view.camera;
    const double steps = std::ldexp(1.0, bits) - 1;
    const double share = std::nearbyint(ndc(camera, seen.depth, 0, 1) * steps) / steps;
    return 1 / (1 / camera.near_depth + share * (1 / camera.far_depth - 1 / camera.near_depth));
}

struct Projected {
    glm::dvec2 p_raster;
    double depth;
};

Projected project(const View& view, const glm::vec3& p_world) {
    const Camera& camera = view.camera;
    const glm::dvec3 p = glm::dvec3(p_world) - glm::dvec3(camera.eye_world);
    const double depth = -glm::dot(p, camera.back);
    const Window& w = camera.window;
    return {{(glm::dot(p, camera.right) / depth - w.left) / (w.right - w.left) * view.width,
             (w.top - glm::dot(p, camera.up) / depth) / (w.top - w.bottom) * view.height},
            depth};
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Depth itself interpolated over the triangle's image, as if the picture were parallel.
double affine(const Seen& seen) {
    const Scene& scene = seen.fixture.scene;
    const glm::uvec3 corner = scene.triangles[std::size_t(seen.id)];
    std::array<Projected, 3> v;
    for (int k = 0; k < 3; ++k)
        v[std::size_t(k)] = project(seen.fixture.view, scene.vertices.position_world[corner[k]]);
    const glm::dvec2 p{seen.x + 0.5, seen.y + 0.5};
    const glm::dvec2 e1 = v[1].p_raster - v[0].p_raster, e2 = v[2].p_raster - v[0].p_raster;
    const glm::dvec2 r = p - v[0].p_raster;
    const double b1 = cross(r, e2) / cross(e1, e2), b2 = cross(e1, r) / cross(e1, e2);
    return v[0].depth + b1 * (v[1].depth - v[0].depth) + b2 * (v[2].depth - v[0].depth);
}

/// Every depth is its left neighbour's, where that is the same triangle.
double of_the_left(const Seen& seen) {
    const bool same = seen.x > 0 && seen.fixture.good.primitive.at(seen.x - 1, seen.y) == seen.id;
    return same ? double(seen.fixture.good.camera_depth.at(seen.x - 1, seen.y)) : seen.depth;
}

}  // namespace

std::vector<Fault> faults_of_depth() {
    const Expected wrong{.classes = {PixelClass::wrong_depth}, .count = {}};
    const Expected invalid{.classes = {PixelClass::invalid}, .count = {}};
    return {
        {"depth_is_ray_length", "depth is the distance from the eye", wrong, each_depth(ray_length)},
        {"depth_is_ndc", "depth is NDC z, -1 at near and 1 at far", wrong, each_depth(as_ndc(-1, 1))},
        {"depth_is_ndc_from_zero", "depth is NDC z, 0 at near and 1 at far", wrong, each_depth(as_ndc(0, 1))},
        {"depth_is_ndc_reversed", "depth is NDC z, 1 at near and 0 at far", wrong, each_depth(as_ndc(1, 0))},
        {"depth_is_reciprocal", "depth is 1 / depth", wrong,
         each_depth([](const Seen& seen) { return 1 / seen.depth; })},
        {"depth_is_affine", "depth is interpolated without regard to perspective", wrong, each_depth(affine)},
        {"depth_of_16_bits", "depth went through a 16-bit buffer", wrong,
         each_depth([](const Seen& seen) { return quantized(seen, 16); })},
        {"depth_of_24_bits", "depth went through a 24-bit buffer", wrong,
         each_depth([](const Seen& seen) { return quantized(seen, 24); }), FixtureSize::large},
        {"depth_from_near", "depth is counted from the near plane", wrong,
         each_depth([](const Seen& seen) { return seen.depth - seen.fixture.view.camera.near_depth; })},
        {"depth_in_other_units", "depth is in thousandths of a unit", wrong,
         each_depth([](const Seen& seen) { return 1000 * seen.depth; })},
        {"depth_of_the_pixel_to_the_left", "depth is taken one pixel to the left", wrong,
         each_depth(of_the_left)},
        {"depth_a_millionth_too_far", "depth is too large by one millionth", wrong,
         each_depth([](const Seen& seen) { return seen.depth * (1 + 1e-6); }), FixtureSize::large},
        {"depths_negative", "depth is z_camera, which is negative", invalid,
         each_depth([](const Seen& seen) { return -seen.depth; })},
    };
}

}  // namespace zproof::selftest
