/// Verdicts held against each other in all but their findings.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "compare/verdict.h"

namespace zproof {

inline void expect_same_counts(const Verdict& one, const Verdict& other) {
    EXPECT_EQ(one.counts, other.counts);
    EXPECT_EQ(one.candidate_depth, other.candidate_depth);
    EXPECT_EQ(one.reference_depth, other.reference_depth);
    EXPECT_EQ(one.candidate_edges, other.candidate_edges);
    EXPECT_EQ(one.reference_edges, other.reference_edges);
    EXPECT_EQ(one.reference_defects, other.reference_defects);
    EXPECT_EQ(one.adjudicated, other.adjudicated);
    EXPECT_EQ(one.exact, other.exact);
    EXPECT_TRUE(std::ranges::equal(one.classes.plane().pixels(), other.classes.plane().pixels()));
}

}  // namespace zproof
