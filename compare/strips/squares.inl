// Where triangles lie in a square, side by side.

/// Of as many triangles as there are lanes, from one on.
[[gnu::always_inline]] inline PlacesOfEight places_from(const Eight& triangles, int from, const Doubles& x,
                                                        const Doubles& y) {
    constexpr unsigned every = (1u << lanes) - 1;
    const Doubles none = all(0);
    unsigned misses = 0, covers = every;
    for (const EdgesOfEight& edges : triangles.edges) {
        const Doubles middle =
            loaded(edges.a + from) * x + loaded(edges.b + from) * y + loaded(edges.c + from);
        const Doubles reach = loaded(edges.reach + from);
        misses |= bits_of(less(middle + reach, none));
        covers &= bits_of(less(none, middle - reach));
    }
    return {std::uint8_t(covers & ~misses), std::uint8_t(~covers & ~misses & every)};
}

void set_places(const Eight* triangles, int count, double x, double y, PlacesOfEight* places) noexcept {
    const Doubles all_x = all(x), all_y = all(y);
    for (int i = 0; i < count; ++i) {
        unsigned covers = 0, cuts = 0;
        for (int from = 0; from < 8; from += lanes) {
            const PlacesOfEight some = places_from(triangles[i], from, all_x, all_y);
            covers |= unsigned(some.covers) << from, cuts |= unsigned(some.cuts) << from;
        }
        places[i] = {std::uint8_t(covers), std::uint8_t(cuts)};
    }
}
