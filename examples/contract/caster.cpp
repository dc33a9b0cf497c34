// Every ray against every triangle that its row may meet, in float64: a renderer by the contract
// (docs/renderer-contract.md).
//
//   g++ -O2 -std=c++17 -o caster caster.cpp
//   zproof contract-check './caster {scene} {camera} {out}' --precision ray,arithmetic=float64
#include <cmath>

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

/// The rays of a row lie in one plane: they meet no triangle that lies to one side of it.
std::vector<std::size_t> in_row(int y, const std::vector<zc::Triangle>& triangles, const zc::Camera& camera) {
    const zc::Ray first = camera.ray(0, y), last = camera.ray(camera.width - 1, y);
    const zc::Vec3 normal = cross(first.direction, last.origin + last.direction - first.origin);
    std::vector<std::size_t> met;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        bool above = false, below = false;
        for (const zc::Vec3& corner : triangles[i]) {
            const zc::Vec3 p = corner - first.origin;
            const double slack = 1e-9 * std::sqrt(dot(normal, normal) * dot(p, p));  // far above rounding
            above = above || dot(normal, p) >= -slack;
            below = below || dot(normal, p) <= slack;
        }
        if (above && below) met.push_back(i);
    }
    return met;
}

zc::Frame render(const std::vector<zc::Triangle>& triangles, const zc::Camera& camera) {
    zc::Frame frame(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y) {
        const std::vector<std::size_t> met = in_row(y, triangles, camera);
        for (int x = 0; x < camera.width; ++x) {
            const zc::Ray ray = camera.ray(x, y);
            double nearest = zc::infinity;
            for (const std::size_t i : met) {
                const double depth = hit(ray, triangles[i]);
                if (depth < camera.near || depth > camera.far || depth >= nearest) continue;
                nearest = depth;
                frame.set(x, y, i, depth);
            }
        }
    }
    return frame;
}

int main(int argc, char** argv) { return zc::run(argc, argv, render); }
