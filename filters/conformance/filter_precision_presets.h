/// What texture filters that many people use promise, by name (docs/joint-conformance.md).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "filters/conformance/filter_precision.h"

namespace zproof {

struct FilterPrecisionPreset {
    std::string_view name;
    FilterPrecision precision;
    std::string_view source;  ///< where the promise is written down
};

std::span<const FilterPrecisionPreset> filter_precision_presets();

/// The preset of that name; nothing where there is none.
std::optional<FilterPrecision> preset_filter_precision(std::string_view name);

}  // namespace zproof
