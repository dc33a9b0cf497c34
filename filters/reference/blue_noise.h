/// The filter reference's own void-and-cluster mask (filters/stored/void_and_cluster.h says which).
#pragma once

#include <vector>

namespace zproof::oracle::filter_reference {

inline constexpr int mask_side = 64;

/// The rank of every cell, row by row.
const std::vector<int>& mask_ranks();

}  // namespace zproof::oracle::filter_reference
