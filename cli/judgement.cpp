#include "cli/judgement.h"

#include <algorithm>
#include <iostream>
#include <optional>

#include "cli/announcement.h"
#include "cli/progress.h"
#include "cli/shrinker.h"
#include "cli/supervision.h"
#include "frame/whole_file.h"
#include "math/processor.h"
#include "program/common_arguments.h"
#include "program/interrupt.h"
#include "program/publish.h"
#include "program/version.h"
#include "reports/extent.h"
#include "reports/output_folder.h"
#include "reports/pages/json.h"
#include "reports/pages/writers.h"

namespace zproof {
namespace {

/// Pictures of thousands of scenes, or of scenes that are drawn by chance, are looked at where they fail
/// alone.
bool are_all_shown(const std::vector<SceneSource>& sources) {
    constexpr std::size_t most_shown = 1000;
    return sources.size() <= most_shown &&
           std::ranges::count(sources, SceneSource::Kind::random, &SceneSource::kind) == 0;
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

/// The share of the known views that were judged.
Share judged_of(const Results& results, std::size_t scenes_left) {
    return {std::size_t(std::ranges::count_if(results.views, was_judged)),
            std::size_t(extent_of(results).views), scenes_left};
}

/// Does the status leave the verdict to whoever merges the shards?
bool may_pass(const Results& results, ExitCode code, ShardStatus status) {
    if (code == ExitCode::internal || code == ExitCode::interrupted) return false;
    return status == ShardStatus::ok_where_written ||
           (status == ShardStatus::ok_where_empty && results.views.empty());
}

Completeness completeness_of(const Results& results, const std::optional<Foreword>& foreword) {
    const bool was_cut_short = foreword && foreword->code == ExitCode::interrupted;
    return results.ending == Ending::complete && !was_cut_short ? Completeness::full : Completeness::partial;
}

Foreword written_foreword(const std::filesystem::path& folder, Foreword foreword) {
    document::require_sound(foreword.document);
    write_whole_file(folder / foreword.file, document::json_of(foreword.document));
    return foreword;
}

/// Prints what the report arguments ask for; the reports lie in this folder.
ExitCode told(const Results& results, const ReportArguments& report, const std::filesystem::path& folder,
              const std::optional<Foreword>& foreword) {
    ReportArguments published = report;
    published.common.out = folder;
    if (!report.common.is_quiet()) std::cout << shrunk_in_words(results, report.common.out, folder);
    if (foreword && !report.common.is_quiet())
        std::cout << document::terminal_text(foreword->document) << "\n";
    const bool are_told = foreword || progress_of(report.common) == ProgressStyle::lines;
    return announce(results, published, are_told ? SummaryStyle::Rows::none : SummaryStyle::Rows::each_view,
                    foreword ? foreword->code : ExitCode::nothing);
}

}  // namespace

ExitCode judge_and_report(const RunRequest& request) {
    const auto& [sources, renderers, settings, report, selection, shard, shard_status, reference_cache,
                 early_end_rule, views, foreword_of] = request;
    const Gate gate = open_gate(report.gate);
    Results results{.version = version_number(),
                    .commit = commit(),
                    .command = report.typed,
                    .argv = report.argv,
                    .compiler = compiler_name(),
                    .embree = "",
                    .threads = report.common.threads,
                    .isa = std::string(name_of(widest_allowed())),
                    .shard = shard,
                    .selection = selection,
                    .today = gate.waivers.empty() ? "" : in_words(gate.today),
                    .diagnosis = report.diagnosis,
                    .strictness = gate.strictness,
                    .waivers = gate.waivers,
                    .renderers = {},
                    .views = {}};
    OutputFolder out{report.common.out};
    note_interrupts();

    std::optional<oracle::ReferenceCache> cache;
    if (!reference_cache.folder.empty()) cache.emplace(reference_cache);
    FolderNames names;
    std::size_t scenes_left = 0;
    EarlyEnd early_end(early_end_rule);
    CauseVote causes;
    {
        Progress progress{std::cerr, progress_of(report.common), expected_work(sources, report.common.out)};
        const RunConfig config{renderers,
                               settings,
                               report,
                               views,
                               gate,
                               out.working(),
                               names,
                               progress,
                               early_end,
                               causes,
                               are_all_shown(sources),
                               cache ? &*cache : nullptr};
        scenes_left = judge_supervised(sources, config, report.common.threads, results);
    }
    std::optional<Foreword> foreword;
    if (foreword_of && results.ending == Ending::complete)
        foreword = written_foreword(out.working(), foreword_of(results));
    on_threads(report.common.threads, [&] {
        write_reports(out.working(), results, request.report.formats,
                      foreword ? &foreword->document : nullptr);
    });
    const ExitCode code =
        told(results, report, publish(out, report.common, completeness_of(results, foreword)), foreword);
    if (may_pass(results, code, shard_status)) return ExitCode::proven;
    if (code != ExitCode::interrupted || results.ending == Ending::complete) return code;
    return say_interrupted(judged_of(results, scenes_left), "view", "judged and written");
}

}  // namespace zproof
