/// Where a triangle covers a pixel for certain, where it may, and which of two is nearer there: in intervals
/// that hold whatever a renderer's arithmetic and displacement may make of it.
#pragma once

#include <optional>

#include "filters/conformance/filter_precision.h"
#include "filters/reference/barycentrics.h"
#include "math/interval_functions.h"

namespace zproof::oracle::filter_reference {

/// The sample's place, and all that the renderer may displace it to.
struct SampleBox {
    Interval x, y;
};
SampleBox sample_box(int x, int y, double displacement_px);

enum class Coverage { none, undecided, certain };

class CoveringTriangle {
  public:
    /// bounds 0 to 2 are the edges opposite the corners, 3 and 4 the far and near planes.
    static constexpr std::size_t bound_count = 5, edge_count = 3;

    CoveringTriangle(const View& view, const std::array<glm::vec3, 3>& corners_world,
                     const FilterPrecision& precision);

    Coverage coverage(const SampleBox& box) const;
    /// May the box reach beyond that bound? Of a triangle that may be edge-on, beyond any.
    bool is_undecided(std::size_t bound, const SampleBox& box) const;
    /// Is it nearer than the other all over the box, for certain?
    bool is_certainly_nearer_than(const CoveringTriangle& other, const SampleBox& box) const;
    /// Is its edge the other's, with each triangle on its own side of it?
    bool continues_at(std::size_t edge, const CoveringTriangle& other, std::size_t other_edge) const;

  private:
    /// Positive within the bound; with what arithmetic may cost.
    struct Bound {
        Affine<Interval> exact;
        Affine<Magnitude> size;
    };
    /// An edge as the corners that it runs between, the triangle to its left.
    struct Edge {
        glm::vec3 from, to;
    };
    Interval over(const Bound& bound, const SampleBox& box) const;

    double rounding_;  ///< relative to the terms' size
    bool is_edge_on_ = false;
    std::array<Bound, bound_count> bounds_;
    std::array<Edge, edge_count> edges_;
    Bound inverse_depth_;  ///< times |facing()|
    Interval facing_;
    Magnitude facing_size_;
};

}  // namespace zproof::oracle::filter_reference
