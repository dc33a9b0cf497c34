#include "cli/view_result.h"

#include <algorithm>
#include <cmath>

#include "cli/arguments.h"
#include "compare/explain.h"

namespace zproof {
namespace {

constexpr std::size_t most_reported_findings = 200, most_reported_of_witness = 20;

/// Defects before lawful differences, then the larger error/bound (NaN last), then raster order.
bool worse(const Finding& a, const Finding& b) {
    if (passes(a.verdict) != passes(b.verdict)) return passes(b.verdict);
    const auto ratio = [](const Finding& f) {
        return std::isnan(f.error_over_bound) ? -1 : f.error_over_bound;
    };
    if (ratio(a) != ratio(b)) return ratio(a) > ratio(b);
    return std::pair{a.y, a.x} < std::pair{b.y, b.x};
}

std::vector<Finding> worst_of(std::vector<Finding> findings, std::size_t most) {
    const std::size_t count = std::min(findings.size(), most);
    std::ranges::partial_sort(findings, findings.begin() + std::ptrdiff_t(count), worse);
    findings.resize(count);
    return findings;
}

/// Each finding with its sentence and the command that tells more.
std::vector<ReportedFinding> stories(const Docket& docket, const RendererChoice& candidate,
                                     const std::vector<Finding>& findings) {
    std::vector<ReportedFinding> told;
    for (const Finding& finding : findings)
        told.push_back({finding, in_words(docket.scene, finding),
                        explain_command_for(docket, candidate, finding.x, finding.y)});
    return told;
}

/// The options that name candidate and reference, where they are not the usual ones.
std::string party_options(const Docket& docket, const RendererChoice& candidate) {
    std::string options = options_for(candidate);
    if (const auto* stored = std::get_if<StoredFrame>(&docket.parties.reference.who))
        options += " --reference " + shell_quoted(stored->file.string());
    if (const std::string& word = docket.parties.reference.precision_word; !word.empty())
        options += " --reference-precision " + shell_quoted(word);
    return options;
}

}  // namespace

std::string explain_command_for(const Docket& docket, const RendererChoice& candidate, int x, int y) {
    std::string command = "zproof explain " + shell_quoted(word_for(docket.source)) + " " +
                          std::to_string(x) + " " + std::to_string(y) + " --view " +
                          shell_quoted(docket.view.name) + party_options(docket, candidate);
    const Resolution size{docket.view.width, docket.view.height};
    if (docket.source.kind == SceneSource::Kind::view_file || size == default_resolution) return command;
    return command + " --width " + std::to_string(size.width) + " --height " + std::to_string(size.height);
}

ViewResult to_view_result(const Docket& docket, const Verdict& verdict) {
    ViewResult result = unjudged(docket.source, Outcome::proven, "");
    if (defect_count(verdict) > 0) result.outcome = Outcome::defective;
    result.view = docket.view.name;
    result.width = docket.view.width;
    result.height = docket.view.height;
    result.triangles = docket.scene.triangles.size();
    result.candidate = name_of(docket.parties.candidate);
    result.reference = name_of(docket.parties.reference);
    result.counts = verdict.counts;
    result.candidate_depth = verdict.candidate_depth;
    result.reference_depth = verdict.reference_depth;
    result.candidate_edges = verdict.candidate_edges;
    result.reference_edges = verdict.reference_edges;
    result.reference_defects = verdict.reference_defects;
    result.adjudicated = verdict.adjudicated;
    result.exact = verdict.exact;
    result.notes = docket.scene.notes;
    result.worst =
        stories(docket, docket.parties.candidate, worst_of(verdict.findings, most_reported_findings));
    return result;
}

WitnessResult to_witness_result(const Docket& docket, const RendererChoice& witness, const Verdict& verdict) {
    std::vector<Finding> defects = verdict.findings;
    std::erase_if(defects, [](const Finding& finding) { return passes(finding.verdict); });
    return {.name = name_of(witness),
            .absent = "",
            .counts = verdict.counts,
            .depth = verdict.candidate_depth,
            .edges = verdict.candidate_edges,
            .worst = stories(docket, witness, worst_of(std::move(defects), most_reported_of_witness))};
}

ViewResult unjudged(const SceneSource& source, Outcome outcome, const std::string& message) {
    ViewResult result;
    result.scene = source.name;
    result.source = source.origin;
    result.reason = source.reason;
    result.outcome = outcome;
    result.message = message;
    return result;
}

}  // namespace zproof
