/// Rows counted together must be what their pixels are, counted one by one.
#include "compare/agree/row_counts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "random_surroundings.h"

namespace zproof {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// At random, at a bin's border or right beside it, far beyond the bound, or undecided.
double some_error(Rng& rng) {
    const double border = rng.below(22) / 20.0;
    switch (rng.below(8)) {
        case 0:
            return -1;
        case 1:
            return rng.below(2) ? 1e300 : inf;
        case 2:
            return border;
        case 3:
            return std::max(0.0, std::nextafter(border, rng.below(2) ? -inf : inf));
        case 4:
            return rng.below(2) ? std::numeric_limits<double>::denorm_min() : 0;
        default:
            return rng.between(0, 1.1);
    }
}

/// Ids that are mostly the same, of triangles or of nothing.
ComparedRow some_row(Rng& rng, bool is_decided) {
    ComparedRow row;
    for (std::size_t i = 0; i < row_pixels; ++i) {
        row.candidate[i] = rng.below(4) == 0 ? PrimitiveId::none : PrimitiveId(rng.below(3));
        row.reference[i] = is_decided || rng.below(6) ? row.candidate[i] : PrimitiveId(rng.below(3));
        for (double* error : {&row.candidate_error[i], &row.reference_error[i]}) {
            *error = some_error(rng);
            if (is_decided && *error < 0) *error = 0;
        }
    }
    return row;
}

TEST(RowCounts, AreThoseOfPixelsOneByOne) {
    Rng rng(1);
    RowCounts counts;
    BoundRecord candidate, reference;
    int with_undecided = 0;
    for (int round = 0; round < 2000; ++round) {
        const ComparedRow row = some_row(rng, round % 3 == 0);
        bool is_any_undecided = false;
        for (std::size_t i = 0; i < row_pixels; ++i) {
            const bool is_decided = row.candidate[i] == row.reference[i] && row.candidate_error[i] >= 0 &&
                                    row.reference_error[i] >= 0;
            is_any_undecided |= !is_decided;
            if (!is_decided || row.candidate[i] == PrimitiveId::none) continue;
            count(candidate, row.candidate_error[i]);
            count(reference, row.reference_error[i]);
        }
        ASSERT_EQ(counts.add(row), is_any_undecided) << round;
        with_undecided += is_any_undecided;
        if (round % 100 != 0) continue;
        ASSERT_EQ(counts.candidate(), candidate) << round;
        ASSERT_EQ(counts.reference(), reference) << round;
    }
    EXPECT_EQ(counts.candidate(), candidate);
    EXPECT_EQ(counts.reference(), reference);
    EXPECT_GT(with_undecided, 1000);
    EXPECT_LT(with_undecided, 1500);
    for (const std::uint64_t bin : candidate.histogram) EXPECT_GT(bin, 100u);
}

/// One pixel's place must not matter.
TEST(RowCounts, FindTheOnlyUndecidedPixelAndTheLargestErrorWhereverTheyAre) {
    for (std::size_t i = 0; i < row_pixels; ++i) {
        SCOPED_TRACE(i);
        ComparedRow row{};
        RowCounts counts;
        EXPECT_FALSE(counts.add(row));
        row.candidate_error[i] = 0.5;
        row.reference_error[i] = 0.75;
        EXPECT_FALSE(counts.add(row));
        EXPECT_EQ(counts.candidate().max_error_over_bound, 0.5);
        EXPECT_EQ(counts.reference().max_error_over_bound, 0.75);
        row.candidate_error[i] = -1;
        EXPECT_TRUE(counts.add(row));
        row.candidate_error[i] = 0;
        row.candidate[i] = PrimitiveId(1);
        EXPECT_TRUE(counts.add(row));
        EXPECT_EQ(counts.candidate().histogram[0], 4 * row_pixels - 3) << "but 0.5, and what is undecided";
    }
}

TEST(BoundRecord, CountsAnErrorIntoItsBin) {
    const auto bin_of = [](double error) {
        BoundRecord record;
        count(record, error);
        EXPECT_EQ(record.max_error_over_bound, error);
        return std::ranges::find(record.histogram, 1u) - record.histogram.begin();
    };
    EXPECT_EQ(bin_of(0), 0);
    EXPECT_EQ(bin_of(0.05), 1);
    EXPECT_EQ(bin_of(std::nextafter(0.05, 0)), 0);
    EXPECT_EQ(bin_of(0.975), 19);
    EXPECT_EQ(bin_of(1), 20);
    EXPECT_EQ(bin_of(1e300), 20);
}

TEST(BoundRecord, OfPartsIsTheirSum) {
    BoundRecord one, other, all;
    for (const double error : {0.1, 0.5, 3.0}) count(one, error), count(all, error);
    for (const double error : {0.5, 0.7}) count(other, error), count(all, error);
    add(one, other);
    EXPECT_EQ(one, all);
}

}  // namespace
}  // namespace zproof
