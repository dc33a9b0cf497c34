/// Verdicts held against each other.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <iterator>

#include "compare/verdict.h"

namespace zproof {

/// In all but their findings and maps of errors.
inline void expect_same_counts(const Verdict& one, const Verdict& other) {
    EXPECT_EQ(one.counts, other.counts);
    EXPECT_EQ(one.candidate_depth, other.candidate_depth);
    EXPECT_EQ(one.reference_depth, other.reference_depth);
    EXPECT_EQ(one.candidate_edges, other.candidate_edges);
    EXPECT_EQ(one.reference_edges, other.reference_edges);
    EXPECT_EQ(one.reference_defects, other.reference_defects);
    EXPECT_EQ(one.adjudicated, other.adjudicated);
    EXPECT_EQ(one.exact, other.exact);
    EXPECT_TRUE(std::ranges::equal(one.classes.pixels(), other.classes.pixels()));
}

inline bool same_finding(const Finding& a, const Finding& b) {
    const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
    const auto same_answer = [](const Answer& p, const Answer& q) {
        return p.primitive == q.primitive &&
               std::bit_cast<std::uint32_t>(p.camera_depth) == std::bit_cast<std::uint32_t>(q.camera_depth);
    };
    const auto same_bound = [&](const DepthBound& p, const DepthBound& q) {
        return bits(p.low) == bits(q.low) && bits(p.truth) == bits(q.truth) && bits(p.high) == bits(q.high);
    };
    return a.x == b.x && a.y == b.y && a.verdict == b.verdict && a.eps_px == b.eps_px &&
           same_answer(a.candidate, b.candidate) && same_answer(a.reference, b.reference) &&
           same_bound(a.candidate_depth, b.candidate_depth) &&
           bits(a.error_over_bound) == bits(b.error_over_bound);
}

/// Findings that fail the gate.
inline std::vector<Finding> defects_among(const std::vector<Finding>& findings) {
    std::vector<Finding> failing;
    std::ranges::copy_if(findings, std::back_inserter(failing),
                         [](const Finding& f) { return !passes(f.verdict); });
    return failing;
}

}  // namespace zproof
