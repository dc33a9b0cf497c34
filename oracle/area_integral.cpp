#include "oracle/area_integral.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "oracle/area/pixel_estimate.h"
#include "oracle/area/pixel_pieces.h"
#include "oracle/area/row_spans.h"
#include "oracle/area/texture_integral.h"
#include "oracle/area/visible.h"

namespace zproof::oracle {

namespace {

using namespace area;

constexpr double widest_reach_px = 1;

struct PixelTruth {
    glm::dvec3 mean{0};
    TruthKind kind = TruthKind::background;
};

TruthKind kind_of(const Surfaces& surfaces, const Visible& visible) {
    if (visible.pieces.empty()) return TruthKind::background;
    return visible.covers && is_one_surface(surfaces, visible.pieces) ? TruthKind::interior
                                                                      : TruthKind::silhouette;
}

/// One reconstruction's way to integrate a pixel.
class Integral {
  public:
    Integral(const Surfaces& surfaces, Reconstruction reconstruction)
        : surfaces_(surfaces), reconstruction_(reconstruction) {}

    double reach() const { return reach_px(reconstruction_); }
    /// The bound of the mean's error, where rounding does not count.
    double bound() const { return is_gaussian() ? gaussian_error : 0; }

    /// The mean over a pixel; nothing where it would take too long.
    std::optional<PixelTruth> at(std::span<const std::uint32_t> candidates, int x, int y) const {
        const Point<double> centre{x + 0.5, y + 0.5};
        const std::optional<Visible> visible = pixel_pieces(surfaces_, candidates, centre, reconstruction_);
        if (!visible) return std::nullopt;
        PixelTruth truth{.kind = kind_of(surfaces_, *visible)};
        for (const Piece& piece : visible->pieces)
            truth.mean += integral(surfaces_.colour(piece.triangle), piece.polygon,
                                   texels_around(surfaces_, piece.triangle, centre));
        truth.mean /= is_gaussian() ? gaussian_total() : 1;
        return truth;
    }

  private:
    bool is_gaussian() const { return oracle::is_gaussian(reconstruction_); }

    glm::dvec3 integral(const SurfaceColour& colour, const Polygon<double>& piece,
                        const Homography<double>& texels) const {
        if (reconstruction_ == Reconstruction::nearest) return nearest_integral(colour, piece, texels);
        if (reconstruction_ == Reconstruction::bilinear) return bilinear_integral(colour, piece, texels);
        return is_of_nearest(reconstruction_) ? gaussian_integral_of_nearest(colour, piece, texels)
                                              : gaussian_integral(colour, piece, texels);
    }

    const Surfaces& surfaces_;
    Reconstruction reconstruction_;
};

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

void integrate_row(const Integral& integral, std::span<const Span> spans, int y, AreaTruth& truth) {
    RowSweep sweep(spans);
    for (int x = 0; x < truth.mean.size().width; ++x) {
        const auto exact = integral.at(sweep.at(x), x, y);
        truth.kind.at(x, y) = exact ? exact->kind : TruthKind::sampled;
        if (!exact) continue;
        truth.mean.at(x, y) = exact->mean;
        truth.half_width.at(x, y) = exact->kind == TruthKind::background ? 0 : integral.bound();
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

AreaTruth area_truth(const Scene& scene, const View& view, Reconstruction reconstruction) {
    const Surfaces surfaces(scene, view);
    const Integral integral(surfaces, reconstruction);
    const RowSpans spans(surfaces, view, integral.reach());
    AreaTruth truth = empty_truth(view);
    for_each_row(view, [&](int y) { integrate_row(integral, spans.row(y), y, truth); });
    if (std::ranges::count(truth.kind.pixels(), TruthKind::sampled) == 0) return truth;
    const Embree embree(scene);
    estimate(PixelEstimator(surfaces, embree, view, reconstruction), view, truth);
    return truth;
}

Plane<TruthKind> surfaces_around(const Scene& scene, const View& view) {
    const Surfaces surfaces(scene, view);
    const RowSpans spans(surfaces, view, widest_reach_px);
    Plane<TruthKind> kinds({view.width, view.height});
    for_each_row(view, [&](int y) {
        RowSweep sweep(spans.row(y));
        for (int x = 0; x < view.width; ++x) {
            const auto visible =
                visible_pieces(surfaces, sweep.at(x), Point<double>{x + 0.5, y + 0.5}, widest_reach_px);
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
