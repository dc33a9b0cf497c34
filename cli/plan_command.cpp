#include <algorithm>
#include <iostream>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/plan/assignment.h"
#include "cli/plan/expected_seconds.h"
#include "cli/plan/shard_commands.h"
#include "cli/report_files.h"
#include "cli/selected_scenes.h"
#include "frame/whole_file.h"
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
