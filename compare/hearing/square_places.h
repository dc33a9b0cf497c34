/// Which of a tile's triangles cover a pixel's square, and which may cut it, side by side.
#pragma once

#include <cstddef>
#include <vector>

#include "compare/search/triangle_filter.h"
#include "compare/strips/kernel.h"

namespace zproof {

/// Triangles by their places in the order of being added. One thread at a time.
class SquarePlaces {
  public:
    SquarePlaces();

    /// Of squares of that half-side; nothing is known of their triangles yet.
    void turn_to(double half_side_px);
    /// One that must be trusted; `covers_all` says that it covers every square which will be asked about.
    void add(const TriangleFilter& filter, bool covers_all);
    /// One of which nothing is known: it may cut any square.
    void add_unknown();

    /// Writes who covers the square around a pixel's centre for certain, and who neither covers nor misses it
    /// for certain, as TriangleFilter::place_of has it; each ascending.
    void sort(int x, int y, std::vector<std::size_t>& covering, std::vector<std::size_t>& cutting) const;

  private:
    /// Where a triangle stands among others.
    struct Lane {
        strips::Eight& eight;
        std::size_t lane;
    };
    Lane next();

    const strips::Kernel& kernel_;
    double half_side_px_ = 0;
    std::size_t count_ = 0;
    std::vector<strips::Eight> eights_;
    mutable std::vector<strips::PlacesOfEight> places_;  ///< of the square at hand
};

}  // namespace zproof
