/// What a frame shows in a tile.
#pragma once

#include <algorithm>
#include <span>

#include "compare/strips/dispatch.h"
#include "compare/strips/masks.h"
#include "compare/tile_mask.h"

namespace zproof {

/// A row of a tile; beyond the image is what is given.
template <class T>
TileRowOf<T> taken(const Plane<T>& plane, const RowPlace& at, T beyond) {
    TileRowOf<T> row;
    const std::span<const T> rest = plane.row(at.y).subspan(std::size_t(at.left));
    if (rest.size() >= tile_columns) {
        std::copy_n(rest.begin(), tile_columns, row.begin());
    } else {
        row.fill(beyond);
        std::ranges::copy(rest, row.begin());
    }
    return row;
}

/// It looks into the frame, at the rows that are asked about.
class ShownTile {
  public:
    /// Of rows that have any of the pixels.
    ShownTile(const Frame& frame, const TilePlace& place, const TileMask& pixels)
        : frame_(frame), place_(place) {
        const bool is_ragged = place.left + int(tile_columns) > frame.size().width;
        for_each_row(pixels, [&](int y, ColumnMask) {
            const auto row = std::size_t(y);
            if (is_ragged) beyond_[row] = taken(frame.primitive, place.row(y), PrimitiveId::none);
            primitive_[row] = is_ragged ? beyond_[row].data()
                                        : &frame.primitive.row(place.top + y)[std::size_t(place.left)];
        });
    }
    ShownTile(const ShownTile&) = delete;

    const PrimitiveId* primitive(int y) const { return primitive_[std::size_t(y)]; }
    TileRowOf<float> camera_depth(int y) const {
        return taken(frame_.camera_depth, place_.row(y), background_depth);
    }
    strips::IdsOfTile ids(unsigned rows) const { return {primitive_.data(), rows}; }
    /// Which of the pixels show that triangle.
    TileMask where(PrimitiveId triangle, const TileMask& pixels) const {
        strips::ColumnsOfTile columns;
        strips::widest_kernel().where_shown_in_tile(ids(pixels.rows_with_some()), triangle, columns);
        return pixels & TileMask::of(columns.of_row);
    }
    /// Calls visit(triangle, where) for each that the pixels show.
    template <class Visit>
    void for_each(TileMask pixels, const Visit& visit) const {
        for (int y = 0; y < TileMask::rows; ++y)
            while (const ColumnMask columns = pixels.row(y)) {
                const PrimitiveId triangle = primitive(y)[std::countr_zero(columns)];
                const TileMask here = where(triangle, pixels);
                pixels &= ~here;
                visit(triangle, here);
            }
    }

  private:
    const Frame& frame_;
    TilePlace place_;
    std::array<const PrimitiveId*, TileMask::rows> primitive_;
    std::array<TileRowOf<PrimitiveId>, TileMask::rows> beyond_;  ///< rows that reach beyond the image
};

/// Of those pixels.
inline TileMask where_they_differ(const ShownTile& ours, const ShownTile& theirs, const TileMask& pixels) {
    const unsigned rows = pixels.rows_with_some();
    strips::ColumnsOfTile same;
    strips::widest_kernel().where_same_in_tile(ours.ids(rows), theirs.ids(rows), same);
    return pixels & ~TileMask::of(same.of_row);
}

}  // namespace zproof
