#include "filters/area/area_integral.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "filters/area/pixel_estimate.h"
#include "filters/area/pixel_pieces.h"
#include "filters/area/pixel_weight.h"
#include "filters/area/row_spans.h"
#include "filters/area/texture_integral.h"
#include "filters/area/visible.h"

namespace zproof::oracle {

namespace {

using namespace area;

/// The widest of all weights' half-sides.
double widest_half_side() {
    double widest = 0;
    for (const NamedReconstruction& named : reconstructions)
        widest = std::max(widest, weight_of(named.reconstruction).half_side);
    return widest;
}

struct PixelTruth {
    glm::dvec3 mean{0};
    TruthKind kind = TruthKind::background;
};

TruthKind kind_of(const Surfaces& surfaces, const Visible& visible) {
    if (visible.pieces.empty()) return TruthKind::background;
    return visible.covers && is_one_surface(surfaces, visible.pieces) ? TruthKind::interior
                                                                      : TruthKind::silhouette;
}

/// The mean over a pixel; nothing where it would take too long.
std::optional<PixelTruth> integrated(const Surfaces& surfaces, std::span<const std::uint32_t> candidates,
                                     const glm::ivec2& pixel, Reconstruction reconstruction) {
    const Point<double> centre{pixel.x + 0.5, pixel.y + 0.5};
    const std::optional<Visible> visible = pixel_pieces(surfaces, candidates, centre, reconstruction);
    if (!visible) return std::nullopt;
    PixelTruth truth{.kind = kind_of(surfaces, *visible)};
    for (const Piece& piece : visible->pieces)
        truth.mean += colour_integral(surfaces.colour(piece.triangle), piece.polygon,
                                      texels_around(surfaces, piece.triangle, centre), reconstruction);
    truth.mean /= weight_of(reconstruction).total;
    return truth;
}

AreaTruth empty_truth(const View& view) {
    const Resolution size{view.width, view.height};
    return {Plane<glm::dvec3>(size, glm::dvec3(0)), Plane<TruthKind>(size), Plane<double>(size)};
}

template <class Work>
void for_each_row(const View& view, const Work& work) {
    tbb::parallel_for(tbb::blocked_range<int>{0, view.height, 1}, [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) work(y);
    });
}

void integrate_row(const Surfaces& surfaces, Reconstruction reconstruction, std::span<const Span> spans,
                   int y, AreaTruth& truth) {
    RowSweep sweep(spans);
    for (int x = 0; x < truth.mean.size().width; ++x) {
        const auto exact = integrated(surfaces, sweep.at(x), {x, y}, reconstruction);
        truth.kind.at(x, y) = exact ? exact->kind : TruthKind::sampled;
        if (!exact) continue;
        truth.mean.at(x, y) = exact->mean;
        if (exact->kind != TruthKind::background)
            truth.half_width.at(x, y) = weight_of(reconstruction).error * surfaces.brightest();
    }
}

/// Estimates every pixel whose kind is `sampled`.
void estimate(const PixelEstimator& estimator, const View& view, AreaTruth& truth) {
    for_each_row(view, [&](int y) {
        for (int x = 0; x < view.width; ++x) {
            if (truth.kind.at(x, y) != TruthKind::sampled) continue;
            const Estimate e = estimator.at(x, y);
            truth.mean.at(x, y) = e.mean;
            truth.half_width.at(x, y) = e.half_width;
        }
    });
}

}  // namespace

std::string letters_of(Reconstruction reconstruction) {
    const auto* const named =
        std::ranges::find(reconstructions, reconstruction, &NamedReconstruction::reconstruction);
    return std::string{named->letters};
}

std::optional<Reconstruction> reconstruction_of(std::string_view letters) {
    const auto* const named = std::ranges::find(reconstructions, letters, &NamedReconstruction::letters);
    return named == reconstructions.end() ? std::nullopt : std::optional{named->reconstruction};
}

AreaTruth area_truth(const Scene& scene, const View& view, Reconstruction reconstruction) {
    const Surfaces surfaces(scene, view);
    const RowSpans spans(surfaces, view, weight_of(reconstruction).half_side);
    AreaTruth truth = empty_truth(view);
    for_each_row(view, [&](int y) { integrate_row(surfaces, reconstruction, spans.row(y), y, truth); });
    if (std::ranges::count(truth.kind.pixels(), TruthKind::sampled) == 0) return truth;
    const Embree embree(scene);
    estimate(PixelEstimator(surfaces, embree, view, reconstruction), view, truth);
    return truth;
}

Plane<TruthKind> surfaces_around(const Scene& scene, const View& view) {
    const Surfaces surfaces(scene, view);
    const double half_side = widest_half_side();
    const RowSpans spans(surfaces, view, half_side);
    Plane<TruthKind> kinds({view.width, view.height});
    for_each_row(view, [&](int y) {
        RowSweep sweep(spans.row(y));
        for (int x = 0; x < view.width; ++x) {
            const auto visible =
                visible_pieces(surfaces, sweep.at(x), Point<double>{x + 0.5, y + 0.5}, half_side);
            kinds.at(x, y) = visible ? kind_of(surfaces, *visible) : TruthKind::silhouette;
        }
    });
    return kinds;
}

AreaTruth sampled_area_truth(const Scene& scene, const View& view, Reconstruction reconstruction) {
    const Surfaces surfaces(scene, view);
    AreaTruth truth = empty_truth(view);
    std::ranges::fill(truth.kind.pixels(), TruthKind::sampled);
    const Embree embree(scene);
    estimate(PixelEstimator(surfaces, embree, view, reconstruction), view, truth);
    return truth;
}

}  // namespace zproof::oracle
