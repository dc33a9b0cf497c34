/// What could a check have seen? The claimed method's own picture is planted with defects of a known size,
/// and held to the same promise (docs/filter-conformance.md, "Power").
#pragma once

#include <string>
#include <vector>

#include "filters/conformance/joint_conformance.h"
#include "filters/selftest/changed_definition.h"

namespace zproof {

/// A defect that a picture could have had.
struct PlantedDefect {
    selftest::DefinitionChange change;
    /// Half a texel or level beyond what the promise says of places and of the LOD in so many words. A check
    /// that would not refuse such a defect proves nothing of them.
    bool is_standard = true;
};

std::vector<PlantedDefect> planted_defects(const selftest::FilterClaim& claim);

struct CheckPower {
    std::vector<std::string> refused{};  ///< defects with which the picture would have failed
    std::vector<std::string>
        admitted{};  ///< defects with which it would have passed as well, though they show
    std::vector<std::string> unproven{};  ///< the standard ones among these
    std::vector<std::string>
        settings{};         ///< promises under which none would be unproven; empty where none helps
    double wide_share = 0;  ///< of pixels whose permitted range is wider than 1/8 of the textures' range

    /// Did the picture show anything by which a standard defect is told? Nothing is unproven then, either.
    bool proves_something() const { return unproven.empty() && !refused.empty(); }
};

/// The joint check must be of the same claim. On the threads of the surrounding tbb::task_arena.
CheckPower power_of(const selftest::FilterFixture& fixture, const selftest::FilterClaim& claim,
                    const Conformance& found, const JointCheck& joint);

/// "would refuse: ...", "would not refuse: ...", and of a check that proves nothing what would prove
/// something.
std::vector<std::string> in_words(const CheckPower& power, const Conformance& found);

}  // namespace zproof
