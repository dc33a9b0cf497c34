/// A suite scene's views, rendered, traced and judged as `zproof run` does it.
#pragma once

#include <string>
#include <vector>

#include "compare/judge.h"
#include "rasterizer/rules.h"

namespace zproof {

struct SuiteVerdict {
    std::string name;  ///< scene/view
    Verdict verdict;
};

/// Every view of a suite scene, the candidate drawn by these rules and judged by the precision that the
/// correct rasterizer declares.
std::vector<SuiteVerdict> try_suite_scene(const std::string& scene, int width, int height,
                                          const rasterizer::Rules& rules = rasterizer::correct_rules);

/// The failing class that most pixels got; agree where none failed.
PixelClass commonest_defect(const Verdict& verdict);

}  // namespace zproof
