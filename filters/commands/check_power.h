/// What could a check have seen? The claimed method's own picture is planted with defects of a known size,
/// and held to the same promise (docs/filter-conformance.md, "Power").
#pragma once

#include <string>
#include <vector>

#include "filters/conformance/joint_conformance.h"
#include "filters/selftest/changed_definition.h"

namespace zproof {

/// What it says where a check would not refuse a defect that shows.
enum class DefectKind {
    beyond_promise,  ///< Half a texel or level beyond what is promised of places and the LOD: nothing is
                     ///< proved of them.
    simpler_method,  ///< Nothing is proved of the method, unless the promise itself admits the simpler one,
                     ///< or its picture has the same 8-bit sRGB codes.
    other  ///< Nothing: it may be as small as the picture makes it.
};

/// A defect that a picture could have had.
struct PlantedDefect {
    selftest::DefinitionChange change;
    DefectKind kind = DefectKind::beyond_promise;
};

std::vector<PlantedDefect> planted_defects(const selftest::FilterClaim& claim);

struct CheckPower {
    std::vector<std::string> refused{};  ///< defects with which the picture would have failed
    std::vector<std::string>
        admitted{};  ///< defects with which it would have passed as well, though they show
    std::vector<std::string> unproven{};  ///< those among these for which it proves nothing
    std::vector<std::string>
        settings{};         ///< promises under which none would be unproven; empty where none helps
    double wide_share = 0;  ///< of pixels whose permitted range is wider than 1/8 of the textures' range

    /// Did the picture show anything by which a defect is told? Nothing is unproven then, either.
    bool proves_something() const { return unproven.empty() && !refused.empty(); }
};

/// The joint check must be of the same claim. On the threads of the surrounding tbb::task_arena.
CheckPower power_of(const selftest::FilterFixture& fixture, const selftest::FilterClaim& claim,
                    const Conformance& found, const JointCheck& joint);

/// "would refuse: ...", "would not refuse: ...", and of a check that proves nothing what would prove
/// something.
std::vector<std::string> in_words(const CheckPower& power, const Conformance& found);

}  // namespace zproof
