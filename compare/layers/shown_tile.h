/// What a frame shows in a tile.
#pragma once

#include <algorithm>
#include <bit>
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

/// It looks into the frame, at the pixels that are asked about.
class ShownTile {
  public:
    /// Of some pixels, all in the image.
    ShownTile(const Frame& frame, const TilePlace& place, const TileMask& pixels)
        : frame_(frame), place_(place) {
        const bool is_ragged = place.left + int(tile_columns) > frame.size().width;
        ids_ = is_ragged ? strips::IdsOfTile{beyond_[0].data(), std::ptrdiff_t(tile_columns)}
                         : strips::IdsOfTile{&frame.primitive.at(place.left, place.top), frame.size().width};
        if (is_ragged)
            for_each_row(pixels, [&](int y, ColumnMask) {
                beyond_[std::size_t(y)] = taken(frame.primitive, place.row(y), PrimitiveId::none);
            });
    }
    ShownTile(const ShownTile&) = delete;

    const PrimitiveId* primitive(int y) const { return ids_.first + y * ids_.stride; }
    TileRowOf<float> camera_depth(int y) const {
        return taken(frame_.camera_depth, place_.row(y), background_depth);
    }
    /// Which of the pixels show that triangle.
    TileMask where(PrimitiveId triangle, const TileMask& pixels) const {
        auto columns = std::bit_cast<strips::ColumnsOfTile>(pixels.columns_of_row());
        strips::widest_kernel().where_shown_in_tile(ids_, triangle, columns);
        return TileMask::of(columns.of_row);
    }
    /// Calls visit(triangle, where) for each that the pixels show.
    template <class Visit>
    void for_each(TileMask pixels, const Visit& visit) const {
        while (const unsigned rows = pixels.rows_with_some()) {
            const int y = std::countr_zero(rows);
            const PrimitiveId triangle = primitive(y)[std::countr_zero(pixels.row(y))];
            const TileMask here = where(triangle, pixels);
            pixels &= ~here;
            visit(triangle, here);
        }
    }

  private:
    const Frame& frame_;
    TilePlace place_;
    strips::IdsOfTile ids_;
    std::array<TileRowOf<PrimitiveId>, TileMask::rows> beyond_;  ///< rows that reach beyond the image
};

}  // namespace zproof
