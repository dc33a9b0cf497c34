#include "cli/judgement.h"

#include <algorithm>
#include <iostream>
#include <iterator>

#include "cli/announcement.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/published.h"
#include "cli/renderers/registry.h"
#include "cli/scene_run.h"
#include "cli/threads.h"
#include "cli/version.h"
#include "oracle/embree.h"
#include "oracle/oracle_error.h"
#include "reports/extent.h"
#include "reports/output_folder.h"

namespace zproof {
namespace {

/// An interrupt that comes when everything is judged changes nothing any more. Returns how many scenes it
/// kept from being begun.
std::size_t judge_all(const std::vector<SceneSource>& sources, const RunConfig& config, Results& results) {
    std::size_t left = 0;
    for (const SceneSource& source : sources) {
        if (results.ending == Ending::interrupted || interrupted()) {
            results.ending = Ending::interrupted;
            results.views.push_back(left_by_interrupt(source));
            ++left;
            continue;
        }
        SceneReport report = run_scene(source, config);
        results.ending = report.ending;
        std::ranges::move(report.views, std::back_inserter(results.views));
    }
    return left;
}

/// What an earlier run into this folder found; nothing where there was none, or one of another version.
Results earlier_results(const std::filesystem::path& folder) {
    try {
        return read_results(folder);
    } catch (const ReportError&) {
        return {};
    }
}

std::vector<SceneWork> expected_work(const std::vector<SceneSource>& sources,
                                     const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const SceneSource& source : sources) names.push_back(source.name);
    return expected_work(names, earlier_results(folder));
}

/// Candidate, reference, and the oracles that can be asked. Throws OracleError for one that must be there
/// and is not.
std::vector<RendererFacts> facts_of_all(const ChosenRenderers& renderers) {
    std::vector<RendererFacts> present;
    const auto call = [&](const RendererChoice& choice, OracleChoice::Need need) {
        const std::string absent = absence_of(choice);
        if (absent.empty()) return present.push_back(facts_of(choice));
        if (need == OracleChoice::Need::required) throw OracleError{name_of(choice) + ": " + absent};
    };
    call(renderers.candidate, OracleChoice::Need::required);
    call(renderers.reference, OracleChoice::Need::required);
    for (const OracleChoice& oracle : renderers.oracles) call(oracle.renderer, oracle.need);
    return present;
}

/// The share of the known views that were judged.
Share judged_of(const Results& results, std::size_t scenes_left) {
    return {std::size_t(std::ranges::count_if(results.views, was_judged)),
            std::size_t(extent_of(results).views), scenes_left};
}

}  // namespace

ExitCode judge_and_report(const RunRequest& request) {
    const auto& [sources, renderers, settings, report, selection, shard, only_view] = request;
    const Gate gate = open_gate(report.gate);
    Results results{.version = version_number(),
                    .command = report.typed,
                    .argv = report.argv,
                    .compiler = compiler_name(),
                    .embree = oracle::embree_version(),
                    .threads = settings.threads,
                    .shard = shard,
                    .selection = selection,
                    .today = gate.waivers.empty() ? "" : in_words(gate.today),
                    .strictness = gate.strictness,
                    .waivers = gate.waivers,
                    .renderers = facts_of_all(renderers),
                    .views = {}};
    OutputFolder out{report.out};
    note_interrupts();

    FolderNames names;
    std::size_t scenes_left = 0;
    {
        Progress progress{std::cerr, resolve(report.progress), expected_work(sources, report.out)};
        const RunConfig config{settings.resolution, out.working(), names,           progress,
                               renderers,           gate,          report.pictures, report.evidence,
                               settings.samples,    only_view};
        on_threads(settings.threads,
                   [&, &scenes = sources] { scenes_left = judge_all(scenes, config, results); });
    }
    on_threads(settings.threads, [&] { write_reports(out.working(), results, report.formats); });
    ReportArguments published = report;
    published.out = publish(out, report.out,
                            results.ending == Ending::complete ? Completeness::full : Completeness::partial);
    const ExitCode code = announce(results, published);
    if (code != ExitCode::interrupted) return code;
    return say_interrupted(judged_of(results, scenes_left), "view", "judged and written");
}

}  // namespace zproof
