/// What is wrong with a whole run: the causes of its failed views, the commonest first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/results.h"

namespace zproof {

struct RunCause {
    std::string name;     ///< as the views' diagnoses name it: "the image is flipped in y"
    std::string look_at;  ///< where in a renderer's code to look first, a sentence; may be empty
    std::string fitted;   ///< the number that all of its views fit; empty where they differ
    std::uint64_t views = 0;
};

/// By the views of which each is the likely cause; of as many, the one that was named first.
std::vector<RunCause> run_causes(const Results& results);

/// The views that are defective: waived ones are not.
std::uint64_t failed_views(const Results& results);

/// "Likely cause of 5 of 7 failed views: A. Look at ...", or "of all 7"; says so where no view has one. Empty
/// where no view fails.
std::string in_words(const std::vector<RunCause>& causes, std::uint64_t failed_views);

}  // namespace zproof
