/// A suite scene that no longer shows what it is there for proves nothing: that fails the gate too.
#pragma once

#include <vector>

#include "cli/scene_selection.h"
#include "reports/results.h"

namespace zproof {

/// Where a class that the source expects occurred in none of the views, the last view becomes defective and
/// its message names the class. Only meaningful at default_resolution, for which the manifest is written.
void hold_to_expectations(const SceneSource& source, std::vector<ViewResult>& views);

}  // namespace zproof
