/// The rays of 4 x 4 pixels at a time, as Embree takes them: what belongs to a view, a column or a row of
/// pixels is worked out once per view.
#pragma once

#include <array>
#include <vector>

#include "oracle/primary_ray.h"
#include "oracle/rtcore.h"

namespace zproof::oracle {

class BlockRays {
  public:
    static constexpr int side = 4;  ///< pixels
    static constexpr int lanes = side * side;

    /// One coordinate of what varies, as primary_ray() adds it up: (column + row) + last.
    struct Coordinate {
        std::vector<double> of_column, of_row;
        double last = 0;
    };

    explicit BlockRays(const View& view);

    /// Fills what all rays of the view have in common, with their bits in primary_ray(): tnear, origins or
    /// directions, and what Embree wants of a fresh ray but tfar.
    void begin(RTCRay16& rays) const;

    /// Fills the rest, for the pixels (left + lane % 4, top + lane / 4), with the bits of primary_ray():
    /// directions or origins, and tfar, where Embree has left what it hit. left and top: multiples of 4, at
    /// most 3 pixels beyond the image.
    void aim(int left, int top, RTCRay16& rays) const;

    /// The depth of every ray's origin, as in PrimaryRay.
    double origin_depth() const { return any_.origin_depth; }

  private:
    PrimaryRay any_;
    bool perspective_;
    std::array<Coordinate, 3> varying_;
};

}  // namespace zproof::oracle
