// Ids of a strip or a tile, sixteen at a time.

Pixels where_shown(const PrimitiveId* ids, PrimitiveId id) noexcept {
    Pixels shown = 0;
    for (int first = 0; first < width; first += 16) shown |= Pixels{where_equal(ids + first, id)} << first;
    return shown;
}

Ids compare(const PrimitiveId* candidate, const PrimitiveId* reference) noexcept {
    Pixels same = 0, goes_on = 0;
    for (int first = 0; first < width; first += 16)
        same |= Pixels{where_equal(candidate + first, reference + first)} << first;
    for (const int first : {0, 16, 32, 47})  // none reads behind the last pixel
        goes_on |= Pixels{where_equal(candidate + first + 1, candidate + first)} << (first + 1);
    return {~goes_on, ~same, __builtin_popcountll(~goes_on)};
}

void where_shown_in_tile(const IdsOfTile& ids, PrimitiveId id, ColumnsOfTile& columns) noexcept {
    for (int y = 0; y < Tiles::side_px; ++y)
        columns.of_row[y] = std::uint16_t((ids.asked >> y & 1) != 0 ? where_equal(ids.rows[y], id) : 0);
}

void where_same_in_tile(const IdsOfTile& a, const IdsOfTile& b, ColumnsOfTile& columns) noexcept {
    for (int y = 0; y < Tiles::side_px; ++y)
        columns.of_row[y] = std::uint16_t((a.asked >> y & 1) != 0 ? where_equal(a.rows[y], b.rows[y]) : 0);
}
