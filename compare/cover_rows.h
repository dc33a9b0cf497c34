/// What covers and what cuts the squares of the pixels of one row of a tile, all of them side by side.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compare/acquaintance.h"

namespace zproof {

/// The triangles near one tile, at most 64 and all of them trusted; triangle k is bit k.
class CoverRows {
  public:
    static constexpr std::size_t width = 16;
    static constexpr std::size_t most_triangles = 64;
    template <class T>
    using Row = std::array<T, width>;
    using Set = std::uint64_t;

    struct Triangle {
        const TriangleFilter* filter;
        bool covers_tile;
        std::vector<const TriangleOfView*> of_view;  ///< by renderer
    };

    /// The first column's pixel index is `left`; squares have half-side half_side_px.
    CoverRows(const Sights<double>& sights, int left, double half_side_px, std::vector<Triangle> triangles);

    /// Turns to row y; nothing is done where it is at hand.
    void turn_to(int y);

    /// Triangles that certainly cover the square at column x of the row.
    Set covering(int x) const { return covering_[column(x)]; }
    /// Those that neither cover it nor miss it for certain.
    Set cutting(int x) const { return cutting_[column(x)]; }
    /// The largest eps of those that cover it; 0 for none.
    double eps_px(std::size_t renderer, int x) const { return eps_px_[renderer][column(x)]; }

  private:
    std::size_t column(int x) const { return std::size_t(x - left_); }

    const Sights<double>& sights_;
    int left_;
    double half_side_px_;
    std::vector<Triangle> triangles_;
    std::size_t renderers_;
    int y_ = -1;
    Row<Set> covering_{}, cutting_{};
    std::vector<Row<double>> eps_px_;
};

}  // namespace zproof
