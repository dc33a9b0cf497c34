/// Rules that integrate polynomials over a triangle exactly.
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

}  // namespace zproof::oracle::area
