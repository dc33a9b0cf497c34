#include "cli/plan/shard_commands.h"

#include "cli/arguments.h"
#include "cli/plan/missing_shards.h"
#include "program/shell_line.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

std::string lines(const Plan& plan, const fs::path& file) {
    std::string text;
    for (int number = 1; number <= plan.shards; ++number)
        text += shard_command(file, number, fs::path("shards") / std::to_string(number)) + "\n";
    return text;
}

/// Single tasks may be submitted again: sbatch --array=3,5.
std::string slurm_script(const Plan& plan, const fs::path& file) {
    return "#!/bin/bash\n"
           "#SBATCH --job-name=zproof\n"
           "#SBATCH --array=1-" +
           std::to_string(plan.shards) +
           "\n"
           "#SBATCH --requeue\n"
           "zproof run --plan " +
           shell_quoted(file.string()) +
           " --shard \"$SLURM_ARRAY_TASK_ID\" --exit-zero --report json -o \"shards/$SLURM_ARRAY_TASK_ID\"\n";
}

/// For strategy.matrix: ${{ fromJSON(...) }}.
std::string github_matrix(const Plan& plan) {
    std::string numbers;
    for (int number = 1; number <= plan.shards; ++number)
        numbers += (number == 1 ? "" : ",") + std::to_string(number);
    return "{\"shard\":[" + numbers + "]}\n";
}

std::string gitlab_job(const Plan& plan, const fs::path& file) {
    return "judge:\n"
           "  parallel: " +
           std::to_string(plan.shards) +
           "\n"
           "  script:\n"
           "    - zproof run --plan " +
           shell_quoted(file.string()) +
           " --shard auto --exit-zero --report json -o \"shards/$CI_NODE_INDEX\"\n"
           "  artifacts:\n"
           "    paths: [shards]\n"
           "    when: always\n";
}

}  // namespace

std::string shard_commands(const Plan& plan, const fs::path& file, PlanFormat format) {
    switch (format) {
        case PlanFormat::lines:
            return lines(plan, file);
        case PlanFormat::slurm:
            return slurm_script(plan, file);
        case PlanFormat::github:
            return github_matrix(plan);
        case PlanFormat::gitlab:
            return gitlab_job(plan, file);
    }
    return "";
}

}  // namespace zproof
