// Bullet's ray test before the judge (docs/gallery.md), package libbullet-dev.
//
//     g++ -O2 -std=c++17 -I examples/contract -I /usr/include/bullet examples/gallery/bullet_render.cpp
//         -lBulletCollision -lLinearMath -o bullet_render
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "zproof_contract.h"

using namespace zproof_contract;

namespace {

btVector3 bullet(Vec3 p) { return {btScalar(p.x), btScalar(p.y), btScalar(p.z)}; }

/// Both sides count, and of all triangles the nearest.
struct Nearest : btTriangleRaycastCallback {
    Nearest(const btVector3& from, const btVector3& to) : btTriangleRaycastCallback(from, to) {}

    btScalar reportHit(const btVector3&, btScalar fraction, int, int triangle) override {
        if (fraction < m_hitFraction || hit < 0) hit = triangle;
        return m_hitFraction = std::min(m_hitFraction, fraction);
    }
    int hit = -1;
};

/// The depth beyond which no corner lies: a ray is as long as it must be, since a hit is told as a share of
/// it.
double end_of(const std::vector<Triangle>& triangles, const Camera& camera) {
    double end = camera.near;
    for (const Triangle& t : triangles)
        for (const Vec3& p : t) end = std::max(end, -dot(camera.back, p - camera.eye) * 1.001);
    return std::min(end, camera.far);
}

Frame render(const std::vector<Triangle>& triangles, const Camera& camera) {
    Frame frame(camera.width, camera.height);
    const double end = end_of(triangles, camera);
    if (triangles.empty() || !(end > camera.near)) return frame;
    btTriangleMesh mesh(true, false);
    for (const Triangle& t : triangles) mesh.addTriangle(bullet(t[0]), bullet(t[1]), bullet(t[2]));
    btBvhTriangleMeshShape shape(&mesh, true);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Ray ray = camera.ray(x, y);
            const btVector3 from = bullet(ray.origin + camera.near * ray.direction),
                            to = bullet(ray.origin + end * ray.direction);
            Nearest nearest(from, to);
            shape.performRaycast(&nearest, from, to);
            if (nearest.hit >= 0)
                frame.set(x, y, std::size_t(nearest.hit),
                          camera.near + (end - camera.near) * double(nearest.m_hitFraction));
        }
    return frame;
}

}  // namespace

int main(int argc, char** argv) { return run(argc, argv, render); }
