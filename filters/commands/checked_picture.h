/// What filters check says of one picture, in words and as JSON (docs/filter-conformance.md).
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filters/commands/check_power.h"
#include "filters/selftest/filter_fault.h"

namespace zproof {

struct CheckedPicture {
    std::string scene, view;
    std::string method;  ///< as typed
    selftest::ConformanceResult result;
    std::vector<std::string> causes{};
    std::optional<JointConformance> joint{};  ///< the picture against its promise as a whole, where asked
    std::optional<CheckPower> power{};        ///< what the check could have seen of one that passes

    bool is_wrong() const { return result.is_caught() || (joint && joint->leaves_promise()); }
    /// Is nothing proved of it?
    bool is_open() const { return !is_wrong() && power && !power->proves_something(); }
};

/// "FAILED  worked / phi-0: nearest: 9 of 1024 pixels outside, ...", and further lines below it.
std::string in_words(const CheckedPicture& checked);

/// The same in numbers; null for what is not finite.
nlohmann::json to_json(const CheckedPicture& checked);

}  // namespace zproof
