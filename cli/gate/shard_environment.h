/// Which shard the surroundings say that this process is.
#pragma once

#include "program/settings/sources.h"
#include "reports/results.h"

namespace zproof {

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
