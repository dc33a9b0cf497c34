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

/// Up to that an error is.
double most_error(const DepthTolerance& t, const DepthTolerance::Bound& bound, double at_most) {
    return lesser(lesser(bound.lawful, at_most) * bound.room - t.unsure, t.largest);
}

/// A triangle along the strip.
struct Line {
    Doubles w_per_x, w_of_row, w_offset, least, most;

    Line(const DepthTolerance& t, int y)
        : w_per_x(all(t.w_per_x)),
          w_of_row(all(t.w_per_y * y)),
          w_offset(all(t.w_offset)),
          least(all(t.least)),
          most(all(t.most)) {}

    Doubles w_at(const Doubles& x) const { return w_per_x * x + w_of_row + w_offset; }
    Mask holds_at(const Doubles& w) const { return not_greater(least, w) & not_greater(w, most); }
};

/// And what errors of both renderers are at most.
struct Row {
    Line line;
    Doubles our_most, their_most;
};
Row row_of(const DepthTolerance& t, int y, const Tolerated& by) {
    return {Line(t, y), all(most_error(t, t.candidate, by.candidate_at_most)),
            all(most_error(t, t.reference, by.reference_at_most))};
}

/// The x of each pixel of a strip.
struct Columns {
    double x[width];

    explicit Columns(int first) {
        for (int i = 0; i < width; i += lanes) store(all(double(first + i)) + counted(), x + i);
    }
};

/// The pixels from i on, as many as there are lanes.
template <class Projected>
Pixels certain_from(const Row& row, const Depths& depths, const Columns& columns, int i) {
    const Doubles w = row.line.w_at(loaded(columns.x + i));
    const Doubles ours = Projected::error(widened(depths.candidate + i), w),
                  theirs = Projected::error(widened(depths.reference + i), w);
    return Pixels{bits_of(row.line.holds_at(w) & not_greater(ours, row.our_most) &
                          not_greater(theirs, row.their_most))};
}

/// Sixteen pixels.
Pixels bare_from(const Depths& depths, int i) {
    return Pixels{where_background(depths.candidate + i) & where_background(depths.reference + i)};
}

/// Asks for `step` pixels at once, until all from first to before end were asked for.
template <int step, class From>
Pixels in_run(int first, int end, const From& from) {
    constexpr int last = width - step;
    Pixels found = 0;
    for (int i = lesser(first, last);; i = lesser(i + step, last)) {
        found |= from(i) << i;
        if (i + step >= end) return found;
    }
}

/// Pixels that show one triangle: from first to before end.
struct Run {
    std::uint32_t law;
    int first, end;
};

/// The pixels of a run; of others, anything.
template <class Projected>
[[gnu::always_inline]] inline Pixels certain_in_run(const Depths& depths, const Columns& columns,
                                                    const Tolerated& by, const Run& run) {
    if (run.law == 0) {
        if (depths.primitive[run.first] != PrimitiveId::none) return 0;
        return in_run<16>(run.first, run.end, [&](int i) { return bare_from(depths, i); });
    }
    const Row row = row_of(by.tolerances[run.law], depths.y, by);
    return in_run<lanes>(run.first, run.end,
                         [&](int i) { return certain_from<Projected>(row, depths, columns, i); });
}

template <class Projected>
Pixels certain_in_runs(const Depths& depths, const Tolerated& by) {
    const Columns columns(depths.x);
    Pixels all_certain = 0;
    const std::uint32_t* law = depths.law_of_run;
    for (Pixels turns = depths.turns; turns != 0; ++law) {
        const Pixels from_first = -(turns & -turns);  // all pixels from the run's first on
        turns &= turns - 1;
        const Pixels beyond = -(turns & -turns);  // and from the next one's
        const Run run{*law, __builtin_ctzll(from_first), turns != 0 ? __builtin_ctzll(turns) : width};
        all_certain |= certain_in_run<Projected>(depths, columns, by, run) & from_first & ~beyond;
    }
    return all_certain;
}

Pixels certain(const Depths& depths, const Tolerated& by) noexcept {
    return by.projection == Projection::perspective ? certain_in_runs<Perspective>(depths, by)
                                                    : certain_in_runs<Parallel>(depths, by);
}

template <class Projected>
Pixels lawful_in(const OneFrame& frame, const DepthTolerance* tolerances) {
    const Columns columns(frame.x);
    Pixels found = 0;
    for (int k = 0; k < frame.count; ++k) {
        const auto& [law, pixels] = frame.shown[k];
        const DepthTolerance& t = tolerances[law];
        const Line line(t, frame.y);
        const Doubles most = all(most_error(t, t.*frame.bound, __builtin_inf()));
        const int first = __builtin_ctzll(pixels), end = width - __builtin_clzll(pixels);
        found |= pixels & in_run<lanes>(first, end, [&](int i) {
                     const Doubles w = line.w_at(loaded(columns.x + i));
                     const Doubles error = Projected::error(widened(frame.camera_depth + i), w);
                     return Pixels{bits_of(line.holds_at(w) & not_greater(error, most))};
                 });
    }
    return found;
}

Pixels lawful(const OneFrame& frame, const DepthTolerance* tolerances, Projection projection) noexcept {
    return projection == Projection::perspective ? lawful_in<Perspective>(frame, tolerances)
                                                 : lawful_in<Parallel>(frame, tolerances);
}
