/// Shards of one run, put together again.
#pragma once

#include <string>
#include <vector>

#include "reports/results.h"

namespace zproof {

/// What one run of the whole selection would have found out: the views in the order of the selection, each
/// with the times that its shard took. Throws ReportError naming the shard at fault where they are not the
/// shards of one run, each there exactly once and run to its end. `names` are for messages, one per shard.
Results merged(const std::vector<Results>& shards, const std::vector<std::string>& names);

/// The words without "--shard X" and "-o X" ("--out X"), in all ways to write them.
std::vector<std::string> without_shard_words(const std::vector<std::string>& argv);

}  // namespace zproof
