// Every ray against every triangle, in float64: a renderer by the contract (docs/renderer-contract.md).
//
//   g++ -O2 -std=c++17 -o caster caster.cpp
//   zproof contract-check './caster {scene} {camera} {out}' --precision ray,arithmetic=float64
#include "zproof_contract.h"

namespace zc = zproof_contract;

/// Camera depth where the ray meets the triangle; infinity where it does not. Three Pluecker products decide.
double hit(const zc::Ray& ray, const zc::Triangle& triangle) {
    const zc::Vec3 a = triangle[0] - ray.origin, b = triangle[1] - ray.origin, c = triangle[2] - ray.origin;
    const double u = dot(cross(c - b, c + b), ray.direction), v = dot(cross(a - c, a + c), ray.direction);
    if ((u < 0 && v > 0) || (u > 0 && v < 0)) return zc::infinity;  // most triangles end here
    const double w = dot(cross(b - a, b + a), ray.direction);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return zc::infinity;
    const zc::Vec3 normal = cross(b - a, c - a);
    const double facing = dot(normal, ray.direction);
    return facing == 0 ? zc::infinity : dot(normal, a) / facing;
}

zc::Frame render(const std::vector<zc::Triangle>& triangles, const zc::Camera& camera) {
    zc::Frame frame(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const zc::Ray ray = camera.ray(x, y);
            double nearest = zc::infinity;
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                const double depth = hit(ray, triangles[i]);
                if (depth < camera.near || depth > camera.far || depth >= nearest) continue;
                nearest = depth;
                frame.set(x, y, i, depth);
            }
        }
    return frame;
}

int main(int argc, char** argv) { return zc::run(argc, argv, render); }
