/// A run's share of the selected scenes.
#pragma once

#include <string>
#include <vector>

#include "cli/scene_selection.h"
#include "reports/results.h"

namespace zproof {

/// "hash:2/3" is the second of three. Throws UsageError.
Shard shard_from(const std::string& word);

/// The scenes of one shard, in their order. A scene's shard is its word's SHA-256, the first 8 digits as a
/// number, modulo the count: it does not change with what else is selected.
std::vector<SceneSource> share_of(std::vector<SceneSource> sources, Shard shard);

/// What all shards of one run have in common: the scenes' words, and what the pictures are made with.
Selection selection_of(const std::vector<SceneSource>& sources, Resolution resolution);

}  // namespace zproof
