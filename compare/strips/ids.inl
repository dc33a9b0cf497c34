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
    const PrimitiveId* row = ids.first;
    for (int y = 0; y < Tiles::side_px; ++y, row += ids.stride)
        if (const unsigned asked = columns.of_row[y]; asked != 0)
            columns.of_row[y] = std::uint16_t(asked & where_equal(row, id));
}
