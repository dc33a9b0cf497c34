// OpenSceneGraph's intersector before the judge (docs/gallery.md), package libopenscenegraph-dev.
//
//     g++ -O2 -std=c++17 -I examples/contract examples/gallery/osg_render.cpp -losgUtil -losg -lOpenThreads
//         -o osg_render
#include <osg/Geode>
#include <osg/Geometry>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include <algorithm>
#include <cmath>

#include "zproof_contract.h"

using namespace zproof_contract;

namespace {

osg::Vec3d osg_of(Vec3 p) { return {p.x, p.y, p.z}; }

/// The depth beyond which no corner lies: a segment is as long as it must be.
double end_of(const std::vector<Triangle>& triangles, const Camera& camera) {
    double end = camera.near;
    for (const Triangle& t : triangles)
        for (const Vec3& p : t) end = std::max(end, -dot(camera.back, p - camera.eye) * 1.001);
    return std::min(end, camera.far);
}

osg::ref_ptr<osg::Geode> node_of(const std::vector<Triangle>& triangles) {
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const Triangle& t : triangles)
        for (const Vec3& p : t) corners->push_back(osg_of(p));
    osg::ref_ptr<osg::Geometry> mesh = new osg::Geometry;
    mesh->setVertexArray(corners);
    mesh->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, int(corners->size())));
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(mesh);
    return node;
}

Frame render(const std::vector<Triangle>& triangles, const Camera& camera) {
    Frame frame(camera.width, camera.height);
    const double end = end_of(triangles, camera);
    if (triangles.empty() || !(end > camera.near)) return frame;
    const osg::ref_ptr<osg::Geode> node = node_of(triangles);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Ray ray = camera.ray(x, y);
            const osg::ref_ptr<osgUtil::LineSegmentIntersector> segment =
                new osgUtil::LineSegmentIntersector(osg_of(ray.origin + camera.near * ray.direction),
                                                    osg_of(ray.origin + end * ray.direction));
            segment->setIntersectionLimit(osgUtil::Intersector::LIMIT_NEAREST);
            osgUtil::IntersectionVisitor visitor(segment);
            node->accept(visitor);
            if (!segment->containsIntersections()) continue;
            const auto hit = segment->getFirstIntersection();
            frame.set(x, y, hit.primitiveIndex, camera.near + (end - camera.near) * hit.ratio);
        }
    return frame;
}

}  // namespace

int main(int argc, char** argv) { return run(argc, argv, render); }
