/// How much a run is about: views, and scenes of which nobody knows how many views they have.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "reports/results.h"

namespace zproof {

struct Extent {
    std::uint64_t views = 0;
    std::uint64_t whole_scenes = 0;  ///< not read, not begun, or without triangles
};

/// The extent of the results that are wanted.
Extent extent_of(const Results& results, const std::function<bool(const ViewResult&)>& wanted);
Extent extent_of(const Results& results);  ///< of all

/// "12 views", "12 views and 20 whole scenes", "1 whole scene".
std::string in_words(const Extent& extent);

}  // namespace zproof
