// Lines of taps, a lookup in each lane, for the file that includes it after taps.inl and block.inl. While the
// taps of some reads are found and asked of memory, those found before are summed: as many sums at a time as
// there are lanes, none of which waits for another.

/// Reads whose taps are known: the same number of each of `lanes` lookups.
struct Batch {
    struct Reads {
        alignas(64) std::int64_t offset[4][lanes];
        alignas(64) double weight[4][lanes];

        /// Where a lane has none (its `read` is 0), it reads the chain's first texel, which is 0, whatever it
        /// weighs. No sum of products is -0 before, so that adds nothing.
        void set(const Taps& taps, Bits read) {
            for (int tap = 0; tap < 4; ++tap) {
                store(offset[tap], taps.offset[tap] & read);
                store(weight[tap], taps.weight[tap]);
            }
        }
        /// The texels are asked of memory.
        void fetch(const float* texels) const {
            for (int lane = 0; lane < lanes; ++lane) {
                __builtin_prefetch(texels + offset[0][lane]);
                __builtin_prefetch(texels + offset[2][lane]);
            }
        }
    };
    static constexpr int most = 128 / lanes;  ///< reads of a lookup

    Reads reads[most];
    double* sum[lanes];
    int count = 0;  ///< reads of a lookup

    template <std::size_t... lane>
    void sum_up(const float* texels, std::index_sequence<lane...>) const {
        Colour sums[] = {Colour{sum[lane]}...};
        for (int i = 0; i < count; ++i)
            for (int tap = 0; tap < 4; ++tap)
                (sums[lane].add(texels + reads[i].offset[tap][lane], reads[i].weight[tap][lane]), ...);
        (sums[lane].to(sum[lane]), ...);
    }
};

/// One of the two levels of `lanes` lookups.
struct LineLevel {
    Images images;
    Lanes scale_x, scale_y, weight;
    Bits read;  ///< all bits, or none where the level is not read

    template <class Gather>
    LineLevel(const Level* levels, Lanes of_level, const Gather& gather)
        : images{levels, gather},
          scale_x{gather(&levels->scale_x)},
          scale_y{gather(&levels->scale_y)},
          weight{of_level},
          read{of_level != 0} {}
};

/// Neighbours mostly read the same level: then nothing is gathered.
LineLevel line_level(const Level* levels, const std::int32_t* index, Lanes weight) {
    bool are_same = true;
    for (int lane = 1; lane < lanes; ++lane) are_same &= index[lane] == index[0];
    if (are_same)
        return {levels, weight, [&](const double* of) { return splat(of[std::ptrdiff_t{8} * index[0]]); }};
    return {levels, weight, [&](const double* of) { return gather(of, index); }};
}

/// The largest of `lanes` numbers that are not negative.
double largest(const double* numbers) {
    double most = 0;
    for (int lane = 0; lane < lanes; ++lane) most = numbers[lane] > most ? numbers[lane] : most;
    return most;
}

/// Lines of `lanes` lookups.
struct Group {
    Lanes x, y, across, down, taps, each;
    LineLevel finer, coarser;

    Group(const Chain& chain, const Lines& lines, int i)
        : x{load(lines.x + i)},
          y{load(lines.y + i)},
          across{load(lines.across + i)},
          down{load(lines.down + i)},
          taps{load(lines.taps + i)},
          each{1 / taps},
          finer{line_level(chain.levels, lines.finer + i, each * (1 - load(lines.share + i)))},
          coarser{line_level(chain.levels, lines.coarser + i, each * load(lines.share + i))} {}
};

template <Wrap wrap_u, Wrap wrap_v>
class LineReader {
  public:
    explicit LineReader(const Chain& chain) : chain_{chain} {}
    LineReader(const LineReader&) = delete;
    LineReader& operator=(const LineReader&) = delete;
    ~LineReader() { turn_over(); }

    void read(const Lines& lines, int i) {
        const Group group{chain_, lines, i};
        const double most = largest(lines.taps + i);
        const bool is_alone = largest(lines.share + i) == 0;  // the finer level is
        open(lines, i);
        const auto along = [&](double tap) {
            return (tap + lines.spacing.first) / (group.taps + lines.spacing.more) - 0.5;
        };
        Lanes next = along(0);
        for (double tap = 0; tap < most; ++tap) {
            const Lanes here = next;
            next = along(tap + 1);  // a division, in time
            if (filled_->count + 2 > Batch::most) {
                turn_over();
                open(lines, i);
            }
            const Lanes x = group.x + here * group.across, y = group.y + here * group.down;
            if (is_alone)
                read_finer(group, x, y, tap < group.taps);
            else
                read_both(group, x, y, tap < group.taps);
        }
        turn_over();
    }

  private:
    void open(const Lines& lines, int i) {
        for (int lane = 0; lane < lanes; ++lane) filled_->sum[lane] = lines.sum[i + lane];
    }
    static Taps taps(const LineLevel& level, Lanes x, Lanes y) {
        const Pair u = surrounding<wrap_u>(x * level.scale_x, level.images.u),
                   v = surrounding<wrap_v>(y * level.scale_y, level.images.v);
        return {level.images, level.weight, u, v};
    }
    void read_finer(const Group& group, Lanes x, Lanes y, Bits reads) {
        Batch::Reads& finer = filled_->reads[filled_->count];
        finer.set(taps(group.finer, x, y), reads & group.finer.read);
        finer.fetch(chain_.texels);
        filled_->count += 1;
    }
    /// Reads both levels; neither read waits for the other.
    void read_both(const Group& group, Lanes x, Lanes y, Bits reads) {
        Batch::Reads *const finer = filled_->reads + filled_->count, *const coarser = finer + 1;
        const Taps of_finer = taps(group.finer, x, y), of_coarser = taps(group.coarser, x, y);
        finer->set(of_finer, reads & group.finer.read);
        coarser->set(of_coarser, reads & group.coarser.read);
        finer->fetch(chain_.texels);
        coarser->fetch(chain_.texels);
        filled_->count += 2;
    }
    /// The full batch's texels are on their way, and the one before is summed and empty.
    void turn_over() {
        if (found_->count > 0) found_->sum_up(chain_.texels, std::make_index_sequence<lanes>{});
        Batch* const empty = found_;
        found_ = filled_;
        filled_ = empty;
        filled_->count = 0;
    }

    const Chain chain_;
    Batch batches_[2];
    Batch *filled_ = &batches_[0], *found_ = &batches_[1];
};

/// Fills the last lanes, so that they have something to read; it is added to `nobody`.
void fill_up(Lines& lines, double* nobody) {
    for (int i = lines.count; i % lanes != 0; ++i) {
        lines.x[i] = lines.y[i] = lines.across[i] = lines.down[i] = 0;
        lines.taps[i] = lines.share[i] = 0;
        lines.finer[i] = lines.coarser[i] = 0;
        lines.sum[i] = nobody;
    }
}

template <Wrap wrap_u, Wrap wrap_v>
void add_wrapped_lines(const Chain& chain, const Lines& lines) {
    LineReader<wrap_u, wrap_v> reader{chain};
    for (int i = 0; i < lines.count; i += lanes) reader.read(lines, i);
}

void add_lines(const Chain& chain, Lines& lines) noexcept {
    double nobody[4] = {};
    fill_up(lines, nobody);
    by_wrap(chain, [&]<Wrap u, Wrap v>() { add_wrapped_lines<u, v>(chain, lines); });
}
