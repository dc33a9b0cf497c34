#include "texture/code_sums.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cassert>
#include <cstring>
#include <vector>

namespace zproof::texture {

namespace {

using Sums = std::span<std::uint32_t>;
using ConstSums = std::span<const std::uint32_t>;

/// Four sums side by side, in the compiler's own vectors: any processor has them.
typedef std::uint32_t Four __attribute__((vector_size(16)));

Four load(const std::uint32_t* at) {
    Four four;
    std::memcpy(&four, at, sizeof four);
    return four;
}

void store(std::uint32_t* at, Four four) { std::memcpy(at, &four, sizeof four); }

/// One texel after the other, from `first` on; what stands before it is already summed.
void scan_rest(ConstSums columns, Sums out, std::size_t first, std::size_t channels) {
    for (std::size_t i = first; i < out.size(); ++i)
        out[i] = columns[i] + (i < channels ? 0 : out[i - channels]);
}

/// Four texels of one channel at a time: each adds its neighbour, then the pair before, then all before.
void scan_one_channel(ConstSums columns, Sums out) {
    const Four none{};
    Four before{};
    std::size_t i = 0;
    for (; i + 4 <= out.size(); i += 4) {
        Four four = load(&columns[i]);
        four += __builtin_shufflevector(none, four, 0, 4, 5, 6);
        four += __builtin_shufflevector(none, four, 0, 1, 4, 5);
        four += before;
        before = __builtin_shufflevector(four, four, 3, 3, 3, 3);
        store(&out[i], four);
    }
    scan_rest(columns, out, i, 1);
}

/// A texel of three or four channels at a time. Of three, the fourth lane holds the next texel's first: its
/// store is overwritten by that texel's own.
void scan_texels(ConstSums columns, Sums out, std::size_t channels) {
    Four running{};
    std::size_t i = 0;
    for (; i + 4 <= out.size(); i += channels) {
        running += load(&columns[i]);
        store(&out[i], running);
    }
    scan_rest(columns, out, i, channels);
}

void scan(ConstSums columns, Sums out, int channels) {
    if (channels == 1) return scan_one_channel(columns, out);
    if (channels == 3 || channels == 4) return scan_texels(columns, out, std::size_t(channels));
    scan_rest(columns, out, 0, std::size_t(channels));
}

/// Adds a row's codes to the sums of its columns. Those of 8 bits gain from wider vectors.
[[gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] void add_row(std::span<const std::uint8_t> codes,
                                                                         Sums columns) {
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i] += codes[i];
}
void add_row(std::span<const std::uint16_t> codes, Sums columns) {
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i] += codes[i];
}

template <class Code>
class Build {
  public:
    Build(const Codes<Code>& codes, Sums sums)
        : codes_(codes), sums_(sums), stride_(std::size_t(codes.width) * std::size_t(codes.channels)) {}

    /// Bands of rows in parallel. What lies above a band is known only by its columns' sums: those are taken
    /// first, at the cost of reading all codes but the last band's twice.
    void in_bands(int count) {
        std::vector<Columns> above{std::size_t(count), Columns(stride_)};
        tbb::parallel_for(1, count, [&](int band) { add_rows(band - 1, count, above[std::size_t(band)]); });
        for (std::size_t band = 1; band < above.size(); ++band)
            for (std::size_t i = 0; i < stride_; ++i) above[band][i] += above[band - 1][i];
        tbb::parallel_for(0, count, [&](int band) { sum_band(band, count, above[std::size_t(band)]); });
    }

  private:
    using Columns = std::vector<std::uint32_t>;

    int first_row(int band, int count) const { return int(std::int64_t{codes_.height} * band / count); }
    std::span<const Code> row_at(int row) const {
        return std::span(codes_.values).subspan(std::size_t(row) * stride_, stride_);
    }
    void add_rows(int band, int count, Columns& columns) const {
        for (int row = first_row(band, count); row < first_row(band + 1, count); ++row)
            add_row(row_at(row), columns);
    }
    void sum_band(int band, int count, Columns& columns) const {
        for (int row = first_row(band, count); row < first_row(band + 1, count); ++row) {
            add_row(row_at(row), columns);
            scan(columns, sums_.subspan(std::size_t(row) * stride_, stride_), codes_.channels);
        }
    }

    const Codes<Code>& codes_;
    Sums sums_;
    std::size_t stride_;
};

template <class Code>
void build(const Codes<Code>& codes, Sums sums) {
    assert(sums.size() == codes.values.size());
    Build<Code>(codes, sums).in_bands(tbb::this_task_arena::max_concurrency());
}

}  // namespace

void sum_codes(const Codes<std::uint8_t>& codes, Sums sums) { build(codes, sums); }
void sum_codes(const Codes<std::uint16_t>& codes, Sums sums) { build(codes, sums); }

std::uint32_t CodeSums::box(const Run& columns, const Run& rows, int channel) const {
    const auto up_to = [&](int column, int row) -> std::uint32_t {
        if (column == 0 || row == 0) return 0;
        const std::size_t texel = std::size_t(row - 1) * std::size_t(width) + std::size_t(column - 1);
        return sums[texel * std::size_t(channels) + std::size_t(channel)];
    };
    return up_to(columns.last, rows.last) - up_to(columns.first, rows.last) -
           up_to(columns.last, rows.first) + up_to(columns.first, rows.first);
}

}  // namespace zproof::texture
