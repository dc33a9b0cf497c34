#include "oracle/area_integral.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "oracle/area/row_spans.h"
#include "oracle/area/texture_integral.h"
#include "oracle/area/visible.h"

namespace zproof::oracle {

namespace {

using namespace area;

/// Beyond, samples are cheaper (docs/area-integral.md, "Cost").
constexpr double most_texels = 0x1p20;
constexpr double half_px = 0.5;

struct PixelTruth {
    glm::dvec3 mean{0};
    TruthKind kind = TruthKind::background;
};

TruthKind kind_of(const Surfaces& surfaces, const Visible& visible) {
    if (visible.pieces.empty()) return TruthKind::background;
    return visible.covers && is_one_surface(surfaces, visible.pieces) ? TruthKind::interior
                                                                      : TruthKind::silhouette;
}

/// The mean over a pixel's square; nothing where it would take too long.
std::optional<PixelTruth> exact_truth(const Surfaces& surfaces, std::span<const std::uint32_t> candidates,
                                      int x, int y) {
    const Point<double> centre{x + 0.5, y + 0.5};
    const std::optional<Visible> visible = visible_pieces(surfaces, candidates, centre, half_px);
    if (!visible) return std::nullopt;
    PixelTruth truth{.kind = kind_of(surfaces, *visible)};
    double cost = 0;
    for (const Piece& piece : visible->pieces) {
        const Homography<double> texels = from(*surfaces.seen(piece.triangle), centre.x, centre.y).texels;
        cost += texel_cost(piece.polygon, texels);
        if (!(cost <= most_texels)) return std::nullopt;
        truth.mean += nearest_integral(surfaces.colour(piece.triangle), piece.polygon, texels);
    }
    return truth;
}

/// The triangles whose span holds x, in ascending order, as x goes along a row.
class Sweep {
  public:
    explicit Sweep(std::span<const Span> row) : waiting_(row) {}

    std::span<const std::uint32_t> at(int x) {
        std::erase_if(active_, [&](const Span& s) { return s.last < x; });
        for (; !waiting_.empty() && waiting_.front().first <= x; waiting_ = waiting_.subspan(1))
            active_.push_back(waiting_.front());
        ids_.clear();
        for (const Span& s : active_) ids_.push_back(s.triangle);
        std::ranges::sort(ids_);
        return ids_;
    }

  private:
    std::span<const Span> waiting_;
    std::vector<Span> active_;
    std::vector<std::uint32_t> ids_;
};

}  // namespace

AreaTruth area_truth(const Scene& scene, const View& view, Reconstruction) {
    const Surfaces surfaces(scene, view);
    const RowSpans spans(surfaces, view, half_px);
    const Resolution size{view.width, view.height};
    AreaTruth truth{Plane<glm::dvec3>(size, glm::dvec3(0)), Plane<TruthKind>(size), Plane<double>(size)};
    tbb::parallel_for(tbb::blocked_range<int>{0, view.height, 1}, [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) {
            Sweep sweep(spans.row(y));
            for (int x = 0; x < view.width; ++x) {
                const auto exact = exact_truth(surfaces, sweep.at(x), x, y);
                truth.mean.at(x, y) = exact ? exact->mean : glm::dvec3(0);
                truth.kind.at(x, y) = exact ? exact->kind : TruthKind::sampled;
            }
        }
    });
    return truth;
}

}  // namespace zproof::oracle
