/// The command that plans, as typed values.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "program/common_arguments.h"

namespace zproof {

/// In whose words the shards' commands are printed.
enum class PlanFormat {
    lines,   ///< a command each
    slurm,   ///< a batch script for an array of jobs
    github,  ///< a matrix of GitHub Actions, JSON
    gitlab,  ///< a job of GitLab CI, YAML
};

/// A run to be planned for.
struct RunWords {
    std::string name;               ///< its profile; empty: that of the settings, or none
    std::vector<std::string> argv;  ///< of the run, with all its settings, without "zproof"
};

struct PlanArguments {
    CommonArguments common{.output = Output::file, .out = "plan.json"};
    int shards = 0;
    std::vector<std::filesystem::path> earlier;  ///< results of earlier runs
    PlanFormat format = PlanFormat::lines;
    std::vector<RunWords> runs;  ///< one per renderer
};

}  // namespace zproof
