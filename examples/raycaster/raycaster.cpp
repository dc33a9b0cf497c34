// Every ray against every triangle, in float64: a renderer that keeps the contract
// (docs/renderer-contract.md).
//
//   zproof contract-check './raycaster {scene} {camera} {width} {height} {out}' --precision
//   ray,arithmetic=float64
#include <array>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "image_io/image_io.h"
#include "scenes/gltf/gltf.h"

namespace {

using glm::dvec3;

dvec3 vector(const nlohmann::json& xyz) { return {xyz.at(0), xyz.at(1), xyz.at(2)}; }

/// The camera file, as far as a ray caster needs it.
struct Eye {
    int width, height;
    dvec3 eye_world, right, up, back;
    double left, right_edge, bottom, top, near, far;
    bool perspective;
    glm::dvec2 shear{0.0};
};

Eye read_camera(const char* file) {
    std::ifstream in{file};
    const auto json = nlohmann::json::parse(in);
    const auto& window = json.at("exact_window");
    const bool perspective = json.at("projection") == "perspective";
    const double far =
        json.at("far").is_string() ? std::numeric_limits<double>::infinity() : json.at("far").get<double>();
    return {
        .width = json.at("width"),
        .height = json.at("height"),
        .eye_world = vector(json.at("eye")),
        .right = vector(json.at("right")),
        .up = vector(json.at("up")),
        .back = vector(json.at("back")),
        .left = window.at("left"),
        .right_edge = window.at("right"),
        .bottom = window.at("bottom"),
        .top = window.at("top"),
        .near = json.at("near"),
        .far = far,
        .perspective = perspective,
        .shear = perspective ? glm::dvec2{0.0} : glm::dvec2{json.at("shear").at(0), json.at("shear").at(1)}};
}

/// Points of the view ray at camera depth t: from + t * to, relative to the eye.
struct Ray {
    dvec3 from{0.0}, to{0.0};
};

Ray ray_through(const Eye& e, int x, int y) {
    const double u = e.left + (e.right_edge - e.left) * (x + 0.5) / e.width;
    const double v = e.top - (e.top - e.bottom) * (y + 0.5) / e.height;
    if (e.perspective) return {.to = u * e.right + v * e.up - e.back};
    return {.from = u * e.right + v * e.up, .to = e.shear.x * e.right + e.shear.y * e.up - e.back};
}

/// Camera depth where the ray meets the triangle; infinity where it does not. Three Pluecker products decide.
double hit(const Ray& ray, const std::array<dvec3, 3>& corners) {
    const dvec3 a = corners[0] - ray.from, b = corners[1] - ray.from, c = corners[2] - ray.from;
    const double u = glm::dot(glm::cross(c - b, c + b), ray.to);
    const double v = glm::dot(glm::cross(a - c, a + c), ray.to);
    const double w = glm::dot(glm::cross(b - a, b + a), ray.to);
    constexpr double none = std::numeric_limits<double>::infinity();
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return none;
    const dvec3 normal = glm::cross(b - a, c - a);
    const double facing = glm::dot(normal, ray.to);
    return facing == 0 ? none : glm::dot(normal, a) / facing;
}

zproof::Frame render(const zproof::Scene& scene, const Eye& eye) {
    std::vector<std::array<dvec3, 3>> triangles;
    for (const glm::uvec3& t : scene.triangles) {
        const auto corner = [&](int i) { return dvec3{scene.vertices.position_world[t[i]]} - eye.eye_world; };
        triangles.push_back({corner(0), corner(1), corner(2)});
    }
    zproof::Frame frame{{eye.width, eye.height}};
    for (int y = 0; y < eye.height; ++y)
        for (int x = 0; x < eye.width; ++x) {
            const Ray ray = ray_through(eye, x, y);
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                const double depth = hit(ray, triangles[i]);
                if (depth < eye.near || depth > eye.far || depth >= nearest) continue;
                nearest = depth;
                frame.primitive.at(x, y) = zproof::PrimitiveId(i);
                frame.camera_depth.at(x, y) = float(depth);
            }
        }
    return frame;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4 && argc != 6)  // the camera file tells the size, too
        return std::cerr << "usage: raycaster SCENE.glb CAMERA.json [WIDTH HEIGHT] OUT.exr\n", 2;
    try {
        zproof::write_frame(argv[argc - 1], render(zproof::load_gltf(argv[1]).scene, read_camera(argv[2])));
        return 0;
    } catch (const std::exception& e) {
        std::cerr << "raycaster: " << e.what() << "\n";
        return 1;
    }
}
