// Depths of a strip held against tolerances, run by run of pixels that show one triangle.

struct Perspective {
    static Doubles error(const Doubles& z, const Doubles& nearness) {
        return magnitude(z * nearness - all(1));
    }
};
struct Parallel {
    static Doubles error(const Doubles& z, const Doubles& depth) { return magnitude(z - depth); }
};

constexpr double lesser(double a, double b) { return b < a ? b : a; }
constexpr int lesser(int a, int b) { return b < a ? b : a; }

/// A triangle along the strip.
struct Line {
    Doubles w_per_x, w_of_row, w_offset;

    Line(const DepthTolerance& t, int y)
        : w_per_x(all(t.w_per_x)), w_of_row(all(t.w_per_y * y)), w_offset(all(t.w_offset)) {}

    Doubles w_at(const Doubles& x) const { return w_per_x * x + w_of_row + w_offset; }
};

struct Between {
    Doubles least, most;

    Mask hold(const Doubles& w) const { return not_greater(least, w) & not_greater(w, most); }
};

/// Far from the corners.
struct Full {
    Line line;
    Between between;

    Full(const DepthTolerance& t, int y) : line(t, y), between{all(t.least), all(t.most)} {}
};
/// Up to that an error is there.
double most_error(const DepthTolerance& t, const DepthTolerance::Bound& bound, double at_most) {
    return lesser(bound.lawful, at_most * bound.room - t.unsure);
}

/// Next to corners.
struct NextToCorners {
    Line line;
    Between between;
    Doubles corner_least, corner_most, unsure, largest;

    NextToCorners(const DepthTolerance& t, const CornerTolerance& c, int y)
        : line(t, y),
          between{all(c.least), all(c.most)},
          corner_least(all(c.corner_least)),
          corner_most(all(c.corner_most)),
          unsure(all(t.unsure)),
          largest(all(c.largest)) {}

    Doubles distance(const Doubles& w) const { return lesser(w - corner_least, corner_most - w); }
};
/// Of a renderer.
struct RoomThere {
    Doubles at_corners, per_shift, shift, own, at_most;

    RoomThere(const CornerTolerance::Bound& bound, double most)
        : at_corners(all(bound.at_corners)),
          per_shift(all(bound.per_shift)),
          shift(all(bound.shift)),
          own(all(bound.own)),
          at_most(all(most)) {}

    Doubles most_error(const NextToCorners& triangle, const Doubles& distance) const {
        const Doubles room = at_corners + per_shift * lesser(shift, distance);
        return lesser(lesser(room - own, at_most * room) - triangle.unsure, triangle.largest);
    }
};

/// At one depth all over the image: there depths that were met say more.
bool is_level(const DepthTolerance& t) { return t.w_per_x == 0 && t.w_per_y == 0; }

/// Sixteen pixels.
Pixels bare_from(const Depths& depths, int i) {
    return Pixels{where_background(depths.candidate + i) & where_background(depths.reference + i)};
}

/// Asks for `step` pixels at once, until all from first to before end were asked for.
template <int step, class From>
[[gnu::always_inline]] inline Pixels in_run(int first, int end, const From& from) {
    constexpr int last = width - step;
    Pixels found = 0;
    for (int i = lesser(first, last);; i = lesser(i + step, last)) {
        found |= from(i) << i;
        if (i + step >= end) return found;
    }
}

int first_of(Pixels some) { return __builtin_ctzll(some); }
int end_of(Pixels some) { return width - __builtin_clzll(some); }

/// Strip::take_run, for this instruction set.
Pixels take_run(Pixels& turns) {
    const Pixels from_first = -(turns & -turns);
    turns &= turns - 1;
    return from_first & ~-(turns & -turns);
}

/// Pixels that show one triangle: from first to before end.
struct Run {
    std::uint32_t law;
    int first, end;
};

/// Of the pixels of a run; of others, anything.
template <class Projected>
[[gnu::always_inline]] inline Pixels certain_of_triangle(const Depths& depths, const Columns& columns,
                                                         const Tolerated& by, const Run& run) {
    const DepthTolerance& t = by.tolerances[run.law];
    const Full full(t, depths.y);
    const Doubles our_most = all(most_error(t, t.candidate, by.candidate_at_most)),
                  their_most = all(most_error(t, t.reference, by.reference_at_most));
    return in_run<lanes>(run.first, run.end, [&](int i) {
        const Doubles w = full.line.w_at(columns.from(i));
        const Doubles ours = Projected::error(widened(depths.candidate + i), w),
                      theirs = Projected::error(widened(depths.reference + i), w);
        return Pixels{
            bits_of(full.between.hold(w) & not_greater(ours, our_most) & not_greater(theirs, their_most))};
    });
}

