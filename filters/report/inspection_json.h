/// Inspections as the viewer reads them (reports/viewer/src/filter_inspection.ts).
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "filters/study/inspection.h"

namespace zproof {

/// One object per pixel and method. Lengths and weights have five significant digits; in_words() is in it.
nlohmann::json to_json(const std::vector<study::PixelInspection>& inspections);

}  // namespace zproof
