// Coin's picking before the judge (docs/gallery.md), package libcoin-dev.
//
//     g++ -O2 -std=c++17 -I examples/contract examples/gallery/coin_render.cpp -lCoin -o coin_render
#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/details/SoFaceDetail.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>

#include "zproof_contract.h"

using namespace zproof_contract;

namespace {

SbVec3f coin(Vec3 p) { return {float(p.x), float(p.y), float(p.z)}; }

/// One face for each triangle, seen from both sides.
SoSeparator* graph_of(const std::vector<Triangle>& triangles) {
    auto* graph = new SoSeparator;
    graph->ref();
    auto* corners = new SoCoordinate3;
    auto* faces = new SoFaceSet;
    auto* hints = new SoShapeHints;
    hints->shapeType = SoShapeHints::UNKNOWN_SHAPE_TYPE;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner)
            corners->point.set1Value(int(3 * i + corner), coin(triangles[i][corner]));
        faces->numVertices.set1Value(int(i), 3);
    }
    graph->addChild(hints);
    graph->addChild(corners);
    graph->addChild(faces);
    return graph;
}

Frame render(const std::vector<Triangle>& triangles, const Camera& camera) {
    Frame frame(camera.width, camera.height);
    if (triangles.empty()) return frame;
    SoSeparator* graph = graph_of(triangles);
    SoRayPickAction pick(SbViewportRegion(short(camera.width), short(camera.height)));
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Ray ray = camera.ray(x, y);
            pick.setRay(coin(ray.origin + camera.near * ray.direction), coin(ray.direction), 0);
            pick.apply(graph);
            const SoPickedPoint* hit = pick.getPickedPoint();
            if (hit == nullptr) continue;
            const SbVec3f p = hit->getPoint();
            const double depth = -dot(camera.back, Vec3{p[0], p[1], p[2]} - camera.eye);
            const auto* face = static_cast<const SoFaceDetail*>(hit->getDetail());
            if (depth <= camera.far) frame.set(x, y, std::size_t(face->getFaceIndex()), depth);
        }
    return frame;
}

}  // namespace

int main(int argc, char** argv) {
    SoDB::init();
    return run(argc, argv, render);
}
