/// A suite scene that no longer shows what it is there for proves nothing: that fails the gate too.
#pragma once

#include <span>

#include "reports/results.h"

namespace zproof {

/// The views are one scene's: where a class that they expect occurred in none of them, the last one becomes
/// defective and its message names the class. Nothing is said of a scene of which a view is missing, as in a
/// shard that has some of them.
void hold_to_expectations(std::span<ViewResult> views);

}  // namespace zproof
