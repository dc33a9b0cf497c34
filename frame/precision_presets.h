/// Declarations of renderers that many people use, by name (docs/presets.md).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "frame/precision.h"

namespace zproof {

struct PrecisionPreset {
    std::string_view name;
    Precision precision;
    std::string_view source;  ///< where the promise is written down
};

std::span<const PrecisionPreset> precision_presets();

/// The preset of that name; nothing where there is none.
std::optional<Precision> preset_precision(std::string_view name);

}  // namespace zproof
