/// Mistakes in attributes are called by their names. The frames are a renderer's of the test's own: it finds
/// weights by the pixel's ray, in double, and knows nothing of the judge.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <ostream>

#include "compare/diagnosis/diagnosis.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

using Vector = glm::dvec3;

/// A pixel that shows a triangle.
struct Shown {
    const Scene& scene;
    const View& view;
    glm::uvec3 triangle;
    Vector weights;  ///< of the corners; their sum is 1

    Vector corner(int i) const { return Vector(scene.vertices.position_world[triangle[i]]); }
    double depth_of(int i) const { return -dot(view.camera.back, corner(i) - Vector(view.camera.eye_world)); }
    template <class Values>
    Vector blend(const Values& values) const {
        Vector sum(0);
        for (int i = 0; i < 3; ++i)
            for (int axis = 0; axis < values[triangle[i]].length(); ++axis)
                sum[axis] += weights[i] * double(values[triangle[i]][axis]);
        return sum;
    }
    Vector normal() const { return normalize(blend(scene.vertices.normal_world)); }
    Vector uv() const { return blend(scene.vertices.uv.front()); }
    Vector position() const { return blend(scene.vertices.position_world); }
};

Vector ray_through(const View& view, int x, int y) {
    const Camera& c = view.camera;
    const Window& w = c.window;
    const double u = w.left + (w.right - w.left) * (x + 0.5) / view.width;
    const double v = w.top + (w.bottom - w.top) * (y + 0.5) / view.height;
    return u * c.right + v * c.up - c.back;
}

/// Cramer's rule: the ray is a mean of the corners, seen from the eye.
Vector weights_at(const Scene& scene, const View& view, const glm::uvec3& t, int x, int y) {
    const Vector eye(view.camera.eye_world), d = ray_through(view, x, y);
    const auto from_eye = [&](std::uint32_t i) { return Vector(scene.vertices.position_world[i]) - eye; };
    const Vector p = from_eye(t.x), q = from_eye(t.y), r = from_eye(t.z);
    const Vector b(dot(d, cross(q, r)), dot(d, cross(r, p)), dot(d, cross(p, q)));
    return b / (b.x + b.y + b.z);
}

/// Weights that are linear over the image: those of the corners, each times its depth.
Vector without_perspective(const Shown& s) {
    const Vector b(s.weights.x * s.depth_of(0), s.weights.y * s.depth_of(1), s.weights.z * s.depth_of(2));
    return b / (b.x + b.y + b.z);
}

float as_half(double value) {
    const double step = std::ldexp(1.0, (value == 0 ? -14 : std::max(-14, std::ilogb(value))) - 10);
    return float(std::nearbyint(value / step) * step);
}

/// Each corner gets vertices of its own, with the triangle's normal.
void make_flat(Scene& scene) {
    Vertices vertices;
    for (glm::uvec3& t : scene.triangles) {
        const auto first = std::uint32_t(vertices.position_world.size());
        std::array<glm::vec3, 3> p;
        for (int i = 0; i < 3; ++i) p[std::size_t(i)] = scene.vertices.position_world[t[i]];
        const Vector normal = normalize(cross(Vector(p[1] - p[0]), Vector(p[2] - p[0])));
        for (const glm::vec3& corner : p) {
            vertices.position_world.push_back(corner);
            vertices.normal_world.push_back(glm::vec3(normal));
        }
        t = {first, first + 1, first + 2};
    }
    scene.vertices = vertices;
}

/// The suite's scenes have no normals, and at most one uv set.
void add_attributes(Scene& scene) {
    for (const glm::vec3& p : scene.vertices.position_world)
        scene.vertices.normal_world.push_back(
            normalize(glm::vec3(std::sin(1.3f * p.x), 1.5f + std::cos(1.7f * p.y), std::sin(0.9f * p.z))));
    if (scene.vertices.uv.empty()) {
        scene.vertices.uv.emplace_back();
        for (const glm::vec3& p : scene.vertices.position_world)
            scene.vertices.uv[0].push_back({0.25f * p.x - 0.5f * p.y, 0.5f * p.z + 0.25f * p.y});
    }
    scene.vertices.uv.push_back(scene.vertices.uv.front());
    for (glm::vec2& uv : scene.vertices.uv.back()) uv = {0.3f * uv.y + 0.1f, 1.25f * uv.x};
}

