#include "cli/plan/planned_run.h"

#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "cli/judgement.h"
#include "cli/outcome_code.h"
#include "cli/plan/missing_shards.h"
#include "cli/selected_scenes.h"
#include "oracle/file_descriptor.h"
#include "program/failure.h"
#include "program/interrupt.h"
#include "program/usage_error.h"
#include "program/version.h"
#include "reports/plan.h"
#include "reports/report_error.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

void require_ours(const Plan& plan, const std::filesystem::path& file) {
    if (plan.version != version_number() || plan.commit != commit())
        throw ReportError{file.string() + ": was made by zproof " + plan.version + " " + plan.commit +
                          ", this is " + version_number() + " " + commit() + "; make it again (zproof plan)"};
}

/// The shard that was asked for, with what the plan says of it.
Shard shard_of(const Plan& plan, const Shard& asked) {
    if (asked.number <= plan.shards && (asked.count == 0 || asked.count == plan.shards))
        return {asked.number, plan.shards, plan.sha256, asked.taken_from};
    throw UsageError{"--shard: the plan has " + std::to_string(plan.shards) + " shards, and " +
                     (asked.taken_from.empty() ? "what was typed" : asked.taken_from) + " says shard " +
                     std::to_string(asked.number) +
                     (asked.count == 0 ? "" : " of " + std::to_string(asked.count)) +
                     "; name the plan's by its number: --shard 1"};
}

/// The scenes of which the shard has views.
std::vector<SceneSource> share_of(std::vector<SceneSource> sources, const PlannedRun& run, int shard) {
    std::vector<SceneSource> share;
    for (SceneSource& source : sources) {
        const PlannedScene& scene = run.scenes[source.place];
        PlannedViews views{.all = scene.views, .wanted = {}};
        for (std::size_t i = 0; i < scene.shards.size(); ++i)
            if (scene.shards[i] == shard) views.wanted.push_back(i);
        if (views.wanted.empty()) continue;
        source.share.planned = std::move(views);
        share.push_back(std::move(source));
    }
    return share;
}

ExitCode judge(const PlannedRun& run, const Shard& shard, const RunArguments& arguments) {
    RunArguments planned = planned_run(run.argv);
    SelectedScenes selected = selected_scenes(planned);
    if (selected.selection.sha256 != run.selection.sha256)
        throw SceneError{"the plan was made of other scenes than those that are here now: of " +
                         std::to_string(run.selection.scenes) + ", and here are " +
                         std::to_string(selected.selection.scenes) +
                         "; make it again, or bring the same files (it names them as its run.argv does)"};
    planned.report.formats = arguments.report.formats;
    planned.report.typed = arguments.report.typed;
    planned.report.argv = arguments.report.argv;
    planned.report.common = report_of(run, arguments.report).common;
    return judge_and_report({.sources = share_of(std::move(selected.sources), run, shard.number),
                             .renderers = planned.renderers,
                             .settings = planned.settings,
                             .report = planned.report,
                             .selection = run.selection,
                             .shard = shard,
                             .shard_status = arguments.shard_status,
                             .reference_cache = arguments.reference_cache,
                             .early_end = arguments.early_end});
}

/// In a process of its own, since a run leaves threads behind, and the next one must begin without
/// (cli/worker.h).
ExitCode judge_apart(const PlannedRun& run, const Shard& shard, const RunArguments& arguments) {
    std::cout.flush();
    const pid_t id = fork();
    if (id < 0) throw std::runtime_error{"no process can be started"};
    if (id == 0) {
        const ExitCode code = report_failures("cannot judge", [&] { return judge(run, shard, arguments); });
        std::cout.flush();
        _exit(int(code));
    }
    note_interrupts();
    hand_interrupts_to(id);
    const int status = oracle::status_at_end(id);
    hand_interrupts_to(0);
    return WIFEXITED(status) ? ExitCode(WEXITSTATUS(status)) : ExitCode::internal;
}

}  // namespace

ExitCode run_planned(const RunArguments& arguments) {
    const Plan plan = read_plan(arguments.plan);
    require_ours(plan, arguments.plan);
    const Shard shard = shard_of(plan, arguments.shard);
    if (plan.runs.size() == 1) return judge(plan.runs.front(), shard, arguments);
    std::vector<ExitCode> codes;
    for (const PlannedRun& run : plan.runs) {
        codes.push_back(judge_apart(run, shard, arguments));
        if (codes.back() == ExitCode::interrupted) break;
    }
    return worst_of(codes);
}

}  // namespace zproof
