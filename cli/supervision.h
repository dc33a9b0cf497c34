/// Judges scenes in other processes: what ends one of them costs the scene that it was at, and the run goes
/// on.
#pragma once

#include <cstddef>
#include <vector>

#include "cli/scene_run.h"
#include "reports/results.h"

namespace zproof {

/// Judges all of them on so many threads, and fills in the results: what the renderers are, the views, how it
/// ended. Returns how many scenes an interrupt kept from being begun. To be called before this process has
/// any thread but one. Throws UsageError or std::runtime_error with the words of whatever ended the work on
/// all scenes.
std::size_t judge_supervised(const std::vector<SceneSource>& sources, const RunConfig& config, int threads,
                             Results& results);

}  // namespace zproof
