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
    std::uint64_t views = 0, defects = 0;
    std::uint64_t pixels = 0;     ///< that it was asked about
    std::uint64_t of_pixels = 0;  ///< that those views have; more where it was asked about samples
    std::uint64_t seed = 0;       ///< by which samples were drawn
    double depth_error_over_bound = 0, edge_error_over_bound = 0;  ///< the largest
    std::uint64_t unlike_candidate = 0;  ///< pixels at which it names another triangle than the candidate
    std::uint64_t not_compared = 0;      ///< views in which it was not compared
    std::string absent;                  ///< why, the first time
};

/// Candidate, reference, then the oracles in the order of the first view that has them.
std::vector<RendererRecord> renderer_records(const Results& results);

/// Pixels of all judged views that everybody who was compared was asked about, and those at which all name
/// the same triangle.
struct Unanimity {
    std::uint64_t pixels = 0, unanimous = 0;
};
Unanimity unanimity(const Results& results);

}  // namespace zproof
