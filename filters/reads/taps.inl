// Where the taps of bilinear reads stand, for Lanes and Bits of the file that includes it:
//   lanes        how many doubles a Lanes has
//   Lanes        doubles, Bits 64-bit integers, in the compiler's own vectors
//   chosen       (numbers, indices) -> Lanes: numbers[8 * index] of each index
//   product      (a, b) -> Bits, of numbers in [0, 2^32)
//   whole_below  (x) -> Lanes: floor(x), |x| <= 2^52; the sign of a 0 is anybody's

Bits bits(Lanes x) { return reinterpret_cast<Bits>(x); }
Lanes lanes_of(Bits b) { return reinterpret_cast<Lanes>(b); }
Lanes splat(double value) { return value + Lanes{}; }

/// What is not finite or beyond 2^52 texels reads as 0.
Lanes on_line(Lanes place) {
    const Lanes size = lanes_of(bits(place) & std::numeric_limits<std::int64_t>::max());
    return size < 0x1p52 ? place : Lanes{};
}

/// An axis of an image, in each lane that of its own level.
struct Axis {
    Lanes size, per_size;  ///< texels; 1 / size, rounded

    Axis operator*(double power_of_two) const { return {power_of_two * size, per_size / power_of_two}; }
};

/// What is left of a whole number, at most 2^52 in size, when whole sizes are taken away: [0, size).
/// The quotient is exact where size is a power of two. Else let 2^-p < 1 / size < 2^(1 - p). Then per_size is
/// within 2^(-p - 53) of 1 / size, which the index makes 2^(-p - 1) at most; the product is below 2^(53 - p),
/// and rounding it adds 2^(-p - 1) at most: together less than 1 / size. So the quotient k + r / size, r <
/// size, comes out below k + 1 and above k - 1, and is rounded down to k or k - 1. All else is exact.
Lanes remainder(Lanes index, const Axis& axis) {
    const Lanes rest = index - whole_below(index * axis.per_size) * axis.size;
    return rest < axis.size ? rest : rest - axis.size;
}

/// The texel that stands at a column or row.
template <Wrap wrap>
Lanes wrapped_index(Lanes index, const Axis& axis) {
    if constexpr (wrap == Wrap::clamp_to_edge) {
        const Lanes least = index < 0 ? Lanes{} : index;
        return least < axis.size ? least : axis.size - 1;
    } else if constexpr (wrap == Wrap::repeat) {
        return remainder(index, axis);
    } else {
        const Lanes within = remainder(index, axis * 2);
        return within < axis.size ? within : 2 * axis.size - 1 - within;
    }
}

/// The two texels of an axis whose centres surround a place, and the second one's share.
struct Pair {
    Lanes first, second, share;
};

template <Wrap wrap>
Pair surrounding(Lanes place, const Axis& axis) {
    const Lanes between = on_line(place) - 0.5, low = whole_below(between),
                first = wrapped_index<wrap>(low, axis);
    if constexpr (wrap == Wrap::repeat) {
        const Lanes next = first + 1;
        return {first, next < axis.size ? next : Lanes{}, between - low};
    }
    return {first, wrapped_index<wrap>(low + 1, axis), between - low};
}

Lanes load(const double* from) {
    Lanes values;
    __builtin_memcpy(&values, from, sizeof values);
    return values;
}

void store(double* to, Lanes values) { __builtin_memcpy(to, &values, sizeof values); }

/// Whole numbers in [0, 2^52): with 2^52 added they stand in a double's lowest bits.
Bits integers(Lanes whole) { return bits(whole + 0x1p52) ^ bits(splat(0x1p52)); }

void store(std::int64_t* to, Bits values) { __builtin_memcpy(to, &values, sizeof values); }

static_assert(sizeof(Level) == 8 * sizeof(double));  // what `chosen` steps by

/// The levels of several reads.
struct Images {
    Bits first, row_of_tiles;
    Axis u, v;

    /// `chosen` takes a column of the levels' numbers and gives that of each read.
    template <class Gather>
    Images(const Level* levels, const Gather& gather)
        : first{integers(gather(&levels->first))},
          row_of_tiles{integers(gather(&levels->row_of_tiles))},
          u{gather(&levels->width), gather(&levels->per_width)},
          v{gather(&levels->height), gather(&levels->per_height)} {}

    /// Floats before a column's texels of a tile's first row: 4 a texel, 1024 a tile.
    Bits before_column(Lanes column) const {
        const Bits texel = integers(column);
        return ((texel & 15) << 2) + ((texel >> 4) << 10);
    }
    /// Floats of the chain before a row's first texel: 64 a row of a tile.
    Bits before_row(Lanes row) const {
        const Bits texel = integers(row);
        return first + ((texel & 15) << 6) + product(texel >> 4, row_of_tiles);
    }
};

/// The four taps of each read: upper left, upper right, lower left, lower right.
struct Taps {
    Bits offset[4];  ///< floats, from the chain's first texel
    Lanes weight[4];

    Taps(const Images& images, Lanes of_read, const Pair& u, const Pair& v) {
        const Bits rows[2] = {images.before_row(v.first), images.before_row(v.second)},
                   columns[2] = {images.before_column(u.first), images.before_column(u.second)};
        const Lanes across[2] = {of_read * (1 - u.share), of_read * u.share},
                    along[2] = {1 - v.share, v.share};
        for (int tap = 0; tap < 4; ++tap) {
            offset[tap] = rows[tap / 2] + columns[tap % 2];
            weight[tap] = across[tap % 2] * along[tap / 2];
        }
    }
};

/// Calls found.operator()<u, v>() for the chain's wrapping.
template <Wrap u, class Found>
void by_wrap(const Chain& chain, Found&& found) {
    if (chain.v == Wrap::repeat) return found.template operator()<u, Wrap::repeat>();
    if (chain.v == Wrap::clamp_to_edge) return found.template operator()<u, Wrap::clamp_to_edge>();
    found.template operator()<u, Wrap::mirrored_repeat>();
}
template <class Found>
void by_wrap(const Chain& chain, Found&& found) {
    if (chain.u == Wrap::repeat) return by_wrap<Wrap::repeat>(chain, found);
    if (chain.u == Wrap::clamp_to_edge) return by_wrap<Wrap::clamp_to_edge>(chain, found);
    by_wrap<Wrap::mirrored_repeat>(chain, found);
}
