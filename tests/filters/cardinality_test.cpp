// Both definitions of the tables of texels, entry by entry.
#include <gtest/gtest.h>

#include "filters/reference/cardinality_taps.h"
#include "filters/stored/cardinality_table.h"

namespace zproof {
namespace {

class BothTables : public testing::TestWithParam<int> {};

/// The same texels in the same order; the weights within half of what the reference admits (weight_error),
/// and their absolute sums within what it holds for the most.
TEST_P(BothTables, AgreeInEveryEntry) {
    const texture::CardinalityTable table{GetParam()};
    auto& reference = oracle::filter_reference::chosen_texels(GetParam());
    double widest = 0;
    for (int lod = 0; lod < table.lods; ++lod)
        for (int v = 0; v < table.places; ++v)
            for (int u = 0; u < table.places; ++u) {
                const auto taps = table.at(u, v, lod);
                const auto& expected = reference.at(u, v, lod);
                ASSERT_EQ(taps.size(), expected.size()) << u << ", " << v << ", lod " << lod;
                double sum = 0;
                for (const auto& tap : taps) sum += std::abs(tap.weight);
                ASSERT_LE(sum, 5) << u << ", " << v << ", lod " << lod;
                for (std::size_t i = 0; i < taps.size(); ++i) {
                    ASSERT_TRUE(taps[i].level == expected[i].level && taps[i].column == expected[i].column &&
                                taps[i].row == expected[i].row)
                        << u << ", " << v << ", lod " << lod << ": texel " << i;
                    widest = std::max(widest, std::abs(taps[i].weight - expected[i].weight));
                }
            }
    EXPECT_LE(widest, 0x1p-31);
    RecordProperty("widest", std::to_string(widest));
}

INSTANTIATE_TEST_SUITE_P(Cardinality, BothTables, testing::Values(4, 8));

}  // namespace
}  // namespace zproof
