/// Why a view fails: hypotheses put to the judge, and the one that nothing speaks against
/// (docs/diagnosis.md).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
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
    std::string look_at{};      ///< where in a renderer's code to look first, a sentence
    double saved_share = 0;     ///< of what the defects take to be told: what it spares (docs/diagnosis.md)
    /// How many explained defects are those at which the right answer would be admissible under it as well:
    /// it permits them, and does not make them.
    std::uint64_t permitted = 0;
    double saved_bits =
        0;  ///< what it spares, in bits: by this much the view votes for it (docs/diagnosis.md)
    std::string
        fitted{};  ///< what it fitted to the frames, as a clause: "depth is told times 1.1"; may be empty
};

struct Diagnosis {
    std::uint64_t defects = 0;            ///< of the whole view
    std::optional<Explanation> cause;     ///< nothing: none is named
    std::vector<Explanation> further;     ///< causes of the defects that it does not explain, at most 2
    std::vector<Explanation> runners_up;  ///< of the first cause, at most 3, the best first
};

/// What explained earlier views of a run.
struct EarlierCause {
    std::string name;
    double saved_bits = 0, all_bits = 0;  ///< over these views: what it spares, of what the defects take
};

/// Shares of what is spared that differ by less are alike: they are known from samples of a thousand pixels.
inline constexpr double alike_shares = 0.01;

/// The share of the tested defects that is explained.
double explained_share(const Explanation& explanation);

/// Tests every hypothesis on a verdict's defects, or on an evenly spread part of them where they are many.
/// A cause is named where nothing that was asked speaks against it and it shortens the description of the
/// frame by three quarters of what the defects take, with further causes of what it leaves, where there are
/// some (docs/diagnosis.md, "Named, or not"). Nothing without defects. Deterministic for any number of
/// threads; frames as judge() wants them. `without`: names of hypotheses that are left out, to learn what is
/// said of a cause that nobody thought of. `earlier`: asked before all others, and alone where one of them
/// explains this view too.
std::optional<Diagnosis> diagnose(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                  const RenderedFrame& reference, const Verdict& verdict,
                                  std::span<const std::string> without = {},
                                  std::span<const EarlierCause> earlier = {});

}  // namespace zproof
