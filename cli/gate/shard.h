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
/// "auto": as the environment says (cli/gate/shard.h). Empty: the whole. A plan's shard that
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

/// From the first of these that is set; counts from 1, and a count of 0 is not told:
///
/// | who | index, from | count |
/// |---|---|---|
/// | Slurm's job arrays | SLURM_ARRAY_TASK_ID, from _MIN in steps of _STEP | SLURM_ARRAY_TASK_COUNT |
/// | GitLab CI | CI_NODE_INDEX, 1 | CI_NODE_TOTAL |
/// | Kubernetes' Indexed Jobs | JOB_COMPLETION_INDEX, 0 | - |
/// | Bazel and others | TEST_SHARD_INDEX, 0 | TEST_TOTAL_SHARDS |
/// | MPICH, Slurm's PMI | PMI_RANK, 0 | PMI_SIZE |
/// | Open MPI | OMPI_COMM_WORLD_RANK, 0 | OMPI_COMM_WORLD_SIZE |
///
/// Touches TEST_SHARD_STATUS_FILE, which tells Bazel that its shards are listened to. Throws UsageError where
/// none is set, or one is set to what is no number, or to one outside its count.
Shard shard_of_environment(const Environment& environment);

}  // namespace zproof
