#include "filters/stored/code_sums.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <random>
#include <vector>

#include "filters/sums/kernel.h"
#include "math/processor.h"

namespace zproof::texture {
namespace {

template <class Code>
std::vector<Code> random_codes(std::size_t count) {
    std::mt19937 rng(17);
    std::vector<Code> codes(count);
    for (Code& code : codes) code = Code(rng());
    return codes;
}

template <class Code>
std::vector<std::uint32_t> summed(const Codes<Code>& codes, int threads) {
    std::vector<std::uint32_t> sums(codes.values.size());
    tbb::task_arena(threads).execute([&] { sum_codes(codes, sums); });
    return sums;
}

/// Every entry from the entry to its left and the column above, in 64 bits: no vectors, no bands.
template <class Code>
void expect_definition(const Codes<Code>& codes, const std::vector<std::uint32_t>& sums) {
    const auto stride = std::size_t(codes.width) * std::size_t(codes.channels),
               lag = std::size_t(codes.channels);
    std::vector<std::uint64_t> columns(stride), row(stride);
    for (std::size_t y = 0; y < std::size_t(codes.height); ++y)
        for (std::size_t i = 0; i < stride; ++i) {
            columns[i] += codes.values[y * stride + i];
            row[i] = columns[i] + (i < lag ? 0 : row[i - lag]);
            ASSERT_EQ(sums[y * stride + i], std::uint32_t(row[i])) << "row " << y << ", value " << i;
        }
}

template <class Code>
class CodeSumsOf : public testing::Test {};
using CodeTypes = testing::Types<std::uint8_t, std::uint16_t>;
TYPED_TEST_SUITE(CodeSumsOf, CodeTypes);

TYPED_TEST(CodeSumsOf, AnySizeAndChannelsAreThatOfTheDefinition) {
    for (const int channels : {1, 2, 3, 4, 5})
        for (int width = 1; width < 20; ++width)
            for (const int height : {1, 2, 7}) {
                const auto values =
                    random_codes<TypeParam>(std::size_t(width) * std::size_t(height) * std::size_t(channels));
                const Codes<TypeParam> codes{width, height, channels, values};
                expect_definition(codes, summed(codes, 3));
            }
}

TYPED_TEST(CodeSumsOf, AreTheSameForAnyNumberOfThreads) {
    const auto values = random_codes<TypeParam>(301 * 203 * 3);
    const Codes<TypeParam> codes{301, 203, 3, values};
    const auto one = summed(codes, 1);
    expect_definition(codes, one);
    for (const int threads : {2, 3, 8, 64}) EXPECT_EQ(summed(codes, threads), one) << threads;
}

void sum(const sums::Kernel& kernel, const sums::Rows<std::uint8_t>& rows, const sums::Table& table) {
    kernel.sum_bytes(rows, table);
}
void sum(const sums::Kernel& kernel, const sums::Rows<std::uint16_t>& rows, const sums::Table& table) {
    kernel.sum_words(rows, table);
}

/// Where a table begins in memory, whether it is streamed, and what is left of four rows: no matter.
TYPED_TEST(CodeSumsOf, EveryKernelsAreThatOfTheDefinition) {
    constexpr std::uint32_t untouched = 0xABCDEF01;
    constexpr std::size_t most = 17;  // values before the table: more than any vector's
    for (const sums::Kernel& kernel : available_of(sums::kernels))
        for (const int channels : {1, 2, 3, 4, 5})
            for (const int width : {1, 5, 16, 48, 80, 81})
                for (const int height : {1, 4, 7})
                    for (std::size_t before = 0; before < 2 * most; ++before) {
                        const bool is_streamed = before >= most;
                        const auto stride = std::size_t(width) * std::size_t(channels),
                                   size = stride * std::size_t(height);
                        const auto values = random_codes<TypeParam>(size);
                        std::vector<std::uint32_t> memory(size + 2 * most, untouched), columns(stride);
                        std::uint32_t* const table = &memory[before % most];
                        sum(kernel,
                            {values.data(), std::size_t(height), stride, stride, std::size_t(channels),
                             columns.data()},
                            {table, is_streamed});
                        SCOPED_TRACE(testing::Message()
                                     << kernel.name << ", " << channels << " channels, " << width << " x "
                                     << height << ", from " << before % most
                                     << (is_streamed ? ", streamed" : ""));
                        expect_definition(Codes<TypeParam>{width, height, channels, values},
                                          std::vector(table, table + size));
                        ASSERT_EQ(std::ranges::count(memory, untouched), std::ptrdiff_t(2 * most));
                    }
}

/// Direct sums over boxes, in 64 bits.
template <class Code>
void expect_boxes(const Codes<Code>& codes, const std::vector<std::uint32_t>& sums, int trials) {
    std::mt19937 rng(23);
    const CodeSums table{codes.width, codes.channels, sums};
    int exact = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const int left = int(rng() % std::uint32_t(codes.width)),
                  top = int(rng() % std::uint32_t(codes.height)),
                  right = left + 1 + int(rng() % std::uint32_t(codes.width - left)),
                  bottom = top + 1 + int(rng() % std::uint32_t(codes.height - top)),
                  channel = int(rng() % std::uint32_t(codes.channels));
        std::uint64_t sum = 0;
        for (int row = top; row < bottom; ++row)
            for (int column = left; column < right; ++column)
                sum += codes.values[(std::size_t(row) * std::size_t(codes.width) + std::size_t(column)) *
                                        std::size_t(codes.channels) +
                                    std::size_t(channel)];
        const std::uint32_t found = table.box({left, right, 1}, {top, bottom, 1}, channel);
        ASSERT_EQ(found, std::uint32_t(sum));
        exact += found == sum;
    }
    EXPECT_GT(exact, trials / 4);  // boxes of less than 2^32
}

TEST(CodeSums, OfBoxesAreExactBeyondThirtyTwoBits) {
    const auto values =
        random_codes<std::uint16_t>(std::size_t{1024} * 700 * 3);  // all sums together: 10 times 2^32
    const Codes<std::uint16_t> codes{1024, 700, 3, values};
    expect_boxes(codes, summed(codes, 2), 60);
}

TEST(CodeSums, Of8192SquaredEqualBruteForceBitByBit) {
    const auto values = random_codes<std::uint8_t>(std::size_t{8192} * 8192);
    const Codes<std::uint8_t> codes{8192, 8192, 1, values};
    const auto sums = summed(codes, 2);
    expect_definition(codes, sums);
    expect_boxes(codes, sums, 20);
}

}  // namespace
}  // namespace zproof::texture
