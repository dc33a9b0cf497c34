#include "measure/measure.h"

#include "measure/instruments.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

/// Runs one instrument; what it cannot measure is written down.
template <class Work>
void attempt(Measurement& measurement, const std::string& what, Work work) {
    try {
        work();
    } catch (const Unmeasurable& e) {
        measurement.unmeasured.push_back(what + ": " + e.what());
    }
}

/// Where the sample was found, by the simplest number that it can be; else where it should be.
Sample sample_of(const Measurement& measurement) {
    const auto& [x, y] = measurement.centre_px;
    return {x ? simplest_in(*x) : 0.5, y ? simplest_in(*y) : 0.5};
}

}  // namespace

Measurement measure(const Renderer& renderer) {
    Measurement m;
    attempt(m, "pixel centre", [&] {
        const auto [x, y] = pixel_centre(renderer);
        m.centre_px = {x, y};
    });
    const Sample sample = sample_of(m);
    for (const Axis axis : both_axes)
        attempt(m, axis == Axis::x ? "sub-pixel grid, x" : "sub-pixel grid, y",
                [&] { m.displacement[std::size_t(axis)] = displacement(renderer, sample, axis); });
    attempt(m, "fill side", [&] { m.fill = fill_sides(renderer, sample); });
    attempt(m, "depth steps", [&] { m.depth_steps = depth_steps(renderer); });
    attempt(m, "near and far", [&] { m.depth_limits = depth_limits(renderer); });
    attempt(m, "watertightness", [&] { m.watertightness = watertightness(renderer, sample); });
    return m;
}

}  // namespace zproof::measure
