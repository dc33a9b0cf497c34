// OpenSceneGraph's segment and one triangle, asked in double (docs/found.md).
#include <osg/Geode>
#include <osg/Geometry>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include <cstdio>

/// Does the segment through (x, y), along z, meet the triangle (0, 0), b, c of the plane z = 0?
static bool meets(double x, double y, const osg::Vec3& b, const osg::Vec3& c) {
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    corners->push_back(osg::Vec3(0, 0, 0));
    corners->push_back(b);
    corners->push_back(c);
    osg::ref_ptr<osg::Geometry> triangle = new osg::Geometry;
    triangle->setVertexArray(corners);
    triangle->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(triangle);
    osg::ref_ptr<osgUtil::LineSegmentIntersector> segment =
        new osgUtil::LineSegmentIntersector(osg::Vec3d(x, y, 10), osg::Vec3d(x, y, -10));
    segment->setPrecisionHint(osgUtil::Intersector::USE_DOUBLE_CALCULATIONS);
    osgUtil::IntersectionVisitor visitor(segment);
    node->accept(visitor);
    return segment->containsIntersections();
}

int main() {
    const osg::Vec3 right(4097, 0, 0), top(0, 4097, 0);
    const bool as_is = meets(2048.50001, 2048.5, right, top), turned = meets(2048.50001, 2048.5, top, right);
    std::printf("counter-clockwise: %s, clockwise: %s; right is: miss, miss\n", as_is ? "hit" : "miss",
                turned ? "hit" : "miss");
    return as_is || turned ? 1 : 0;
}
