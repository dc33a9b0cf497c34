#include "filters/stored/code_sums.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cassert>
#include <vector>

#include "filters/sums/kernel.h"
#include "math/processor.h"

namespace zproof::texture {

namespace {

using Sums = std::span<std::uint32_t>;

/// Tables of that size do not stay in a cache: it is not worth fetching what is only overwritten.
constexpr std::size_t streamed_from_bytes = std::size_t{32} << 20;

/// The number of rows that are added to their columns at once.
constexpr int added_together = 8;

void add(const sums::Rows<std::uint8_t>& rows) { widest_of(sums::kernels).add_bytes(rows); }
void add(const sums::Rows<std::uint16_t>& rows) { widest_of(sums::kernels).add_words(rows); }
void sum(const sums::Rows<std::uint8_t>& rows, const sums::Table& table) {
    widest_of(sums::kernels).sum_bytes(rows, table);
}
void sum(const sums::Rows<std::uint16_t>& rows, const sums::Table& table) {
    widest_of(sums::kernels).sum_words(rows, table);
}

template <class Code>
class Build {
  public:
    Build(const Codes<Code>& codes, Sums sums)
        : codes_(codes), sums_(sums), stride_(std::size_t(codes.width) * std::size_t(codes.channels)) {}

    /// Bands of rows in parallel. What lies above a band is known only by its columns' sums: those are taken
    /// first, by stripes of columns, at the cost of reading all codes but the last band's twice.
    void in_bands(int count) {
        std::vector<Columns> above{std::size_t(count), Columns(stride_)};
        tbb::parallel_for(0, count, [&](int stripe) { add_stripe(stripe, above); });
        tbb::parallel_for(0, count, [&](int band) { sum_band(band, count, above[std::size_t(band)]); });
    }

  private:
    using Columns = std::vector<std::uint32_t>;

    int first_row(int band, int count) const { return int(std::int64_t{codes_.height} * band / count); }
    /// Rows [row, end) of the columns from `first` on.
    sums::Rows<Code> rows(int row, int end, std::size_t first, std::span<std::uint32_t> columns) const {
        return {.codes = &codes_.values[std::size_t(row) * stride_ + first],
                .count = std::size_t(end - row),
                .width = columns.size(),
                .stride = stride_,
                .channels = std::size_t(codes_.channels),
                .columns = columns.data()};
    }
    void add_stripe(int stripe, std::vector<Columns>& above) const {
        const std::size_t count = above.size(), first = stride_ * std::size_t(stripe) / count,
                          width = stride_ * std::size_t(stripe + 1) / count - first;
        for (std::size_t band = 1; band < count; ++band) {
            const std::span columns = std::span(above[band]).subspan(first, width);
            std::ranges::copy(std::span(above[band - 1]).subspan(first, width), columns.begin());
            const int end = first_row(int(band), int(count));
            for (int row = first_row(int(band) - 1, int(count)); row < end; row += added_together)
                add(rows(row, std::min(row + added_together, end), first, columns));
        }
    }
    void sum_band(int band, int count, Columns& columns) const {
        const int first = first_row(band, count), end = first_row(band + 1, count);
        if (first == end) return;
        sum(rows(first, end, 0, columns),
            {&sums_[std::size_t(first) * stride_], sums_.size_bytes() >= streamed_from_bytes});
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
