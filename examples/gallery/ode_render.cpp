// ODE's ray collider before the judge (docs/gallery.md), package libode-dev.
//
//     g++ -O2 -std=c++17 -I examples/contract examples/gallery/ode_render.cpp -lode -o ode_render
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "zproof_contract.h"

using namespace zproof_contract;

namespace {

/// The depth beyond which no corner lies: a ray is that long.
double end_of(const std::vector<Triangle>& triangles, const Camera& camera) {
    double end = camera.near;
    for (const Triangle& t : triangles)
        for (const Vec3& p : t) end = std::max(end, -dot(camera.back, p - camera.eye) * 1.001);
    return std::min(end, camera.far);
}

dGeomID mesh_of(const std::vector<Triangle>& triangles) {
    static std::vector<double> corners;
    static std::vector<dTriIndex> indices;
    for (const Triangle& t : triangles)
        for (const Vec3& p : t) {
            indices.push_back(dTriIndex(indices.size()));
            corners.insert(corners.end(), {p.x, p.y, p.z});
        }
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, corners.data(), 3 * sizeof(double), int(indices.size()), indices.data(),
                                int(indices.size()), 3 * sizeof(dTriIndex));
    return dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
}

Frame render(const std::vector<Triangle>& triangles, const Camera& camera) {
    Frame frame(camera.width, camera.height);
    const double end = end_of(triangles, camera);
    if (triangles.empty() || !(end > camera.near)) return frame;
    const dGeomID mesh = mesh_of(triangles);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Ray ray = camera.ray(x, y);
            const Vec3 from = ray.origin + camera.near * ray.direction, d = ray.direction;
            const double length = std::sqrt(dot(d, d));
            const dGeomID geom = dCreateRay(nullptr, (end - camera.near) * length);
            dGeomRaySet(geom, from.x, from.y, from.z, d.x, d.y, d.z);
            dGeomRaySetClosestHit(geom, 1);
            dContactGeom hit;
            if (dCollide(mesh, geom, 1, &hit, sizeof hit) > 0)
                frame.set(x, y, std::size_t(hit.side1), camera.near + hit.depth / length);
            dGeomDestroy(geom);
        }
    return frame;
}

}  // namespace

int main(int argc, char** argv) {
    dInitODE2(0);
    return run(argc, argv, render);
}
