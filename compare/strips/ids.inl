// Ids of a strip, sixteen at a time.

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