enum class Corners { smooth, flat };

struct Mistake {
    std::string name, scene;
    Attribute attribute;
    std::function<Vector(const Shown&)> told;
    std::string cause;
    Corners corners = Corners::smooth;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

std::optional<Diagnosis> diagnosis_of(const Mistake& mistake) {
    Loaded loaded = generate_suite_scene(mistake.scene, 240, 135);
    if (mistake.corners == Corners::flat) make_flat(loaded.scene);
    if (mistake.corners == Corners::smooth) add_attributes(loaded.scene);
    const Scene& scene = loaded.scene;
    const View& view = loaded.views.front();
    Frame frame = rasterizer::render(scene, view);
    for (std::size_t c = 0; c < attribute_channels.size(); ++c)
        if (attribute_channels[c].attribute == mistake.attribute)
            frame.attributes.planes[c] = Plane<float>(frame.size());
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const auto id = std::uint32_t(frame.primitive.at(x, y));
            if (id >= scene.triangles.size()) continue;
            const glm::uvec3 t = scene.triangles[id];
            const Vector told = mistake.told({scene, view, t, weights_at(scene, view, t, x, y)});
            for (std::size_t c = 0; c < attribute_channels.size(); ++c)
                if (attribute_channels[c].attribute == mistake.attribute)
                    frame.attributes.planes[c].at(x, y) = float(told[int(attribute_channels[c].axis)]);
        }
    const Frame reference = oracle::Embree(scene).trace(view);
    const RenderedFrame ours{frame, rasterizer::precision()}, theirs{reference, oracle::embree_precision()};
    return diagnose(scene, view, ours, theirs, judge(scene, view, ours, theirs));
}

std::string told(const Explanation& e) {
    return "  " + e.name + ": " + std::to_string(e.explained) + "/" + std::to_string(e.asked) +
           ", contradicted by " + std::to_string(e.contradicted) + "/" + std::to_string(e.checked) + "\n";
}

class AttributeMistake : public testing::TestWithParam<Mistake> {};

TEST_P(AttributeMistake, IsNamed) {
    const auto diagnosis = diagnosis_of(GetParam());
    ASSERT_EQ(diagnosis.has_value(), !GetParam().name.starts_with("none"));
    if (!diagnosis) return;
    std::string text = diagnosis->cause ? told(*diagnosis->cause) : "no cause\n";
    for (const Explanation& e : diagnosis->runners_up) text += told(e);
    EXPECT_EQ(diagnosis->cause ? diagnosis->cause->name : "", GetParam().cause) << text;
}

Vector in_camera(const Shown& s, const Vector& v) {
    const Camera& c = s.view.camera;
    return {dot(c.right, v), dot(c.up, v), dot(c.back, v)};
}

Vector face_normal(const Shown& s) {
    return normalize(cross(s.corner(1) - s.corner(0), s.corner(2) - s.corner(0)));
}

/// At each place the sum over all triangles with a corner there, by their areas.
std::map<std::array<double, 3>, Vector> smooth_normals(const Scene& scene) {
    std::map<std::array<double, 3>, Vector> sums;
    for (const glm::uvec3& t : scene.triangles) {
        const auto p = [&](int i) { return Vector(scene.vertices.position_world[t[i]]); };
        const Vector area = cross(p(1) - p(0), p(2) - p(0));
        for (int i = 0; i < 3; ++i) sums.try_emplace({p(i).x, p(i).y, p(i).z}, 0).first->second += area;
    }
    return sums;
}

/// The sums are made once.
std::function<Vector(const Shown&)> smooth() {
    return [sums = std::map<std::array<double, 3>, Vector>()](const Shown& s) mutable {
        if (sums.empty()) sums = smooth_normals(s.scene);
        Vector mean(0);
        for (int i = 0; i < 3; ++i) {
            const Vector p = s.corner(i);
            mean += s.weights[i] * normalize(sums.at({p.x, p.y, p.z}));
        }
        return normalize(mean);
    };
}

Vector bary(const Vector& weights) { return {weights.y, weights.z, 0}; }

