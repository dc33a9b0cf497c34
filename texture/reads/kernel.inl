// The algorithm, for Lanes, Bits and Colour of the file that includes it:
//   lanes    how many doubles a Lanes has
//   Lanes    doubles, Bits 64-bit integers, in the compiler's own vectors
//   chosen   (numbers, indices) -> Lanes: numbers[3 * index] of each index
//   Colour   four doubles: from a lookup's sum, add(texel, weight), to the sum

Bits bits(Lanes x) { return reinterpret_cast<Bits>(x); }
Lanes lanes_of(Bits b) { return reinterpret_cast<Lanes>(b); }
Lanes all(double value) { return value + Lanes{}; }

constexpr std::int64_t sign_bit = std::numeric_limits<std::int64_t>::min();

/// floor(x), |x| <= 2^52: with 2^52 of its own sign added, x is rounded to a whole number.
Lanes whole_below(Lanes x) {
    const Lanes large = lanes_of((bits(x) & sign_bit) | bits(all(0x1p52))), nearest = (x + large) - large;
    return nearest > x ? nearest - 1 : nearest;
}

/// What is not finite or beyond 2^52 texels reads as 0.
Lanes on_line(Lanes place) { return lanes_of(bits(place) & ~sign_bit) < 0x1p52 ? place : Lanes{}; }

/// The texel that stands at a column or row, a whole number of at most 2^52 + 1. The quotient of whole
/// numbers a and b > 0, |a| < 2^53, is not rounded up to a whole one: it stays 1 / b below that, which is
/// more than half a unit in its last place.
template <Wrap wrap>
Lanes wrapped_index(Lanes index, Lanes size) {
    if constexpr (wrap == Wrap::clamp_to_edge) {
        const Lanes least = index < 0 ? Lanes{} : index;
        return least < size ? least : size - 1;
    } else if constexpr (wrap == Wrap::repeat) {
        return index - whole_below(index / size) * size;
    } else {
        const Lanes period = 2 * size, within = index - whole_below(index / period) * period;
        return within < size ? within : period - 1 - within;
    }
}

/// The two texels of an axis whose centres surround a place, and the second one's share.
struct Pair {
    Lanes first, second, share;
};

template <Wrap wrap>
Pair surrounding(Lanes place, Lanes size) {
    const Lanes between = on_line(place) - 0.5, low = whole_below(between),
                first = wrapped_index<wrap>(low, size);
    if constexpr (wrap == Wrap::repeat) return {first, first + 1 < size ? first + 1 : Lanes{}, between - low};
    return {first, wrapped_index<wrap>(low + 1, size), between - low};
}

Lanes load(const double* from) {
    Lanes values;
    __builtin_memcpy(&values, from, sizeof values);
    return values;
}

void store(double* to, Lanes values) { __builtin_memcpy(to, &values, sizeof values); }

/// Whole numbers in [0, 2^52): with 2^52 added they stand in a double's lowest bits.
void store(std::int64_t* to, Lanes values) {
    const Bits whole = bits(values + 0x1p52) ^ bits(all(0x1p52));
    __builtin_memcpy(to, &whole, sizeof whole);
}

/// Of whole numbers in [0, 2^50]. The remainder of sixteenths, less 15/32, is nearer to 0 than 1/2, so that
/// rounding to the nearest whole number rounds down.
Lanes sixteenths(Lanes number) { return (number * 0x1p-4 - 15.0 / 32 + 0x1.8p52) - 0x1.8p52; }

/// Floats before a column's texels of a tile's first row: 4 a texel, 1024 a tile.
Lanes before_column(Lanes column) { return 4 * column + sixteenths(column) * (1024 - 64); }

/// Floats before a row's first texel in an image of that width: 64 a row of a tile.
Lanes before_row(Lanes row, Lanes width) {
    const Lanes row_of_tiles = 1024 * sixteenths(width + 15);
    return 64 * row + sixteenths(row) * (row_of_tiles - 1024);
}

