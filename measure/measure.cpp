#include "measure/measure.h"

#include "measure/instruments.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

/// Thrown through an instrument that the audience does not want to see to its end.
struct Stopped {};

/// Runs instruments one by one, before an audience.
class Bench {
  public:
    Bench(Measurement& measurement, const Audience& audience)
        : measurement_(measurement), audience_(audience) {}

    /// What it cannot measure is written down.
    template <class Work>
    void attempt(const std::string& what, int pictures, Work work) {
        if (audience_.wants_to_stop()) return;
        audience_.begins(what, pictures);
        try {
            work();
        } catch (const Unmeasurable& e) {
            measurement_.unmeasured.push_back(what + ": " + e.what());
        } catch (const Stopped&) {
            return;
        }
        audience_.ends();
    }

  private:
    Measurement& measurement_;
    const Audience& audience_;
};

/// Draws for as long as the audience stays.
Renderer watched(const Renderer& renderer, const Audience& audience) {
    return {.name = renderer.name,
            .render =
                [&](const Scene& scene, const View& view) {
                    if (audience.wants_to_stop()) throw Stopped{};
                    return renderer.render(scene, view);
                },
            .declared = renderer.declared};
}

/// Where the sample was found, by the simplest number that it can be; else where it should be.
Sample sample_of(const Measurement& measurement) {
    const auto& [x, y] = measurement.centre_px;
    return {x ? simplest_in(*x) : 0.5, y ? simplest_in(*y) : 0.5};
}

}  // namespace

Measurement measure(const Renderer& subject, const Audience& audience) {
    Measurement m;
    Bench bench{m, audience};
    const Renderer renderer = watched(subject, audience);
    bench.attempt("pixel centre", 2, [&] {
        const auto [x, y] = pixel_centre(renderer);
        m.centre_px = {x, y};
    });
    const Sample sample = sample_of(m);
    for (const Axis axis : both_axes)
        bench.attempt(axis == Axis::x ? "sub-pixel grid, x" : "sub-pixel grid, y", 32,
                      [&] { m.displacement[std::size_t(axis)] = displacement(renderer, sample, axis); });
    bench.attempt("fill side", 1, [&] { m.fill = fill_sides(renderer, sample); });
    bench.attempt("depth steps", 372, [&] { m.depth_steps = depth_steps(renderer); });
    bench.attempt("near and far", 140, [&] { m.depth_limits = depth_limits(renderer); });
    bench.attempt("watertightness", 42, [&] { m.watertightness = watertightness(renderer, sample); });
    return m;
}

}  // namespace zproof::measure
