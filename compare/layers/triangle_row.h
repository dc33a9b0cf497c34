/// What a triangle does to sixteen pixels of a row: each number in the same bits as one pixel by itself gets
/// it.
#pragma once

#include "compare/search/acquaintance.h"
#include "compare/tile_row.h"

namespace zproof {

/// The lines of sight of a row.
class SightRow {
  public:
    SightRow(const Sights<double>& sights, const RowPlace& row);

    Sight<double> at(std::size_t column) const { return sights_->at(row_.left + int(column), row_.y); }
    /// ImageOfView::nearness_at.
    TileRow nearness(const KeptPlane& plane) const;

  private:
    const Sights<double>* sights_;
    RowPlace row_;
    std::array<TileRow, 3> direction_;
};

/// One triangle along a row.
class TriangleRow {
  public:
    /// As any renderer has it. `sight` must outlive this.
    TriangleRow(const ImageOfView& image, const SightRow& sight);

    /// TriangleOfView::eps_px.
    TileRow eps_px(const TriangleOfView& triangle) const;

    /// Neighbour::least_nearness and greatest_nearness.
    struct Range {
        TileRow least, greatest;
    };
    Range nearness_range(const TriangleOfView& triangle) const;

  private:
    const SightRow* sight_;
    std::optional<KeptPlane> plane_;
    TileRow nearness_;  ///< where there is a plane
};

}  // namespace zproof
