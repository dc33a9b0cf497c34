// Both definitions of the table of reads, entry by entry.
#include "filters/reference/two_reads.h"

#include <gtest/gtest.h>

#include "filters/stored/two_reads_table.h"

namespace zproof {
namespace {

TEST(BothTablesOfReads, AgreeInEveryEntry) {
    const texture::TwoReadsTable table;
    auto& reference = oracle::filter_reference::two_reads_search();
    for (int side = table.least_side; side <= table.most_side; ++side)
        for (int row = 0; row < table.cells; ++row)
            for (int column = 0; column < table.cells; ++column) {
                const texture::TwoReads reads = table.at(side, {column, row});
                const auto& expected = reference.at(side, column, row);
                const texture::TwoReads found{{expected.finer[0], expected.finer[1]},
                                              {expected.coarser[0], expected.coarser[1]},
                                              expected.finer_64ths};
                ASSERT_EQ(reads, found) << "side " << side << ", cell " << column << ", " << row;
            }
}

}  // namespace
}  // namespace zproof