template <class Projected>
Pixels certain_in_runs(const Depths& depths, const Tolerated& by, const Columns& columns) {
    Pixels all_certain = 0;
    const std::uint32_t* law = depths.law_of_run;
    for (Pixels turns = depths.turns; turns != 0; ++law) {
        const int first = first_of(turns);
        const Pixels of_run = take_run(turns);
        if ((of_run & depths.asked) == 0) continue;
        const Run run{*law, first, turns != 0 ? first_of(turns) : width};
        if (run.law != 0)
            all_certain |= of_run & certain_of_triangle<Projected>(depths, columns, by, run);
        else if (depths.primitive[run.first] == PrimitiveId::none)
            all_certain |=
                of_run & in_run<16>(run.first, run.end, [&](int i) { return bare_from(depths, i); });
    }
    return all_certain;
}

/// Of some pixels of a run.
template <class Projected>
Pixels certain_there(const Depths& depths, const Columns& columns, const Tolerated& by, std::uint32_t law,
                     Pixels some) {
    const CornerTolerance& corners = by.next_to_corners[law];
    const NextToCorners triangle(by.tolerances[law], corners, depths.y);
    const RoomThere our_room(corners.candidate, by.candidate_at_most),
        their_room(corners.reference, by.reference_at_most);
    return some & in_run<lanes>(first_of(some), end_of(some), [&](int i) {
               const Doubles w = triangle.line.w_at(columns.from(i)), distance = triangle.distance(w);
               const Doubles ours = Projected::error(widened(depths.candidate + i), w),
                             theirs = Projected::error(widened(depths.reference + i), w);
               return Pixels{bits_of(triangle.between.hold(w) &
                                     not_greater(ours, our_room.most_error(triangle, distance)) &
                                     not_greater(theirs, their_room.most_error(triangle, distance)))};
           });
}

/// Of those pixels. By itself, so that what most strips need keeps its registers.
template <class Projected>
[[gnu::noinline]] Pixels certain_next_to_corners(const Depths& depths, const Tolerated& by,
                                                 const Columns& columns, Pixels asked) {
    Pixels all_certain = 0;
    const std::uint32_t* law = depths.law_of_run;
    for (Pixels turns = depths.turns; turns != 0; ++law) {
        const Pixels some = asked & take_run(turns);
        if (some != 0 && !is_level(by.tolerances[*law]))
            all_certain |= certain_there<Projected>(depths, columns, by, *law, some);
    }
    return all_certain;
}

template <class Projected>
Pixels certain_by(const Depths& depths, const Tolerated& by) {
    const Columns columns(depths.x);
    const Pixels found = depths.asked & certain_in_runs<Projected>(depths, by, columns);
    const Pixels left = depths.asked & ~found;
    return left == 0 || !by.next_to_corners
               ? found
               : found | certain_next_to_corners<Projected>(depths, by, columns, left);
}

Pixels certain(const Depths& depths, const Tolerated& by) noexcept {
    return by.projection == Projection::perspective ? certain_by<Perspective>(depths, by)
                                                    : certain_by<Parallel>(depths, by);
}

/// Of one frame, as the same of both; with any ratio that is lawful.
template <class Projected>
Pixels lawful_of_triangle(const OneFrame& frame, const Columns& columns, const DepthTolerance& t,
                          Pixels some) {
    const Full full(t, frame.y);
    const Doubles most = all((t.*frame.bound).lawful);
    return in_run<lanes>(first_of(some), end_of(some), [&](int i) {
        const Doubles w = full.line.w_at(columns.from(i));
        const Doubles error = Projected::error(widened(frame.camera_depth + i), w);
        return Pixels{bits_of(full.between.hold(w) & not_greater(error, most))};
    });
}
template <class Projected>
[[gnu::noinline]] Pixels lawful_next_to_corners(const OneFrame& frame, const Columns& columns,
                                                const DepthTolerance& t, const CornerTolerance& corners,
                                                Pixels some) {
    const NextToCorners triangle(t, corners, frame.y);
    const RoomThere room(corners.*frame.bound_there, __builtin_inf());
    return in_run<lanes>(first_of(some), end_of(some), [&](int i) {
        const Doubles w = triangle.line.w_at(columns.from(i));
        const Doubles error = Projected::error(widened(frame.camera_depth + i), w),
                      most = room.most_error(triangle, triangle.distance(w));
        return Pixels{bits_of(triangle.between.hold(w) & not_greater(error, most))};
    });
}

template <class Projected>
Pixels lawful_in(const OneFrame& frame, const Tolerated& by) {
    const Columns columns(frame.x);
    Pixels all_lawful = 0;
    for (int k = 0; k < frame.count; ++k) {
        const auto& [law, pixels] = frame.shown[k];
        const DepthTolerance& t = by.tolerances[law];
        Pixels found = pixels & lawful_of_triangle<Projected>(frame, columns, t, pixels);
        if (const Pixels left = pixels & ~found; left != 0 && by.next_to_corners)
            found |=
                left & lawful_next_to_corners<Projected>(frame, columns, t, by.next_to_corners[law], left);
        all_lawful |= found;
    }
    return all_lawful;
}

Pixels lawful(const OneFrame& frame, const Tolerated& by) noexcept {
    return by.projection == Projection::perspective ? lawful_in<Perspective>(frame, by)
                                                    : lawful_in<Parallel>(frame, by);
}
