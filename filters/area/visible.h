/// What a small square of the image sees: convex pieces of triangles, cut exactly where one hides another.
#pragma once

#include <boost/container/small_vector.hpp>
#include <optional>
#include <span>
#include <vector>

#include "filters/area/polygon.h"
#include "filters/area/surfaces.h"

namespace zproof::oracle::area {

/// A visible part of a triangle; offsets from the pixel's centre.
struct Piece {
    std::uint32_t triangle = 0;
    Polygon<double> polygon{};
};

struct Visible {
    std::vector<Piece> pieces{};
    bool covers = false;  ///< is nothing of the square left but what rounding leaves?
};

/// What the square of this half-side round raster (x, y) sees of the candidates (which are in ascending
/// order). Nothing where that takes too many pieces.
std::optional<Visible> visible_pieces(const Surfaces& surfaces, std::span<const std::uint32_t> candidates,
                                      const Point<double>& centre, double half_side);

/// What one square sees, or several together.
struct Sight {
    bool covers = true;
    boost::container::small_vector<std::uint32_t, 4> triangles{};  ///< some more than once

    void add(const Visible& visible);
    void add(const Sight& other);
};

/// Are the triangles seen of one material, and linked by shared edges?
bool is_one_surface(const Surfaces& surfaces, const Sight& sight);

}  // namespace zproof::oracle::area