std::vector<Mistake> mistakes() {
    using enum Attribute;
    const auto eye = [](const Shown& s) { return Vector(s.view.camera.eye_world); };
    return {
        {"none", "room", normal, [](const Shown& s) { return s.normal(); }, ""},
        {"none_for_length", "room", normal, [](const Shown& s) { return 3.0 * s.normal(); }, ""},
        {"noise", "room", normal, [](const Shown& s) { return Vector(std::sin(1e4 * s.weights.x), 1, 0); },
         ""},
        {"weights_of_0_and_1", "room", barycentrics,
         [](const Shown& s) { return Vector(s.weights.x, s.weights.y, 0); },
         "barycentric weights are in another order"},
        {"weights_exchanged", "room", barycentrics,
         [](const Shown& s) { return Vector(s.weights.z, s.weights.y, 0); },
         "barycentric weights are in another order"},
        {"weights_affine", "interpenetrating", barycentrics,
         [](const Shown& s) { return bary(without_perspective(s)); },
         "barycentric weights are interpolated without perspective"},
        {"weights_as_half", "room", barycentrics,
         [](const Shown& s) { return Vector(as_half(s.weights.y), as_half(s.weights.z), 0); },
         "barycentric weights are told as half floats"},
        {"v_flipped", "textured_ground", uv, [](const Shown& s) { return Vector(s.uv().x, 1 - s.uv().y, 0); },
         "uv's v is flipped"},
        {"u_flipped", "textured_ground", uv, [](const Shown& s) { return Vector(1 - s.uv().x, s.uv().y, 0); },
         "uv's u is flipped"},
        {"uv_exchanged", "textured_ground", uv, [](const Shown& s) { return Vector(s.uv().y, s.uv().x, 0); },
         "u and v are exchanged"},
        {"uv_affine", "interpenetrating", uv,
         [](const Shown& s) {
             return Shown{s.scene, s.view, s.triangle, without_perspective(s)}.uv();
         },
         "uv is interpolated without perspective"},
        {"uv_wrapped", "textured_ground", uv, [](const Shown& s) { return s.uv() - floor(s.uv()); },
         "uv is wrapped into 0 to 1"},
        {"normals_turned", "room", normal, [](const Shown& s) { return -s.normal(); },
         "normals have the wrong sign"},
        {"normals_in_camera", "room", normal, [](const Shown& s) { return in_camera(s, s.normal()); },
         "normals are in camera space"},
        {"normals_z_up", "room", normal,
         [](const Shown& s) { return Vector(s.normal().x, -s.normal().z, s.normal().y); },
         "normals have z up instead of y"},
        {"normals_as_colours", "room", normal, [](const Shown& s) { return 0.5 * s.normal() + 0.5; },
         "normals are told as colours"},
        {"normals_of_triangles", "room", normal, face_normal, "normals are the triangles'"},
        {"normals_of_first_corner", "room", normal,
         [](const Shown& s) { return Vector(s.scene.vertices.normal_world[s.triangle.x]); },
         "normals are the first corner's"},
        {"normals_smooth", "room", normal, smooth(), "normals are smooth where the scene's are flat",
         Corners::flat},
        {"uv_of_set_1", "textured_ground", uv, [](const Shown& s) { return s.blend(s.scene.vertices.uv[1]); },
         "uv is of another set"},
        {"normals_as_half", "room", normal,
         [](const Shown& s) {
             const Vector n = s.normal();
             return Vector(as_half(n.x), as_half(n.y), as_half(n.z));
         },
         "normals are told as half floats"},
        {"positions_in_camera", "room", position,
         [=](const Shown& s) { return in_camera(s, s.position() - eye(s)); },
         "positions are in camera space"},
        {"positions_from_eye", "room", position, [=](const Shown& s) { return s.position() - eye(s); },
         "positions are relative to the eye"},
        {"positions_turned", "room", position, [](const Shown& s) { return -s.position(); },
         "positions have the wrong sign"},
        {"normals_affine", "interpenetrating", normal,
         [](const Shown& s) {
             return Shown{s.scene, s.view, s.triangle, without_perspective(s)}.normal();
         },
         "normals are interpolated without perspective"},
        {"positions_z_up", "room", position,
         [](const Shown& s) { return Vector(s.position().x, -s.position().z, s.position().y); },
         "positions have z up instead of y"},
    };
}

INSTANTIATE_TEST_SUITE_P(All, AttributeMistake, testing::ValuesIn(mistakes()),
                         [](const auto& mistake) { return mistake.param.name; });

}  // namespace
}  // namespace zproof
