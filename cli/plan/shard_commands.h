/// The commands of a plan's shards, in the words of whoever starts them.
#pragma once

#include <filesystem>
#include <string>

#include "cli/arguments.h"
#include "reports/plan.h"

namespace zproof {

/// Each shard leaves its results in shards/NUMBER. Ends in a newline.
std::string shard_commands(const Plan& plan, const std::filesystem::path& file, PlanFormat format);

}  // namespace zproof