void find_taps(Block& block, int i, const Pair& u, const Pair& v, Lanes width) {
    const Lanes weight = load(block.weight + i),
                rows[2] = {before_row(v.first, width), before_row(v.second, width)},
                columns[2] = {before_column(u.first), before_column(u.second)},
                across[2] = {weight * (1 - u.share), weight * u.share}, along[2] = {1 - v.share, v.share};
    for (int down = 0; down < 2; ++down)
        for (int right = 0; right < 2; ++right) {
            const int tap = 2 * down + right;
            store(block.offset[tap] + i, rows[down] + columns[right]);
            store(block.tap_weight[tap] + i, across[right] * along[down]);
        }
}

static_assert(sizeof(Level) == 3 * sizeof(double));  // what `chosen` steps by

template <Wrap wrap_u, Wrap wrap_v>
void find_wrapped(const Chain& chain, Block& block) {
    for (int i = 0; i < block.count; i += lanes) {
        const Lanes width = chosen(&chain.levels->width, block.level + i),
                    height = chosen(&chain.levels->height, block.level + i);
        find_taps(block, i, surrounding<wrap_u>(load(block.x + i), width),
                  surrounding<wrap_v>(load(block.y + i), height), width);
    }
}

template <Wrap wrap_u>
void find_wrapped(const Chain& chain, Block& block) {
    if (chain.v == Wrap::repeat) return find_wrapped<wrap_u, Wrap::repeat>(chain, block);
    if (chain.v == Wrap::clamp_to_edge) return find_wrapped<wrap_u, Wrap::clamp_to_edge>(chain, block);
    find_wrapped<wrap_u, Wrap::mirrored_repeat>(chain, block);
}

/// So that the last lanes have something to read.
void fill_up(Block& block) {
    for (int i = block.count; i % lanes != 0; ++i) {
        block.x[i] = block.y[i] = block.weight[i] = 0;
        block.level[i] = 0;
    }
}

void find_taps(const Chain& chain, Block& block) noexcept {
    fill_up(block);
    if (chain.u == Wrap::repeat) return find_wrapped<Wrap::repeat>(chain, block);
    if (chain.u == Wrap::clamp_to_edge) return find_wrapped<Wrap::clamp_to_edge>(chain, block);
    find_wrapped<Wrap::mirrored_repeat>(chain, block);
}

/// The reads of a block with their taps known.
struct FoundReads {
    const Chain& chain;
    const Block& block;

    void add(int i, Colour& colour) const {
        const float* const texels = chain.levels[block.level[i]].texels;
        for (int tap = 0; tap < 4; ++tap) colour.add(texels + block.offset[tap][i], block.tap_weight[tap][i]);
    }
    void add(int from, int to, Colour& colour) const {
        for (int i = from; i < to; ++i) add(i, colour);
    }

    void add_lookup(int lookup) const {
        Colour colour{block.sum[lookup]};
        add(block.begin[lookup], block.begin[lookup + 1], colour);
        colour.to(block.sum[lookup]);
    }
    /// Two at once: each sum waits for its last addition, and there is time for the other's.
    void add_two_lookups(int lookup) const {
        const int from = block.begin[lookup], middle = block.begin[lookup + 1], to = block.begin[lookup + 2],
                  both = middle - from < to - middle ? middle - from : to - middle;
        Colour first{block.sum[lookup]}, second{block.sum[lookup + 1]};
        for (int i = 0; i < both; ++i) {
            add(from + i, first);
            add(middle + i, second);
        }
        add(from + both, middle, first);
        add(middle + both, to, second);
        first.to(block.sum[lookup]);
        second.to(block.sum[lookup + 1]);
    }
};

void add_up(const Chain& chain, const Block& block) noexcept {
    const FoundReads reads{chain, block};
    int lookup = 0;
    for (; lookup + 2 <= block.lookups; lookup += 2) reads.add_two_lookups(lookup);
    if (lookup < block.lookups) reads.add_lookup(lookup);
}
