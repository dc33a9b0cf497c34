#include "filters/area/area_integral.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "filters/area/pixel_estimate.h"
#include "filters/area/pixel_weight.h"
#include "filters/area/row_spans.h"
#include "filters/area/texture_integral.h"
#include "filters/area/unit_squares.h"
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

/// What a unit square shows; none where it is not integrated.
using SquareSight = std::optional<Sight>;

TruthKind kind_of(const Surfaces& surfaces, const Sight& sight) {
    if (sight.triangles.empty()) return TruthKind::background;
    return sight.covers && is_one_surface(surfaces, sight) ? TruthKind::interior : TruthKind::silhouette;
}

AreaTruth empty_truth(const View& view) {
    const Resolution size{view.width, view.height};
    return {Plane<glm::dvec3>(size, glm::dvec3(0)), Plane<TruthKind>(size), Plane<double>(size)};
}

template <class Work>
void for_each_row(int first, int beyond, const Work& work) {
    tbb::parallel_for(tbb::blocked_range<int>{first, beyond, 1}, [&](const tbb::blocked_range<int>& range) {
        for (int y = range.begin(); y != range.end(); ++y) work(y);
    });
}

/// Integrates unit squares, some rows at a time, and adds what each has for its pixels to these.
class Integration {
  public:
    Integration(const Surfaces& surfaces, const View& view, Reconstruction reconstruction)
        : surfaces_(surfaces),
          reconstruction_(reconstruction),
          squares_(surfaces, view, reconstruction),
          each_(std::size_t(squares_.across() * squares_.across())),
          sights_({squares_.size().width, rows_at_once + squares_.across() - 1}),
          truth_(empty_truth(view)) {
        sums_.resize(std::size_t(rows_at_once) * std::size_t(squares_.size().width) * each_);
    }

    AreaTruth truth() {
        const int rows = squares_.size().height, before = squares_.across() - 1;
        for (int first = 0; first < rows; first += rows_at_once) {
            const int beyond = std::min(first + rows_at_once, rows);
            for_each_row(first, beyond, [&](int row) { integrate_row(row); });
            for (int row = first; row < beyond; ++row) add_row(row);
            for_each_row(std::max(first - before, 0), beyond - before, [&](int y) { finish_row(y); });
        }
        return std::move(truth_);
    }

  private:
    static constexpr int rows_at_once = 64;

    /// What was seen in rows before these is kept as long as pixels need it.
    SquareSight& sight(int column, int row) { return sights_.at(column, row % sights_.size().height); }

    std::span<glm::dvec3> sums(int column, int row) {
        const std::size_t square =
            std::size_t(row % rows_at_once) * std::size_t(squares_.size().width) + std::size_t(column);
        return std::span(sums_).subspan(square * each_, each_);
    }

    void integrate_row(int row) {
        RowSweep sweep(squares_.row(row));
        for (int column = 0; column < squares_.size().width; ++column) {
            const std::span<glm::dvec3> sums = this->sums(column, row);
            std::ranges::fill(sums, glm::dvec3(0));
            sight(column, row).reset();
            const std::optional<Visible> visible = squares_.visible(sweep.at(column), column, row);
            if (!visible) continue;
            for (const Piece& piece : visible->pieces)
                add_colour(surfaces_.colour(piece.triangle), piece.polygon,
                           squares_.texels_around(piece.triangle, column, row), reconstruction_, sums);
            sight(column, row).emplace().add(*visible);
        }
    }

    /// Of a square's pixels, the last has the square's own column and row.
    void add_row(int row) {
        const int across = squares_.across();
        for (int column = 0; column < squares_.size().width; ++column) {
            const std::span<const glm::dvec3> sums = this->sums(column, row);
            for (std::size_t pixel = 0; pixel < sums.size(); ++pixel) {
                const int x = column + 1 - across + int(pixel) % across,
                          y = row + 1 - across + int(pixel) / across;
                const auto [width, height] = truth_.mean.size();
                if (x >= 0 && x < width && y >= 0 && y < height) truth_.mean.at(x, y) += sums[pixel];
            }
        }
    }

    void finish_row(int y) {
        for (int x = 0; x < truth_.kind.size().width; ++x) finish(x, y);
    }

    void finish(int x, int y) {
        Sight seen;
        truth_.kind.at(x, y) = TruthKind::sampled;
        for (int i = 0; i < squares_.across() * squares_.across(); ++i) {
            const SquareSight& square = sight(x + i % squares_.across(), y + i / squares_.across());
            if (!square) return;
            seen.add(*square);
        }
        const PixelWeight& weight = weight_of(reconstruction_);
        truth_.kind.at(x, y) = kind_of(surfaces_, seen);
        truth_.mean.at(x, y) /= weight.total;
        if (truth_.kind.at(x, y) != TruthKind::background)
            truth_.half_width.at(x, y) = weight.error * surfaces_.brightest();
    }

    const Surfaces& surfaces_;
    Reconstruction reconstruction_;
    UnitSquares squares_;
    std::size_t each_;  ///< pixels that a square counts for
    Plane<SquareSight> sights_;
    AreaTruth truth_;
    std::vector<glm::dvec3> sums_;
};

/// Estimates every pixel whose kind is `sampled`.
void estimate(const PixelEstimator& estimator, const View& view, AreaTruth& truth) {
    for_each_row(0, view.height, [&](int y) {
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
    AreaTruth truth = Integration(surfaces, view, reconstruction).truth();
    if (std::ranges::count(truth.kind.pixels(), TruthKind::sampled) == 0) return truth;
    const Embree embree(scene);
    estimate(PixelEstimator(surfaces, embree, view, reconstruction), view, truth);
    return truth;
}

Plane<TruthKind> surfaces_around(const Scene& scene, const View& view) {
    const Surfaces surfaces(scene, view);
    const double half_side = widest_half_side();
    const RowSpans spans(surfaces, {.size = {view.width, view.height}, .half_side = half_side});
    Plane<TruthKind> kinds({view.width, view.height});
    for_each_row(0, view.height, [&](int y) {
        RowSweep sweep(spans.row(y));
        for (int x = 0; x < view.width; ++x) {
            const auto visible =
                visible_pieces(surfaces, sweep.at(x), Point<double>{x + 0.5, y + 0.5}, half_side);
            Sight sight;
            if (visible) sight.add(*visible);
            kinds.at(x, y) = visible ? kind_of(surfaces, sight) : TruthKind::silhouette;
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
