/// What a diagnosis says.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

/// The share of the tested defects that is explained.
inline double explained_share(const Explanation& e) {
    return e.asked == 0 ? 0 : double(e.explained) / double(e.asked);
}

}  // namespace zproof
