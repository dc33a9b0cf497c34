/// The estimates of sixteen pixels, each by the triangle that it shows: number by number, in the order that
/// DepthEstimate has.
#pragma once

#include "compare/depth_estimate.h"
#include "compare/runs.h"
#include "compare/tile_row.h"

namespace zproof {

/// Of a tile's columns.
using Estimates = SpreadValues<const DepthEstimate*, tile_columns>;

struct EstimateRow {
    struct Plane {
        TileRow w_per_x, w_per_y, w_offset;
        TileRow least, most;
    };
    struct Quiet {
        TileRowOf<float> shift, slope, room, unused;
    };
    struct Bound {
        TileRowOf<float> shift_base, most_shift, nearness_error;
        TileRowOf<float> beyond;
        TileRowOf<float> factor, absolute;
        TileRowOf<float> unsure;
        TileRowOf<float> top;
        TileRowOf<float> shift_per, plane_offset;  ///< unwritten for parallel projections
    };
};

void put_side_by_side(const Estimates& triangles, EstimateRow::Plane& row);
/// Of the triangles' two.
void put_side_by_side(const Estimates& triangles, DepthEstimate::Quiet DepthEstimate::*whose,
                      EstimateRow::Quiet& row);
void put_side_by_side(const Estimates& triangles, DepthEstimate::Bound DepthEstimate::*whose,
                      Projection projection, EstimateRow::Bound& row);

}  // namespace zproof
