/// What well-known renderers and data sets write (docs/conventions.md has the sources).
#pragma once

#include <span>
#include <string_view>

namespace zproof {

struct ConventionPreset {
    std::string_view name;
    std::string_view keys;  ///< as after --convention
};

std::span<const ConventionPreset> convention_presets();

}  // namespace zproof
