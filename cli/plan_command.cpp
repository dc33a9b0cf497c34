#include <algorithm>
#include <filesystem>
#include <iostream>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/plan/assignment.h"
#include "cli/plan/expected_seconds.h"
#include "cli/plan/missing_shards.h"
#include "cli/report_files.h"
#include "cli/selected_scenes.h"
#include "frame/whole_file.h"
#include "program/shell_line.h"
#include "program/version.h"
#include "reports/plan.h"
#include "reports/wording.h"

namespace zproof {
namespace {

/// The earlier run that judged this renderer; else the first.
EarlierRun earlier_run(const std::vector<Results>& all, const RendererChoice& candidate) {
    for (const Results& results : all)
        if (!results.renderers.empty() && results.renderers.front().name == name_of(candidate))
            return EarlierRun{results};
    return all.empty() ? EarlierRun{} : EarlierRun{all.front()};
}

PlannedRun planned(const RunWords& words, const std::vector<Results>& earlier_runs) {
    const RunArguments run = planned_run(words.argv);
    const SelectedScenes selected = selected_scenes(run);
    const EarlierRun earlier = earlier_run(earlier_runs, run.renderers.candidate);
    PlannedRun planned{.name = words.name, .argv = words.argv, .selection = selected.selection, .scenes = {}};
    for (const SceneSource& source : selected.sources) {
        const auto known = earlier.scene(source.name);
        planned.scenes.push_back(known ? *known : unknown_scene(source, run.settings, earlier.slowness()));
        planned.scenes.back().shards.assign(planned.scenes.back().view_s.size(), 1);
    }
    return planned;
}

void say_makespan(const Plan& plan) {
    std::cerr << "zproof: " << counted(std::uint64_t(plan.shards), "shard") << "; expected to end after "
              << fixed(std::ranges::max(shard_seconds(plan)), 2) << " s; no plan ends before "
              << fixed(least_makespan_s(plan), 2) << " s\n";
}

std::string lines(const Plan& plan, const std::filesystem::path& file) {
    std::string text;
    for (int number = 1; number <= plan.shards; ++number)
        text += shard_command(file, number, std::filesystem::path("shards") / std::to_string(number)) + "\n";
    return text;
}

/// Single tasks may be submitted again: sbatch --array=3,5.
std::string slurm_script(const Plan& plan, const std::filesystem::path& file) {
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
    std::string numbers = "1";
    for (int number = 2; number <= plan.shards; ++number) numbers += "," + std::to_string(number);
    return "{\"shard\":[" + numbers + "]}\n";
}

std::string gitlab_job(const Plan& plan, const std::filesystem::path& file) {
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

/// A command for each shard, in the words of whoever starts them; each leaves its results in shards/NUMBER.
std::string shard_commands(const Plan& plan, const std::filesystem::path& file, PlanFormat format) {
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

}  // namespace

ExitCode execute(const PlanArguments& arguments) {
    std::vector<Results> earlier;
    for (const std::filesystem::path& results : arguments.earlier) earlier.push_back(read_results(results));
    Plan plan{.version = version_number(), .commit = commit(), .shards = arguments.shards, .runs = {}};
    for (const RunWords& run : arguments.runs) plan.runs.push_back(planned(run, earlier));
    assign(plan);
    write_whole_file(arguments.common.out, to_json(plan));
    std::cout << shard_commands(plan, arguments.common.out, arguments.format);
    if (!arguments.common.is_quiet()) say_makespan(plan);
    return ExitCode::proven;
}

}  // namespace zproof
