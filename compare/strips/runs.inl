// Depths of a strip held against what their triangles' corners say: many runs, each of few pixels and a
// triangle of its own. Lanes are runs at first and pixels then. See docs/truth.md, "Runs by themselves".

struct Vector {
    Doubles x, y, z;
};
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector magnitude(const Vector& a) { return {magnitude(a.x), magnitude(a.y), magnitude(a.z)}; }
Doubles dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Of absolute values, with every term's.
Vector cross_abs(const Vector& a, const Vector& b) {
    return {a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x};
}
Vector all(const double (&v)[3]) { return {all(v[0]), all(v[1]), all(v[2])}; }

/// By run: its triangle along the strip, and up to that its errors are certain.
struct RunRows {
    double w_per_x[width + lanes], w_of_row[width + lanes], w_offset[width + lanes];
    double our_most[width + lanes], their_most[width + lanes];
};

/// Of triangles side by side, the bits of their laws.
struct Planes {
    Doubles w_per_x, w_per_y, w_offset;
    Doubles nearest, farthest;  ///< depths of the corners, between near and far
    /// Absolute sums behind the two products of nearness, in shares of the divisor.
    Doubles of_divisor, of_numerator;
};

Vector corner(const RunLens& lens, const std::uint32_t* at_corner) {
    const Indices at = loaded(at_corner);
    return {gathered(lens.p_world, at), gathered(lens.p_world + 1, at), gathered(lens.p_world + 2, at)};
}

/// Of as many triangles as there are lanes, from one on.
[[gnu::always_inline]] inline Planes planes_of(const RunLens& lens, const CornerPlaces& corners, int from) {
    const Vector p0 = corner(lens, corners.of[0] + from), p1 = corner(lens, corners.of[1] + from),
                 p2 = corner(lens, corners.of[2] + from);
    const Vector eye = all(lens.eye), v0 = p0 - eye, v1 = p1 - eye, v2 = p2 - eye;
    const Vector normal = cross(v1 - v0, v2 - v0);
    const Doubles reciprocal = all(1) / dot(v0, normal);
    const Vector back = all(lens.back);
    const Doubles d0 = all(-0.0) - dot(back, v0), d1 = all(-0.0) - dot(back, v1),
                  d2 = all(-0.0) - dot(back, v2);
    const auto held = [&](const Doubles& depth) {
        return lesser(greater(depth, all(lens.near_depth)), all(lens.far_depth));
    };
    const Vector e1 = p1 - p0, e2 = p2 - p0, e1_abs = magnitude(e1), e2_abs = magnitude(e2),
                 e3_abs = magnitude(e2 - e1);
    const Vector normal_abs =
        cross_abs(e1_abs, e2_abs) + cross_abs(e1_abs, e3_abs) + cross_abs(e2_abs, e3_abs);
    const Doubles over_volume = all(1) / magnitude(dot(v0, cross(e1, e2)));
    return {reciprocal * dot(normal, all(lens.step_x)),
            reciprocal * dot(normal, all(lens.step_y)),
            reciprocal * dot(normal, all(lens.direction)),
            held(lesser(lesser(d0, d1), d2)),
            held(greater(greater(d0, d1), d2)),
            dot(magnitude(v0), normal_abs) * over_volume,
            dot(all(lens.direction_abs), normal_abs) * over_volume};
}

constexpr double unit = 0x1p-53;
/// gamma(16), from above.
constexpr double of_sixteen = 17 * unit;
/// What places and errors may be off by, as DepthTolerance has it.
constexpr double widening = 128 * unit, unsure = 8 * widening;

/// Between which places on triangles lie, and how w changes there.
struct Places {
    Doubles nearest, farthest;  ///< depths
    Doubles least_w;
    Doubles gradient;
};

/// What is taken off a room, but for its own rounding.
Doubles own_share(const RunLens& lens, const Planes& planes, const Doubles& farthest) {
    const Doubles largest = magnitude(planes.w_offset) + magnitude(planes.w_per_x) * all(lens.width) +
                            magnitude(planes.w_per_y) * all(lens.height);
    const Doubles own_error = all(2 * of_sixteen) * (planes.of_numerator + largest * planes.of_divisor);
    return all(5) * own_error * farthest + all(12 * unit);
}

/// No more than the room of one renderer's errors; 0 where their sum is not far from being without limit.
[[gnu::always_inline]] inline Doubles room_of(const RunLens::Side& side, const Planes& planes,
                                              const Places& places) {
    const Doubles shift = all(side.eps_px) * places.gradient * places.nearest;  // in shares of w
    const Doubles least_of_products = planes.of_divisor + planes.of_numerator * places.nearest,
                  most_of_products = planes.of_divisor + planes.of_numerator * places.farthest;
    const Doubles least_relative = all(side.factor) + all(side.products) * least_of_products,
                  most_relative = all(side.factor) + all(side.products) * most_of_products;
    const Doubles displaced = shift * (all(1) - shift) * (all(1) - all(2) * most_relative);
    const Doubles sum =
        displaced + least_relative + all(side.of_corners) + all(side.absolute) * places.least_w;
    const Mask is_limited =
        not_greater(most_relative, all(0.5)) & not_greater(all(of_sixteen) * planes.of_divisor, all(0.25));
    return chosen(is_limited, sum * all(1 - 64 * unit), all(0));
}

