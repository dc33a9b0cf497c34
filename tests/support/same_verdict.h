/// Verdicts held against each other.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "compare/verdict.h"

namespace zproof {

/// In all but their findings and the histograms of depth.
inline void expect_same_counts(const Verdict& one, const Verdict& other) {
    EXPECT_EQ(one.counts, other.counts);
    EXPECT_EQ(one.candidate_depth.max_error_over_bound, other.candidate_depth.max_error_over_bound);
    EXPECT_EQ(one.reference_depth.max_error_over_bound, other.reference_depth.max_error_over_bound);
    EXPECT_EQ(one.candidate_edges, other.candidate_edges);
    EXPECT_EQ(one.reference_edges, other.reference_edges);
    EXPECT_EQ(one.reference_defects, other.reference_defects);
    EXPECT_EQ(one.adjudicated, other.adjudicated);
    EXPECT_EQ(one.exact, other.exact);
    EXPECT_TRUE(std::ranges::equal(one.classes.plane().pixels(), other.classes.plane().pixels()));
}

inline void expect_same_histograms(const Verdict& one, const Verdict& other) {
    EXPECT_EQ(one.candidate_depth.histogram, other.candidate_depth.histogram);
    EXPECT_EQ(one.reference_depth.histogram, other.reference_depth.histogram);
}

}  // namespace zproof
