#include "cli/view_result.h"

#include <algorithm>
#include <cmath>

#include "cli/arguments.h"
#include "compare/explanation/explain.h"

namespace zproof {
namespace {

constexpr std::size_t most_reported_findings = 200, most_reported_of_witness = 20;

/// A finding, and the waiver that lets it pass.
struct Ranked {
    const Finding* finding;
    std::string waiver;  ///< its id; empty: none

    /// Defects, then waived defects, then lawful differences.
    int grade() const { return passes(finding->verdict) ? 2 : waiver.empty() ? 0 : 1; }
    /// NaN last.
    double ratio() const { return std::isnan(finding->error_over_bound) ? -1 : finding->error_over_bound; }
};

/// By grade, then the larger error/bound, then raster order.
bool worse(const Ranked& a, const Ranked& b) {
    if (a.grade() != b.grade()) return a.grade() < b.grade();
    if (a.ratio() != b.ratio()) return a.ratio() > b.ratio();
    return std::pair{a.finding->y, a.finding->x} < std::pair{b.finding->y, b.finding->x};
}

std::vector<Ranked> worst_of(std::vector<Ranked> findings, std::size_t most) {
    const std::size_t count = std::min(findings.size(), most);
    std::ranges::partial_sort(findings, findings.begin() + std::ptrdiff_t(count), worse);
    findings.resize(count);
    return findings;
}

/// Each finding with its sentence and the command that tells more.
std::vector<ReportedFinding> stories(const Docket& docket, const RendererChoice& candidate,
                                     const std::vector<Ranked>& findings) {
    std::vector<ReportedFinding> told;
    for (const auto& [finding, waiver] : findings)
        told.push_back({*finding, in_words(docket.scene, *finding),
                        explain_command_for(docket, candidate, finding->x, finding->y), waiver});
    return told;
}

/// Puts the findings to the waivers: counts, uses, and the findings as they rank.
std::vector<Ranked> hold_to_waivers(const Docket& docket, std::span<const Finding> findings, const Gate& gate,
                                    ViewResult& result) {
    WaiverCoverage coverage = cover(gate.waivers,
                                    {.scene = docket.source.name,
                                     .view = docket.view.name,
                                     .scene_sha256 = docket.scene_sha256,
                                     .size = {docket.view.width, docket.view.height}},
                                    findings, gate.today);
    result.waivers = std::move(coverage.uses);
    std::vector<Ranked> ranked;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const auto by = coverage.by[i];
        if (by) ++result.waived[std::size_t(findings[i].verdict)];
        ranked.push_back({&findings[i], by ? gate.waivers[*by].id : ""});
    }
    return ranked;
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

ViewResult to_view_result(const Docket& docket, const Verdict& verdict, const Gate& gate) {
    ViewResult result = unjudged(docket.source, Outcome::proven, "");
    result.scene_sha256 = docket.scene_sha256;
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
        stories(docket, docket.parties.candidate,
                worst_of(hold_to_waivers(docket, verdict.findings, gate, result), most_reported_findings));
    if (unwaived_defects(result) > 0) result.outcome = Outcome::defective;
    return result;
}

WitnessResult to_witness_result(const Docket& docket, const RendererChoice& witness, const Verdict& verdict) {
    std::vector<Ranked> defects;
    for (const Finding& finding : verdict.findings)
        if (!passes(finding.verdict)) defects.push_back({&finding, ""});
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
    result.place = source.place;
    result.source = source.origin;
    result.reason = source.reason;
    result.outcome = outcome;
    result.message = message;
    return result;
}

}  // namespace zproof
