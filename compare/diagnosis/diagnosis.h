/// Why a view fails: hypotheses put to the judge, and the one that explains the most defects
/// (docs/diagnosis.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/judge.h"

namespace zproof {

/// What became of one hypothesis.
struct Explanation {
    std::string name;                        ///< what is wrong, as a clause: "the image is flipped in y"
    std::string description;                 ///< one line
    std::uint64_t explained = 0, asked = 0;  ///< defects that are admissible under it, of those asked
    std::uint64_t contradicted = 0,
                  checked = 0;  ///< pixels that agree and would not under it, of those checked
    double saved_share = 0;     ///< how much shorter the defects are told with it, as a share; at most 1
};

struct Diagnosis {
    std::uint64_t defects = 0;            ///< of the whole view
    std::optional<Explanation> cause;     ///< nothing: no single cause
    std::vector<Explanation> runners_up;  ///< at most 3, the best first
};

/// The share of the tested defects that is explained.
double explained_share(const Explanation& explanation);

/// Tests every hypothesis on a verdict's defects, or on an evenly spread part of them where they are many.
/// The cause is what leaves the fewest pixels unexplained, if that is less than half the defects. Nothing
/// without defects. Deterministic for any number of threads; frames as judge() wants them.
std::optional<Diagnosis> diagnose(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                  const RenderedFrame& reference, const Verdict& verdict);

}  // namespace zproof