/// Of as many runs as there are lanes, from one on.
[[gnu::always_inline]] inline void set_rows(RunRows& rows, int run, const Depths& depths, const Runs& runs,
                                            const RunLens& lens, const AtMost& at_most) {
    const Planes planes = planes_of(lens, runs.corners, run);
    const Doubles first = all(depths.x) + widened(runs.first + run),
                  last = all(depths.x - 1) + widened(runs.first + run + 1);
    const Doubles w_of_row = planes.w_per_y * all(depths.y);
    const Doubles at_first = planes.w_per_x * first + w_of_row + planes.w_offset,
                  at_last = planes.w_per_x * last + w_of_row + planes.w_offset;
    const Doubles least_w = lesser(at_first, at_last), most_w = greater(at_first, at_last);
    const Doubles gradient = magnitude(planes.w_per_x) + magnitude(planes.w_per_y),
                  kept = all(lens.kept_px) * gradient;
    const Mask lies_between = not_greater(all(1 + widening), (least_w - kept) * planes.farthest) &
                              not_greater((most_w + kept) * planes.nearest, all(1 - widening));
    const Places places{planes.nearest, planes.farthest, least_w, gradient};
    const Doubles own = own_share(lens, planes, planes.farthest);
    const auto most = [&](const RunLens::Side& side, double whose) __attribute__((always_inline)) {
        const Doubles room = room_of(side, planes, places);
        const Doubles error = lesser(room - own, all(whose) * room) - all(unsure);
        return chosen(lies_between, lesser(error, all(0.5)), all(-1));
    };
    store(planes.w_per_x, rows.w_per_x + run);
    store(w_of_row, rows.w_of_row + run);
    store(planes.w_offset, rows.w_offset + run);
    store(most(lens.candidate, at_most.candidate), rows.our_most + run);
    store(most(lens.reference, at_most.reference), rows.their_most + run);
}

/// Of eight pixels, a byte each: how many runs begin behind the first of them, up to it. Bit i of `turns`
/// says that one begins at pixel i.
std::uint64_t places_among(unsigned turns) {
    constexpr std::uint64_t one_each = 0x0101'0101'0101'0101, own_bits = 0x8040'2010'0804'0201;
    const std::uint64_t behind_first = turns & 0xfe;
    const std::uint64_t begins = ((behind_first * one_each & own_bits) + 0x7f * one_each) >> 7 & one_each;
    return begins * one_each;
}

/// Pixels side by side, each by its run's row.
Pixels certain_by_rows(const RunRows& rows, const Depths& depths) {
    const Columns columns(depths.x);
    Pixels found = 0;
    int run = 0;
    for (int i = 0; i < width; i += lanes) {
        constexpr unsigned every = (1u << lanes) - 1;
        const unsigned turns = unsigned(depths.turns >> i) & every;
        const std::uint64_t places = places_among(turns);
        if (i != 0) run += int(turns & 1);
        const Doubles w = at_places(rows.w_per_x + run, places) * columns.from(i) +
                          at_places(rows.w_of_row + run, places) + at_places(rows.w_offset + run, places);
        const Doubles ours = Perspective::error(widened(depths.candidate + i), w),
                      theirs = Perspective::error(widened(depths.reference + i), w);
        const Mask certain = not_greater(ours, at_places(rows.our_most + run, places)) &
                             not_greater(theirs, at_places(rows.their_most + run, places));
        found |= Pixels{bits_of(certain)} << i;
        run += int(places >> 8 * (lanes - 1) & 0xff);
    }
    return found;
}

Pixels bare_among(Pixels pixels, const Depths& depths) {
    if (pixels == 0) return 0;
    return pixels & in_run<16>(0, width, [&](int i) { return bare_from(depths, i); });
}

Pixels certain_by_corners(const Depths& depths, const Runs& runs, const RunLens& lens,
                          const AtMost& at_most) noexcept {
    RunRows rows;
    for (int run = 0; run < runs.count; run += lanes) set_rows(rows, run, depths, runs, lens, at_most);
    const Pixels every = ~Pixels{0} >> (width - runs.count);
    for (Pixels none = every & ~runs.shown; none != 0; none &= none - 1)
        rows.our_most[__builtin_ctzll(none)] = -1;
    return certain_by_rows(rows, depths) | bare_among(runs.bare, depths);
}
