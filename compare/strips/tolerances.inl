// Triangles' tolerances in a tile from their corners, by the bounds of runs.inl.

/// Triangles side by side.
struct Tolerances {
    Doubles w_per_x, w_per_y, w_offset, least, most, our_room, their_room, own;
};

[[gnu::always_inline]] inline Tolerances tolerances_of(const RunLens& lens, const Planes& planes,
                                                       const PixelBox& tile) {
    const auto ends = [](const Doubles& per_px, int first, int end) __attribute__((always_inline)) {
        const Doubles a = per_px * all(first), b = per_px * all(end - 1);
        struct Ends {
            Doubles least, most;
        };
        return Ends{lesser(a, b), greater(a, b)};
    };
    constexpr double infinite = __builtin_inf(), above_zero = 0x1p-1022, finite = 0x1p1023;
    const auto across = ends(planes.w_per_x, tile.left, tile.right),
               down = ends(planes.w_per_y, tile.top, tile.bottom);
    const Doubles gradient = magnitude(planes.w_per_x) + magnitude(planes.w_per_y),
                  kept = all(lens.kept_px) * gradient;
    const Doubles farthest = all(1 - widening) / planes.farthest + kept,
                  nearest = all(1 + widening) / planes.nearest - kept;
    const Doubles least = greater(across.least + down.least + planes.w_offset, farthest),
                  most = lesser(across.most + down.most + planes.w_offset, nearest);
    const Places places{all(1) / most, all(1) / least, least, gradient};
    const Doubles own = own_share(lens, planes, places.farthest);
    const Doubles ours = room_of(lens.candidate, planes, places),
                  theirs = room_of(lens.reference, planes, places);
    const Mask holds = not_greater(all(above_zero), least) & not_greater(least, most) &
                       not_greater(most, all(finite)) & not_greater(own, ours) & not_greater(own, theirs);
    return {planes.w_per_x,
            planes.w_per_y,
            planes.w_offset,
            chosen(holds, least, all(infinite)),
            chosen(holds, most, all(-infinite)),
            ours,
            theirs,
            own};
}

/// To each its own; nothing is said of what lies next to corners.
void put(const Tolerances& side_by_side, int count, DepthTolerance* tolerances) {
    double numbers[8][lanes];
    store(side_by_side.w_per_x, numbers[0]);
    store(side_by_side.w_per_y, numbers[1]);
    store(side_by_side.w_offset, numbers[2]);
    store(side_by_side.least, numbers[3]);
    store(side_by_side.most, numbers[4]);
    store(side_by_side.our_room, numbers[5]);
    store(side_by_side.their_room, numbers[6]);
    store(side_by_side.own, numbers[7]);
    for (int i = 0; i < count; ++i) {
        DepthTolerance& t = tolerances[i];
        t.w_per_x = numbers[0][i], t.w_per_y = numbers[1][i], t.w_offset = numbers[2][i];
        t.least = numbers[3][i], t.most = numbers[4][i];
        t.unsure = unsure;
        const double ours = numbers[5][i], theirs = numbers[6][i], own = numbers[7][i] + unsure;
        t.candidate = {ours, lesser(ours - own, 0.5)};
        t.reference = {theirs, lesser(theirs - own, 0.5)};
    }
}

void set_tolerances(const RunLens& lens, const CornerPlaces& corners, int count, const PixelBox& tile,
                    DepthTolerance* tolerances) noexcept {
    for (int i = 0; i < count; i += lanes)
        put(tolerances_of(lens, planes_of(lens, corners, i), tile), lesser(count - i, lanes), tolerances + i);
}
