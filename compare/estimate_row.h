/// The estimates of a row of pixels, each by the triangle that it shows.
#pragma once

#include "compare/depth_estimate.h"

namespace zproof {

/// Those of sixteen pixels side by side: number by number, in the order that DepthEstimate has.
struct EstimateRow {
    struct Plane {
        TileRow w_per_x, w_per_y, w_offset;
        TileRow least, most;
    };
    struct Bound {
        TileRowOf<float> shift_base, most_shift, nearness_error;
        TileRowOf<float> beyond;
        TileRowOf<float> factor, absolute;
        TileRowOf<float> unsure;
        TileRowOf<float> top;
        TileRowOf<float> shift_per, plane_offset;  ///< unwritten for parallel projections
    };
    struct Side {
        Plane plane;
        Bound bound;
    };

    Side candidate, reference;
    bool is_one_plane;  ///< at every pixel; the candidate's side has it
};

using Estimates = TileRowOf<const DepthEstimate*>;
/// `ours` is what the candidate shows, `theirs` the reference; one object where both show the same, whose
/// planes are then put once.
void put_side_by_side(Projection projection, const Estimates& ours, const Estimates& theirs,
                      EstimateRow& row);

}  // namespace zproof
