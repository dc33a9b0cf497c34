#include "compare/cover_rows.h"

#include <algorithm>
#include <cmath>

namespace zproof {

namespace {

using Row = CoverRows::Row<double>;
using Flags = CoverRows::Row<std::uint64_t>;  ///< 0 or 1

using RowOfSight = CoverRows::Row<Sight<double>>;

/// Where a row of squares lies.
struct Squares {
    int left, y;
    double half_side_px;
};

/// As TriangleFilter::place_of has it, with the same bits.
[[gnu::target_clones("default", "avx2", "avx512f")]] void place(const TriangleFilter& filter,
                                                                const Squares& at, Flags& covers,
                                                                Flags& cuts) {
    Flags misses{};
    Flags inside;
    inside.fill(1);
    for (const Affine<double>& e : filter.edge) {
        const double reach =
            at.half_side_px * std::abs(e.a) + at.half_side_px * std::abs(e.b) + filter.edge_error;
        const double along_column = e.b * at.y;
        for (std::size_t i = 0; i < CoverRows::width; ++i) {
            const double middle = e.a * double(at.left + int(i)) + along_column + e.c;
            misses[i] |= std::uint64_t(middle + reach < 0);
            inside[i] &= std::uint64_t(middle - reach > 0);
        }
    }
    for (std::size_t i = 0; i < CoverRows::width; ++i) {
        covers[i] = inside[i] & ~misses[i];
        cuts[i] = 1 & ~inside[i] & ~misses[i];
    }
}

/// To the eps of a triangle where it covers.
void raise(const TriangleOfView& triangle, const RowOfSight& sight, const Flags& covers, Row& eps_px) {
    for (std::size_t i = 0; i < CoverRows::width; ++i)
        if (covers[i] != 0) eps_px[i] = std::max(eps_px[i], triangle.eps_px(sight[i]));
}

}  // namespace

CoverRows::CoverRows(const Sights<double>& sights, int left, double half_side_px,
                     std::vector<Triangle> triangles)
    : sights_(sights),
      left_(left),
      half_side_px_(half_side_px),
      triangles_(std::move(triangles)),
      renderers_(triangles_.empty() ? 0 : triangles_.front().of_view.size()),
      eps_px_(renderers_) {}

void CoverRows::turn_to(int y) {
    if (y == y_) return;
    y_ = y;
    covering_ = {}, cutting_ = {};
    for (Row<double>& eps : eps_px_) eps.fill(0);
    RowOfSight sight;
    for (std::size_t i = 0; i < width; ++i) sight[i] = sights_.at(left_ + int(i), y);
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
        Flags covers, cuts{};
        covers.fill(1);
        if (!triangles_[k].covers_tile) place(*triangles_[k].filter, {left_, y, half_side_px_}, covers, cuts);
        for (std::size_t i = 0; i < width; ++i) {
            covering_[i] |= covers[i] << k;
            cutting_[i] |= cuts[i] << k;
        }
        for (std::size_t r = 0; r < renderers_; ++r)
            raise(*triangles_[k].of_view[r], sight, covers, eps_px_[r]);
    }
}

}  // namespace zproof
