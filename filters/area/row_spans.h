/// Which triangles each row of squares has to do with, and where.
#pragma once

#include <span>
#include <vector>

#include "filters/area/surfaces.h"
#include "frame/plane.h"

namespace zproof::oracle::area {

/// Columns first to last of one row.
struct Span {
    std::uint32_t triangle = 0;
    int first = 0, last = 0;
};

/// Squares whose middles are 1 px apart.
struct SquareGrid {
    Resolution size;
    double first = 0.5;  ///< the raster x, and y, of the first one's middle
    double half_side;
};

class RowSpans {
  public:
    /// No triangle that a square shows is missed, but for slivers that rounding takes.
    RowSpans(const Surfaces& surfaces, const SquareGrid& squares);

    /// The spans of a row in the order of `first`, then of triangles.
    std::span<const Span> row(int y) const { return rows_[std::size_t(y)]; }

  private:
    std::vector<std::vector<Span>> rows_;
};

/// The triangles whose span holds x, in ascending order, as x goes along a row.
class RowSweep {
  public:
    explicit RowSweep(std::span<const Span> row) : waiting_(row) {}

    std::span<const std::uint32_t> at(int x);

  private:
    std::span<const Span> waiting_;
    std::vector<Span> active_;
    std::vector<std::uint32_t> ids_;
};

}  // namespace zproof::oracle::area
