#include "measure/flat.h"
#include "measure/instruments.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

bool is_drawn(const Frame& frame, int lane) {
    return frame.primitive.at(0, row_of(lane)) != PrimitiveId::none;
}

bool is_drawn_at(const Renderer& renderer, const View& view, float z) {
    Scene scene;
    add_flat(scene, view, 0, Half::left, z);
    return is_drawn(renderer.render(scene, view), 0);
}

/// The eye stands `depth` from z = 0, where the plane is. Outwards is towards the eye for near, away from it
/// for far.
DepthLimit depth_limit(const Renderer& renderer, Projection projection, LimitPlane plane) {
    const double depth = plane == LimitPlane::near ? depth_range_of_limits.low : depth_range_of_limits.high;
    const double outwards = plane == LimitPlane::near ? 1 : -1;
    const View view = flat_view(projection, depth, depth_range_of_limits);
    const auto z_of = [&](float out) { return float(outwards) * out; };
    const float reach = float(depth / 4);
    DepthLimit limit{.projection = projection,
                     .plane = plane,
                     .depth = depth,
                     .offset = {},
                     .keeps_plane = is_drawn_at(renderer, view, 0)};
    if (is_drawn_at(renderer, view, z_of(reach))) return limit;
    std::vector<Probe> lanes;
    for (int lane = 0; lane < lane_count; ++lane)
        lanes.push_back({.low = -reach,
                         .high = reach,
                         .draw = [&, lane](Scene& scene,
                                           float out) { add_flat(scene, view, lane, Half::left, z_of(out)); },
                         .answer = [lane](const Frame& frame) { return is_drawn(frame, lane); }});
    const Flip flip = bisect_in_lanes(renderer, view, lanes);
    limit.offset = Bracket{flip.low, flip.high};
    return limit;
}

}  // namespace

std::vector<DepthLimit> depth_limits(const Renderer& renderer) {
    std::vector<DepthLimit> limits;
    for (const Projection projection : both_projections) {
        for (const LimitPlane plane : {LimitPlane::near, LimitPlane::far})
            limits.push_back(depth_limit(renderer, projection, plane));
    }
    return limits;
}

}  // namespace zproof::measure
