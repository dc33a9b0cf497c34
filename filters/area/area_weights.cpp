#include "filters/area/area_weights.h"

#include <algorithm>

#include "filters/area/pixel_pieces.h"
#include "filters/area/pixel_weight.h"
#include "filters/area/row_spans.h"
#include "filters/area/texture_integral.h"

namespace zproof::oracle {

using namespace area;

struct AreaWeights::Parts {
    Surfaces surfaces;
    RowSpans spans;
    Reconstruction reconstruction;

    Parts(const Scene& scene, const View& view, Reconstruction how)
        : surfaces(scene, view), spans(surfaces, view, weight_of(how).half_side), reconstruction(how) {}

    /// The triangles whose spans of the row hold x, in ascending order.
    std::vector<std::uint32_t> candidates(int x, int y) const {
        RowSweep sweep(spans.row(y));
        const std::span<const std::uint32_t> found = sweep.at(x);
        return {found.begin(), found.end()};
    }
};

AreaWeights::AreaWeights(const Scene& scene, const View& view, Reconstruction reconstruction)
    : parts_(std::make_unique<Parts>(scene, view, reconstruction)) {}

AreaWeights::~AreaWeights() = default;

std::optional<std::vector<TexelWeight>> AreaWeights::at(int x, int y) const {
    const Point<double> centre{x + 0.5, y + 0.5};
    const Surfaces& surfaces = parts_->surfaces;
    const std::optional<Visible> visible =
        pixel_pieces(surfaces, parts_->candidates(x, y), centre, parts_->reconstruction);
    if (!visible) return std::nullopt;
    const double total = weight_of(parts_->reconstruction).total;
    std::vector<TexelWeight> weights;
    for (const Piece& piece : visible->pieces) {
        if (surfaces.colour(piece.triangle).image == nullptr) continue;
        const int material = surfaces.material(piece.triangle);
        visit_weights(piece.polygon, texels_around(surfaces, piece.triangle, centre), parts_->reconstruction,
                      [&](const Cell& cell, double weight) {
                          weights.push_back({material, cell.column, cell.row, weight / total});
                      });
    }
    return weights;
}

}  // namespace zproof::oracle
