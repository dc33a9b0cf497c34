/// What a whole run says of one renderer: the rows of the matrix that reports show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/results.h"

namespace zproof {

struct RendererRecord {
    std::string name;
    std::string role;  ///< "candidate", "reference" or "oracle"
    std::uint64_t views = 0, pixels = 0, defects = 0;
    double depth_error_over_bound = 0, edge_error_over_bound = 0;  ///< the largest
    std::uint64_t same_as_candidate = 0;  ///< pixels at which it names the candidate's triangle
    std::uint64_t not_compared = 0;       ///< views in which it was not compared
    std::string absent;                   ///< why, the first time
};

/// Candidate, reference, then the oracles in the order of the first view that has them.
std::vector<RendererRecord> renderer_records(const Results& results);

/// Pixels of all judged views, and those at which everybody who was compared names the same triangle.
struct Unanimity {
    std::uint64_t pixels = 0, unanimous = 0;
};
Unanimity unanimity(const Results& results);

}  // namespace zproof
