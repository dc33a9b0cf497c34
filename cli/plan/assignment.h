/// Who judges which views, so that all shards end at about the same time.
#pragma once

#include <vector>

#include "reports/plan.h"

namespace zproof {

/// Gives every view of every run its shard: longest first, each to the shard that would end it earliest
/// (Graham, "Bounds on Multiprocessing Timing Anomalies", 1969). Each shard that has a view of a scene sets
/// it up, once. So a scene's views are kept together in pieces; of several lengths of pieces, from whole
/// scenes down to single views, the one is taken by which all shards end earliest. The same seconds: the same
/// plan.
void assign(Plan& plan);

/// The expected seconds of each shard, the first one's first.
std::vector<double> shard_seconds(const Plan& plan);

/// No assignment ends before this: the longest view with its scene's set-up, or the sum of all over the
/// number of shards.
double least_makespan_s(const Plan& plan);

}  // namespace zproof
