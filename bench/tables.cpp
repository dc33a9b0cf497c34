// Summed-area tables of 4096 x 4096 texels, 32-bit sums, beside a memset of the same memory: it is there
// already, and both write all of it.
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstring>
#include <random>

#include "bench/lazy.h"
#include "bench/suites.h"
#include "filters/stored/code_sums.h"

namespace zproof::bench {
namespace {

constexpr int table_side = 4096;

template <class Code>
struct Table {
    explicit Table(int channels)
        : codes(std::size_t{table_side} * table_side * std::size_t(channels)), sums(codes.size()) {
        std::mt19937 rng(1);
        for (Code& code : codes) code = Code(rng());
    }
    std::vector<Code> codes;
    std::vector<std::uint32_t> sums;
};

/// Splits the values into as many pieces as threads; the library's memset clears each.
void clear(std::span<std::uint32_t> values) {
    const int pieces = tbb::this_task_arena::max_concurrency();
    tbb::parallel_for(0, pieces, [&](int piece) {
        const std::size_t from = values.size() * std::size_t(piece) / std::size_t(pieces),
                          to = values.size() * std::size_t(piece + 1) / std::size_t(pieces);
        std::memset(values.data() + from, 1, (to - from) * sizeof(std::uint32_t));
    });
    benchmark::DoNotOptimize(values.data());
    benchmark::ClobberMemory();
}

template <class Code>
void add_table(const std::string& name, int channels) {
    const Lazy<Table<Code>> table{[=] { return Table<Code>{channels}; }};
    add("sat/" + name + "/zproof", [=] {
        texture::sum_codes(texture::Codes<Code>{table_side, table_side, channels, table->codes}, table->sums);
    });
    add("sat/" + name + "/memset", [=] { clear(table->sums); });
}

}  // namespace

void add_tables() {
    add_table<std::uint8_t>("grey 8 bits", 1);
    add_table<std::uint16_t>("grey 16 bits", 1);
    add_table<std::uint8_t>("RGB 8 bits", 3);
    add_table<std::uint8_t>("RGBA 8 bits", 4);
}

}  // namespace zproof::bench
