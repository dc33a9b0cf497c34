#include "compare/labels/labelled_frame.h"

#include <tbb/parallel_for.h>

#include <algorithm>
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

/// The true depth, where there is one that the renderer draws at.
float depth_at(const TriangleDepth& of, const PixelCoord& pixel, double near_depth) {
    const auto truth = float(of.at(pixel.x, pixel.y).truth);
    return std::isfinite(truth) && (truth >= 0 || near_depth < 0) ? truth : 0;
}

}  // namespace

Frame with_own_depths(const Scene& scene, const View& view, const Plane<PrimitiveId>& ids,
                      const Precision& precision) {
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
                own = depth_at(depth.of(id), {x, y}, bounds.near_depth());
        }
    });
    return frame;
}

/// Half a step is as far as from any of its depths to before near: nothing is certain to hide what may have
/// been compared.
Precision with_any_depth(Precision precision, const View& view, const Frame& own_depths) {
    double largest = std::abs(view.camera.near_depth);
    for (const float depth : own_depths.camera_depth.pixels())
        if (std::isfinite(depth)) largest = std::max(largest, double(std::abs(depth)));
    std::visit([&](auto& p) { p.depth_step = 4 * largest; }, precision);
    return precision;
}

}  // namespace zproof
