/// Waivers within results.json.
#pragma once

#include <nlohmann/json.hpp>

#include "compare/waivers/coverage.h"

namespace zproof {

nlohmann::ordered_json waiver_object(const Waiver& waiver);
nlohmann::ordered_json waiver_use_object(const WaiverUse& use);

/// Inverses, for json_read.cpp alone (see CMakeLists.txt). Throw nlohmann's exceptions where a key is
/// missing, ReportError where a word is unknown.
Waiver waiver_from(const nlohmann::ordered_json& json);
WaiverUse waiver_use_from(const nlohmann::ordered_json& json);

}  // namespace zproof
