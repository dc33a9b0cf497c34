/// One tile's z-buffer: scan, depth test, and the resolve into the frame.
#pragma once

#include <array>
#include <cstdint>

#include "frame/frame.h"
#include "rasterizer/tile_bins.h"

namespace zproof::rasterizer {

/// The pixels of one tile while triangles are drawn into it.
///
/// Depth at a sample is N = (E0 N0 + E1 N1 + E2 N2) / 2A, the E exact integers held in doubles, the N
/// nearness at the vertices. Of a covered sample all E are >= 0 and for perspective all N are > 0: nothing
/// cancels, so six roundings (1/depth, N / 2A, product, two sums) leave N within a few 2^-53 of the affine
/// interpolant, relatively. For parallel projections the same holds of the greatest |depth| of the triangle.
/// Then N is rounded once to float32.
class Tile {
  public:
    Tile(const PixelRect& pixels, const ViewSetup& setup) noexcept;

    void draw(const SnappedTriangle& triangle) noexcept;

    /// Instead of drawing: one more at each pixel of this tile that draw() would visit, hidden or not.
    void count(const SnappedTriangle& triangle, Plane<std::uint32_t>& fragments) const noexcept;

    /// Writes ids and camera depths of this tile's pixels.
    void resolve(Frame& frame) const noexcept;

  private:
    struct Scan;

    using EdgeValues = std::array<std::int64_t, 3>;
    struct Span {
        int first, end;
    };

    /// The scan that draw() and count() share: row(scan, row_start, span, y) of each row with covered
    /// samples.
    template <class Row>
    void for_each_row(const SnappedTriangle& triangle, Row row) const noexcept;
    static Span covered(const Scan& scan, const EdgeValues& row_start) noexcept;
    void draw_row(const Scan& scan, const EdgeValues& row_start, Span span, int row) noexcept;

    PixelRect pixels_;
    const ViewSetup& setup_;
    alignas(64) std::array<std::array<float, tile_size>, tile_size> nearness_;
    alignas(64) std::array<std::array<PrimitiveId, tile_size>, tile_size> primitive_;
};

}  // namespace zproof::rasterizer
