#include "compare/labels/labelled_frame.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "compare/bounds/pixel_coord.h"
#include "compare/bounds/triangle_depth.h"

namespace zproof {

namespace {

/// The depth of the triangle that was asked about last.
class DepthOfLast {
  public:
    DepthOfLast(const Scene& scene, const View& view, const ViewBounds& bounds)
        : scene_(scene), view_(view), bounds_(bounds) {}

    const TriangleDepth& of(PrimitiveId id) {
        if (id != last_) {
            const CornersWorld p_world = corners_of(scene_, std::uint32_t(id));
            depth_ = TriangleDepth(TriangleInView(view_, bounds_, p_world), bounds_);
            last_ = id;
        }
        return depth_;
    }

  private:
    const Scene& scene_;
    const View& view_;
    const ViewBounds& bounds_;
    PrimitiveId last_ = PrimitiveId::none;
    TriangleDepth depth_;
};

/// A depth within the bound, if float32 has one and it is easily found.
float depth_within(const TriangleDepth& of, const PixelCoord& pixel, float of_reference,
                   Projection projection) {
    const DepthBound bound = of.at(pixel.x, pixel.y);
    const auto truth = float(bound.truth);
    if (of.certainly_holds(bound, truth)) return truth;
    if (of.certainly_holds(bound, of_reference)) return of_reference;
    const bool is_depth = std::isfinite(truth) && (truth >= 0 || projection == Projection::parallel);
    return is_depth ? truth : 0;
}

}  // namespace

Frame with_own_depths(const Scene& scene, const View& view, const Plane<PrimitiveId>& ids,
                      const Precision& precision, const Frame& reference) {
    Frame frame = Frame::unwritten(ids.size());
    const ViewBounds bounds = ViewBounds::of_shown(view, precision);
    tbb::parallel_for(0, view.height, [&](int y) {
        DepthOfLast depth(scene, view, bounds);
        for (int x = 0; x < view.width; ++x) {
            const PrimitiveId id = ids.at(x, y);
            frame.primitive.at(x, y) = id;
            float& own = frame.camera_depth.at(x, y);
            if (id == PrimitiveId::none)
                own = background_depth;
            else if (std::size_t(id) >= scene.triangles.size())
                own = 0;
            else
                own = depth_within(depth.of(id), {x, y}, reference.camera_depth.at(x, y),
                                   view.camera.projection);
        }
    });
    return frame;
}

}  // namespace zproof
