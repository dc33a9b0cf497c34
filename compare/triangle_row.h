/// What a triangle does to sixteen pixels of a row: each number in the same bits as one pixel by itself gets
/// it.
#pragma once

#include "compare/acquaintance.h"
#include "compare/depth_law.h"
#include "compare/lanes.h"

namespace zproof {

/// The lines of sight of a row.
class SightRow {
  public:
    SightRow(const Sights<double>& sights, const LaneRow& row);

    Sight<double> at(std::size_t lane) const { return sights_->at(row_.left + int(lane), row_.y); }
    /// Of a perspective.
    const std::array<Lanes, 3>& direction() const { return direction_; }

  private:
    const Sights<double>* sights_;
    LaneRow row_;
    std::array<Lanes, 3> direction_;
};

struct PlaceMasks {
    LaneMask covers = 0, cuts = 0;  ///< cuts: neither covers nor misses for certain
};

/// TriangleFilter::place_of the squares of that half-side.
PlaceMasks places_in_row(const TriangleFilter& filter, const LaneRow& row, double half_side_px);

/// TriangleOfView::eps_px.
Lanes eps_px_in_row(const TriangleOfView& triangle, const SightRow& sight);

/// Neighbour::least_nearness and greatest_nearness.
struct NearnessRow {
    Lanes least, greatest;
};
NearnessRow nearness_in_row(const TriangleOfView& triangle, const SightRow& sight);

}  // namespace zproof
