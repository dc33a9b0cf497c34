/// Rules that integrate polynomials over a triangle or an interval exactly.
#pragma once

#include <span>

namespace zproof::oracle::area {

/// A node's barycentrics and its share of the area.
struct Node {
    double a, b, c, weight;
};

/// Degree 5, seven nodes (Radon 1948; Stroud 1971, T2: 5-1). All weights are positive.
std::span<const Node> rule_of_degree_5();

/// Degree 8, sixteen nodes (Dunavant 1985). All weights are positive.
std::span<const Node> rule_of_degree_8();

/// Degree 10, twenty-five nodes (Dunavant 1985). All weights are positive.
std::span<const Node> rule_of_degree_10();

/// A node of an interval from 0 to 1, and its share.
struct GaussNode {
    double place, weight;
};

/// Gauss's rules of two and of three points: degrees 3 and 5.
std::span<const GaussNode> gauss_of_two();
std::span<const GaussNode> gauss_of_three();

}  // namespace zproof::oracle::area
