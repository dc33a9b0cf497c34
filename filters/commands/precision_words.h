/// What a filter promises, as typed.
#pragma once

#include <string>
#include <vector>

#include "filters/conformance/filter_precision.h"

namespace zproof {

/// "gpu", "lod_bits=6", "displacement_px=0.002" ...: a preset may come first, and keys change it. Without a
/// preset, what is not named is as exact as double arithmetic. Throws UsageError for an unknown preset or
/// key, a preset that is not the first word, or a value that is no number from 0 to 1000.
FilterPrecision filter_precision_from_words(const std::vector<std::string>& words);

}  // namespace zproof
