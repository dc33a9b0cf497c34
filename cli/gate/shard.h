/// A run's share of the selected views.
#pragma once

#include <string>
#include <vector>

#include "program/scene_selection.h"
#include "program/settings/sources.h"
#include "reports/results.h"

namespace zproof {

inline constexpr int most_shards = 10'000;

/// The exit status of a shard, of which others judge the rest.
enum class ShardStatus {
    is_the_verdict,    ///< as of any run; ExitCode::nothing where it has no view at all
    ok_where_empty,    ///< ExitCode::proven where it has no view at all
    ok_where_written,  ///< ExitCode::proven, whatever its results are: merged, they tell the verdict
};

/// What is typed after --shard. Of a plan: "2" or "2/3", the second (of three). Without one: "hash:2/3".
/// "auto": as the environment says (cli/gate/shard_environment.h). Empty: the whole. A plan's shard that
/// states no count has 0. Throws UsageError.
Shard shard_from(const std::string& word, bool has_plan, const Environment& environment);

/// The word that means it: "hash:2/3"; of a plan "2".
std::string word_of(const Shard& shard);

/// The scenes, in their order, each with its share of views: its first view belongs to the shard that is its
/// word's SHA-256, the first 8 digits as a number, modulo the count, and each view after it to the next
/// shard. So a view's shard does not change with what else is selected.
std::vector<SceneSource> share_of(std::vector<SceneSource> sources, Shard shard);

/// What all shards of one run have in common: the scenes' words, and what the pictures are made with.
Selection selection_of(const std::vector<SceneSource>& sources, Resolution resolution);

}  // namespace zproof
