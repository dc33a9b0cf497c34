/// Which shards of a plan are not there, and how they are made.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "reports/plan.h"

namespace zproof {

/// One run of a plan.
struct PlannedShards {
    const Plan& plan;
    const PlannedRun& run;
};

class MissingShards {
  public:
    explicit MissingShards(const PlannedShards& planned)
        : planned_(planned), is_there_(std::size_t(planned.plan.shards), false) {}

    /// Why these results are none of a shard of the plan; empty where they are.
    std::string fault_of(const Results& results) const;

    void found(int number) { is_there_[std::size_t(number - 1)] = true; }
    std::size_t count() const;

    /// A line for each: "shard 3 is missing; zproof run --plan plan.json --shard 3 -o shards/3". `example` is
    /// the folder of one that was named.
    std::vector<std::string> commands(const std::filesystem::path& plan,
                                      const std::filesystem::path& example) const;

    /// What stands for their views.
    std::vector<ViewResult> views() const;

  private:
    bool is_there(int number) const { return is_there_[std::size_t(number - 1)]; }

    PlannedShards planned_;
    std::vector<bool> is_there_;
};

/// The command that judges a shard of a plan.
std::string shard_command(const std::filesystem::path& plan, int number, const std::filesystem::path& folder);

/// What one run of a plan leaves in a folder: all of it, or a folder of its own where there are several runs.
std::filesystem::path folder_of(const PlannedRun& run, const std::filesystem::path& folder);

/// The arguments as they are for one run of a plan.
ReportArguments report_of(const PlannedRun& run, const ReportArguments& report);

}  // namespace zproof
