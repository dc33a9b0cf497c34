// Rows of a summed-area table, for the file that includes it: it has said how wide its vectors are (Lanes),
// how codes become one (widened) and how one is written past the caches (stream, fence).
//
// Four rows are summed side by side. None waits for another's running sums, and the sums of their columns are
// loaded and stored once for all four.

constexpr std::size_t lanes = sizeof(Lanes) / sizeof(std::uint32_t), together = 4;

Lanes load(const std::uint32_t* at) {
    Lanes values;
    __builtin_memcpy(&values, at, sizeof values);
    return values;
}
void store(std::uint32_t* at, Lanes values) { __builtin_memcpy(at, &values, sizeof values); }

/// Each lane and those before it of the same channel, in steps of twice as many.
template <std::size_t step, std::size_t... lane>
Lanes running(Lanes values, std::index_sequence<lane...> each) {
    if constexpr (step < lanes) {
        const Lanes moved =
            __builtin_shufflevector(Lanes{}, values, (lane < step ? int(lane) : int(lane - step + lanes))...);
        return running<2 * step>(values + moved, each);
    } else {
        return values;
    }
}

/// The last sum of its channel, for each of the lanes that come next.
template <std::size_t channels, std::size_t... lane>
Lanes latest(Lanes sums, std::index_sequence<lane...>) {
    return __builtin_shufflevector(sums, sums, int(lanes - channels + lane % channels)...);
}

/// Value by value, [first, last) of each row.
template <class Code>
void sum_one_by_one(const Rows<Code>& rows, std::uint32_t* sums, std::size_t first, std::size_t last) {
    for (std::size_t row = 0; row < rows.count; ++row)
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t at = row * rows.stride + i;
            rows.columns[i] += rows.codes[at];
            sums[at] = rows.columns[i] + (i < rows.channels ? 0 : sums[at - rows.channels]);
        }
}

/// What a row's running sums are where its vectors begin.
template <std::size_t channels>
Lanes sums_before(const std::uint32_t* row, std::size_t first) {
    alignas(Lanes) std::uint32_t before[lanes] = {};
    for (std::size_t lane = 0; lane < lanes; ++lane)
        if (const std::size_t channel = lane % channels; first + channel >= channels)
            before[lane] = row[first + channel - channels];
    return load(before);
}

/// `count` rows: rows.count says it again. Vectors begin at value `first`.
template <std::size_t channels, std::size_t count, bool is_streamed, class Code>
void sum_together(const Rows<Code>& rows, std::uint32_t* sums, std::size_t first) {
    constexpr std::make_index_sequence<lanes> each;
    // These are local copies: for all the compiler knows, sums are written over `rows`.
    const std::size_t width = rows.width, stride = rows.stride;
    const Code* const codes = rows.codes;
    std::uint32_t* const of_columns = rows.columns;
    sum_one_by_one(rows, sums, 0, first);
    Lanes before[count];
    for (std::size_t row = 0; row < count; ++row)
        before[row] = sums_before<channels>(sums + row * stride, first);
    std::size_t i = first;
    for (; i + lanes <= width; i += lanes) {
        Lanes columns = load(of_columns + i);
#pragma GCC unroll 4
        for (std::size_t row = 0; row < count; ++row) {
            const std::size_t at = row * stride + i;
            columns += widened(codes + at);
            const Lanes here = running<channels>(columns, each) + before[row];
            before[row] = latest<channels>(here, each);
            if constexpr (is_streamed)
                stream(sums + at, here);
            else
                store(sums + at, here);
        }
        store(of_columns + i, columns);
    }
    sum_one_by_one(rows, sums, i, width);
}

/// Four rows at a time, and one at a time what is left of them.
template <std::size_t channels, bool is_streamed, class Code>
void sum_all(Rows<Code> rows, std::uint32_t* sums, std::size_t first) {
    const auto take = [&](std::size_t count) {
        rows.codes += count * rows.stride;
        sums += count * rows.stride;
    };
    std::size_t left = rows.count;
    for (rows.count = together; left >= together; left -= together, take(together))
        sum_together<channels, together, is_streamed>(rows, sums, first);
    for (rows.count = 1; left > 0; --left, take(1)) sum_together<channels, 1, is_streamed>(rows, sums, first);
}

/// Only whole vectors at their own places in memory are streamed: every row has to begin alike.
template <std::size_t channels, class Code>
void sum_channels(const Rows<Code>& rows, const Table& table) {
    constexpr std::size_t value = sizeof(std::uint32_t);
    const std::size_t into_vector = reinterpret_cast<std::uintptr_t>(table.sums) / value % lanes;
    if (!table.is_streamed || rows.stride % lanes != 0) return sum_all<channels, false>(rows, table.sums, 0);
    sum_all<channels, true>(rows, table.sums, (lanes - into_vector) % lanes);
    fence();
}

template <class Code>
void sum(const Rows<Code>& rows, const Table& table) noexcept {
    switch (rows.channels) {
        case 1:
            return sum_channels<1>(rows, table);
        case 2:
            return sum_channels<2>(rows, table);
        case 3:
            return sum_channels<3>(rows, table);
        case 4:
            return sum_channels<4>(rows, table);
        default:
            return sum_one_by_one(rows, table.sums, 0, rows.width);
    }
}

template <class Code>
void add(const Rows<Code>& rows) noexcept {
    std::size_t i = 0;
    for (; i + lanes <= rows.width; i += lanes) {
        Lanes columns = load(rows.columns + i);
        for (std::size_t row = 0; row < rows.count; ++row)
            columns += widened(rows.codes + row * rows.stride + i);
        store(rows.columns + i, columns);
    }
    for (; i < rows.width; ++i)
        for (std::size_t row = 0; row < rows.count; ++row)
            rows.columns[i] += rows.codes[row * rows.stride + i];
}
