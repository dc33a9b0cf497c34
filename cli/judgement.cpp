#include "cli/judgement.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "cli/interrupt.h"
#include "cli/outcome_code.h"
#include "cli/progress.h"
#include "cli/renderers/roster.h"
#include "cli/scene_run.h"
#include "cli/threads.h"
#include "cli/times_table.h"
#include "cli/version.h"
#include "oracle/embree.h"
#include "oracle/oracle_error.h"
#include "reports/html.h"
#include "reports/json.h"
#include "reports/junit.h"
#include "reports/output_folder.h"
#include "reports/terminal.h"
#include "reports/wording.h"

namespace zproof {
namespace {

Colour resolve(ColourWish wish) {
    if (wish == ColourWish::always) return Colour::ansi;
    if (wish == ColourWish::never) return Colour::plain;
    const char* no_color = std::getenv("NO_COLOR");  // no-color.org: any value but the empty one
    const bool refused = no_color != nullptr && *no_color != '\0';
    return !refused && is_terminal(STDOUT_FILENO) ? Colour::ansi : Colour::plain;
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out{file, std::ios::binary};
    out << text << std::flush;
    if (!out) throw ReportError{file.string() + ": cannot be written; is the disk full?"};
}

void write_reports(const std::filesystem::path& folder, const Results& results) {
    write_text(folder / "results.json", to_json(results));
    write_text(folder / "junit.xml", to_junit(results));
    write_text(folder / "report.html", to_html(results, folder));
}

/// An interrupt that comes when everything is judged changes nothing any more.
Ending judge_all(const std::vector<SceneSource>& sources, const Desk& desk, std::vector<ViewResult>& views) {
    Ending ending = Ending::complete;
    for (const SceneSource& source : sources) {
        if (ending == Ending::interrupted || interrupted()) {
            ending = Ending::interrupted;
            views.push_back(left_by_interrupt(source));
            continue;
        }
        SceneReport report = run_scene(source, desk);
        ending = report.ending;
        std::ranges::move(report.views, std::back_inserter(views));
    }
    return ending;
}

/// What an earlier run into this folder found; nothing where there was none, or one of another version.
Results earlier_results(const std::filesystem::path& folder) {
    std::ifstream in{folder / "results.json"};
    std::stringstream text;
    text << in.rdbuf();
    try {
        return in ? results_from_json(text.str()) : Results{};
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

void print(const ReportArguments& report, const Results& results, ExitCode code) {
    if (report.detail != Detail::verdict) std::cout << summary_table(results, resolve(report.colour));
    if (report.detail == Detail::times) std::cout << times_table(results);
    std::cout << in_words(code) << ": " << counted(results.views.size(), "view")
              << "; report: " << (report.out / "report.html").string() << "\n";
}

/// Candidate, reference, and the witnesses that can be asked. Throws OracleError for one that must be there
/// and is not.
std::vector<RendererFacts> roll_call(const Parties& parties) {
    std::vector<RendererFacts> present;
    const auto call = [&](const RendererChoice& choice, WitnessChoice::Need need) {
        const std::string absent = absence_of(choice);
        if (absent.empty()) return present.push_back(facts_of(choice));
        if (need == WitnessChoice::Need::required) throw OracleError{name_of(choice) + ": " + absent};
    };
    call(parties.candidate, WitnessChoice::Need::required);
    call(parties.reference, WitnessChoice::Need::required);
    for (const WitnessChoice& witness : parties.witnesses) call(witness.renderer, witness.need);
    return present;
}

/// A scene that was left counts as one view.
Share judged_of(const Results& results) {
    return {std::size_t(std::ranges::count_if(results.views, was_judged)), results.views.size()};
}

}  // namespace

ExitCode judge_and_report(const Assignment& assignment) {
    const auto& [sources, parties, settings, report, only_view] = assignment;
    Results results{.version = version_number(),
                    .command = report.typed,
                    .compiler = compiler_name(),
                    .embree = oracle::embree_version(),
                    .threads = settings.threads,
                    .renderers = roll_call(parties),
                    .views = {}};
    OutputFolder out{report.out};
    note_interrupts();

    FolderNames names;
    Ending ending = Ending::complete;
    {
        Progress progress{std::cerr, resolve(report.progress), expected_work(sources, report.out)};
        const Desk desk{settings.resolution, out.working(), names, progress, parties,
                        report.pictures,     only_view};
        on_threads(settings.threads, [&] { ending = judge_all(sources, desk, results.views); });
    }
    const ExitCode code = exit_code_of(results, ending);
    write_reports(out.working(), results);
    out.publish();
    print(report, results, code);
    return code == ExitCode::interrupted ? say_interrupted(judged_of(results), "view", "judged and written")
                                         : code;
}

}  // namespace zproof
