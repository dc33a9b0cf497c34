#include "filters/area/area_weights.h"

#include "filters/area/pixel_weight.h"
#include "filters/area/texture_integral.h"
#include "filters/area/unit_squares.h"

namespace zproof::oracle {

using namespace area;

struct AreaWeights::Parts {
    Surfaces surfaces;
    UnitSquares squares;
    Reconstruction reconstruction;

    Parts(const Scene& scene, const View& view, Reconstruction how)
        : surfaces(scene, view), squares(surfaces, view, how), reconstruction(how) {}

    /// What a square shows of its triangles; nothing where it is not integrated.
    std::optional<Visible> visible(int column, int row) const {
        RowSweep sweep(squares.row(row));
        return squares.visible(sweep.at(column), column, row);
    }
};

AreaWeights::AreaWeights(const Scene& scene, const View& view, Reconstruction reconstruction)
    : parts_(std::make_unique<Parts>(scene, view, reconstruction)) {}

AreaWeights::~AreaWeights() = default;

std::optional<std::vector<TexelWeight>> AreaWeights::at(int x, int y) const {
    const auto& [surfaces, squares, reconstruction] = *parts_;
    const int squares_of_pixel = squares.across() * squares.across();
    const double total = weight_of(reconstruction).total;
    std::vector<TexelWeight> weights;
    for (int i = 0; i < squares_of_pixel; ++i) {
        const int column = x + i % squares.across(), row = y + i / squares.across();
        const std::optional<Visible> visible = parts_->visible(column, row);
        if (!visible) return std::nullopt;
        for (const Piece& piece : visible->pieces) {
            if (surfaces.colour(piece.triangle).image == nullptr) continue;
            const int material = surfaces.material(piece.triangle);
            // Of a pixel's first square, the pixel is the last.
            visit_weights(piece.polygon, squares.texels_around(piece.triangle, column, row), reconstruction,
                          squares_of_pixel - 1 - i, [&](const Cell& cell, double weight) {
                              weights.push_back({material, cell.column, cell.row, weight / total});
                          });
        }
    }
    return weights;
}

}  // namespace zproof::oracle
