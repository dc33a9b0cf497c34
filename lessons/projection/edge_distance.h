/// How far apart are the wireframe and a renderer's picture? Where two neighbouring pixels name different
/// triangles, an edge should run between their centres; the distance between that edge and the line from
/// centre to centre is measured, pair by pair.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frame/precision.h"
#include "lessons/projection/outline.h"

namespace zproof::study::projection {

/// A pair of neighbouring pixels (above and below, or left and right) that name different triangles.
struct Boundary {
    int x = 0, y = 0;        ///< the left or upper pixel
    int to_x = 0, to_y = 0;  ///< the other
    double distance_px = 0;  ///< to the nearest edge; 0 where one runs between the centres
    double expected_px = 0;  ///< what the renderer's declared displacement allows
};

struct EdgeAgreement {
    std::string renderer;
    std::uint64_t boundaries = 0;  ///< pairs of neighbours that name different triangles
    std::uint64_t crossed = 0;     ///< an edge of one of the two runs between the centres: distance 0
    std::uint64_t displaced = 0;   ///< none does, but one passes within what displacement allows
    std::uint64_t by_depth = 0;    ///< both triangles hold both centres: surfaces cross or coincide there
    std::uint64_t by_others = 0;   ///< an edge of a third triangle passes there, which no centre sees
    std::uint64_t beyond = 0;      ///< none of this: nearest edge of the two farther than displacement allows
    double largest_px = 0;         ///< distance over all but `by_depth` and `by_others`
    double largest_share = 0;      ///< of what displacement allows, over the same
    Boundary farthest;             ///< where largest_px was met; meaningless where boundaries is 0
    std::vector<double> displaced_px;  ///< distances of `displaced` and `beyond`, rising
};

/// A displacement of eps in x and in y moves an edge by at most sqrt(2) eps; eps is the larger of both
/// triangles' own (docs/bounds.md, "eps"). Distances are worked out in float64.
EdgeAgreement edge_agreement(const Scene& scene, const View& view, const Plane<PrimitiveId>& ids,
                             const Precision& precision);

}  // namespace zproof::study::projection
