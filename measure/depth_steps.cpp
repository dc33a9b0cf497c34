#include <algorithm>
#include <cmath>

#include "measure/flat.h"
#include "measure/instruments.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

/// A lane's triangles, in the order in which they are drawn.
enum Drawn : std::uint32_t { one_first, other_second, other_first, one_second, drawn_count };

/// One triangle before another by `nearer`, told apart from `at` whichever is drawn first.
class Pair {
  public:
    Pair(const Renderer& renderer, Projection projection, double depth)
        : renderer_(renderer), view_(flat_view(projection, depth, depth_range_of_steps)), depth_(depth) {}

    /// How much nearer than a triangle at z = start another must be, to be seen before it.
    Flip threshold(float start) {
        std::vector<Probe> lanes;
        for (int lane = 0; lane < lane_count; ++lane)
            lanes.push_back(
                {.low = start,
                 .high = start + float(depth_ / 8),
                 .draw = [this, lane, start](Scene& scene, float z) { draw(scene, lane, start, z); },
                 .answer = [this, lane, start](const Frame& f) { return !is_nearer(f, lane, start); }});
        return bisect_in_lanes(renderer_, view_, lanes);
    }
    double error() const { return error_; }

  private:
    void draw(Scene& scene, int lane, float one, float other) {
        other_[std::size_t(lane)] = other;
        add_flat(scene, view_, lane, Half::left, one);
        add_flat(scene, view_, lane, Half::left, other);
        add_flat(scene, view_, lane, Half::right, other);
        add_flat(scene, view_, lane, Half::right, one);
    }

    bool is_nearer(const Frame& frame, int lane, float one) {
        const auto id = [&](Drawn drawn) { return PrimitiveId(drawn_count * std::uint32_t(lane) + drawn); };
        const float other = other_[std::size_t(lane)];
        const int row = row_of(lane);
        const PrimitiveId left = frame.primitive.at(0, row), right = frame.primitive.at(1, row);
        note_error(frame.camera_depth.at(0, row), left == id(other_second) ? other : one);
        note_error(frame.camera_depth.at(1, row), right == id(other_first) ? other : one);
        if ((left != id(one_first) && left != id(other_second)) ||
            (right != id(one_second) && right != id(other_first)))
            throw Unmeasurable{"a pixel does not show a triangle that covers it"};
        return left == id(other_second) && right == id(other_first);
    }

    void note_error(float seen, float z) {
        error_ = std::max(error_, std::abs(double(seen) - (depth_ - double(z))));
    }

    const Renderer& renderer_;
    View view_;
    double depth_;
    std::array<float, lane_count> other_{};  ///< where a lane has drawn the other triangle
    double error_ = 0;
};

DepthStep depth_step(const Renderer& renderer, Projection projection, double depth) {
    Pair pair(renderer, projection, depth);
    // Each threshold is where a step of the depth buffer begins: the next is one step nearer.
    const Flip first = pair.threshold(0);
    const Flip next = pair.threshold(first.high);
    return {.projection = projection,
            .depth = depth,
            .step = {double(next.low) - double(first.high), double(next.high) - double(first.low)},
            .error = pair.error()};
}

}  // namespace

std::vector<DepthStep> depth_steps(const Renderer& renderer) {
    std::vector<DepthStep> steps;
    for (const Projection projection : both_projections) {
        for (const double depth : {1.5, 24.0, 384.0})
            steps.push_back(depth_step(renderer, projection, depth));
    }
    return steps;
}

}  // namespace zproof::measure
