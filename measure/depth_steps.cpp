#include <algorithm>
#include <cmath>

#include "measure/flat.h"
#include "measure/instruments.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

constexpr PrimitiveId one_first{0}, other_second{1}, other_first{2}, one_second{3};

/// One triangle before another by `nearer`, told apart from `at` whichever is drawn first.
class Pair {
  public:
    Pair(const Renderer& renderer, Projection projection, double depth)
        : renderer_(renderer), view_(flat_view(projection, depth, depth_range_of_steps)), depth_(depth) {}

    /// How much nearer than a triangle at z = start another must be, to be seen before it.
    Flip threshold(float start) {
        const Probe probe{.low = start,
                          .high = start + float(depth_ / 8),
                          .draw = [&](Scene& scene, float z) { draw(scene, start, z); },
                          .answer = [&](const Frame& frame) { return !is_nearer(frame); }};
        return bisect(renderer_, view_, {probe}).front();
    }
    double error() const { return error_; }

  private:
    void draw(Scene& scene, float one, float other) {
        one_ = one, other_ = other;
        add_flat(scene, view_, Half::left, one);
        add_flat(scene, view_, Half::left, other);
        add_flat(scene, view_, Half::right, other);
        add_flat(scene, view_, Half::right, one);
    }

    bool is_nearer(const Frame& frame) {
        const PrimitiveId left = frame.primitive.at(0, 0), right = frame.primitive.at(1, 0);
        note_error(frame.camera_depth.at(0, 0), left == other_second ? other_ : one_);
        note_error(frame.camera_depth.at(1, 0), right == other_first ? other_ : one_);
        if ((left != one_first && left != other_second) || (right != one_second && right != other_first))
            throw Unmeasurable{"a pixel does not show a triangle that covers it"};
        return left == other_second && right == other_first;
    }

    void note_error(float seen, float z) {
        error_ = std::max(error_, std::abs(double(seen) - (depth_ - double(z))));
    }

    const Renderer& renderer_;
    View view_;
    double depth_;
    float one_ = 0, other_ = 0;
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
