#include "measure/measure.h"

#include "measure/instruments.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

/// Thrown through an instrument that is stopped by the progress sink.
struct Stopped {};

/// Runs instruments one by one, and reports progress.
class InstrumentRunner {
  public:
    InstrumentRunner(Measurement& measurement, const ProgressSink& progress)
        : measurement_(measurement), progress_(progress) {}

    /// What it cannot measure is written down.
    template <class Work>
    void attempt(const std::string& what, int pictures, Work work) {
        if (progress_.wants_to_stop()) return;
        progress_.begins(what, pictures);
        try {
            work();
        } catch (const Unmeasurable& e) {
            measurement_.unmeasured.push_back(what + ": " + e.what());
        } catch (const Stopped&) {
            return;
        }
        progress_.ends();
    }

  private:
    Measurement& measurement_;
    const ProgressSink& progress_;
};

/// Draws until the progress sink wants to stop.
Renderer interruptible(const Renderer& renderer, const ProgressSink& progress) {
    return {.name = renderer.name,
            .render =
                [&](const Scene& scene, const View& view) {
                    if (progress.wants_to_stop()) throw Stopped{};
                    return renderer.render(scene, view);
                },
            .declared = renderer.declared};
}

/// The sample's place, as the simplest number that it can be; where it was not found, the place where it
/// should be.
Sample sample_of(const Measurement& measurement) {
    const auto& [x, y] = measurement.centre_px;
    return {x ? simplest_in(*x) : 0.5, y ? simplest_in(*y) : 0.5};
}

}  // namespace

Measurement measure(const Renderer& subject, const ProgressSink& progress) {
    Measurement m;
    InstrumentRunner runner{m, progress};
    const Renderer renderer = interruptible(subject, progress);
    runner.attempt("pixel centre", 2, [&] {
        const auto [x, y] = pixel_centre(renderer);
        m.centre_px = {x, y};
    });
    const Sample sample = sample_of(m);
    for (const Axis axis : both_axes)
        runner.attempt(axis == Axis::x ? "sub-pixel grid, x" : "sub-pixel grid, y", 32,
                       [&] { m.displacement[std::size_t(axis)] = displacement(renderer, sample, axis); });
    runner.attempt("fill side", 1, [&] { m.fill = fill_sides(renderer, sample); });
    runner.attempt("depth steps", 70, [&] { m.depth_steps = depth_steps(renderer); });
    runner.attempt("near and far", 32, [&] { m.depth_limits = depth_limits(renderer); });
    runner.attempt("watertightness", 42, [&] { m.watertightness = watertightness(renderer, sample); });
    return m;
}

}  // namespace zproof::measure
