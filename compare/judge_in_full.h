/// The judge's verdict with what else it works out on its way, for pages that show it.
#pragma once

#include <vector>

#include "compare/first_pass/error_map.h"
#include "compare/truth/standing.h"

namespace zproof {

/// What the admissible set said of both answers at a pixel.
struct RuledPlace {
    int x = 0, y = 0;
    Decision candidate, reference;
    double candidate_eps_px = 0, reference_eps_px = 0;  ///< half-sides of the squares they were judged in
};

struct JudgedInFull {
    Verdict verdict;  ///< with every finding
    ErrorMaps errors;
    std::vector<RuledPlace> rulings;  ///< of every finding that was ruled on by itself; in raster order
};

/// judge(), with the findings of all pixels that do not `agree`; what error_over_bound() says of either
/// frame, bit for bit; and the rulings.
JudgedInFull judge_in_full(const Scene& scene, const View& view, const Testimony& candidate,
                           const Testimony& reference);

}  // namespace zproof
