#include "cli/view_result.h"

#include <algorithm>
#include <cmath>

#include "cli/arguments.h"
#include "compare/explain.h"

namespace zproof {
namespace {

constexpr std::size_t most_reported_findings = 200;

/// Defects before lawful differences, then the larger error/bound (NaN last), then raster order.
bool worse(const Finding& a, const Finding& b) {
    if (passes(a.verdict) != passes(b.verdict)) return passes(b.verdict);
    const auto ratio = [](const Finding& f) {
        return std::isnan(f.error_over_bound) ? -1 : f.error_over_bound;
    };
    if (ratio(a) != ratio(b)) return ratio(a) > ratio(b);
    return std::pair{a.y, a.x} < std::pair{b.y, b.x};
}

std::vector<Finding> worst_of(std::vector<Finding> findings) {
    const std::size_t count = std::min(findings.size(), most_reported_findings);
    std::ranges::partial_sort(findings, findings.begin() + std::ptrdiff_t(count), worse);
    findings.resize(count);
    return findings;
}

}  // namespace

std::string explain_command_for(const Docket& docket, int x, int y) {
    std::string command = "zproof explain " + shell_quoted(word_for(docket.source)) + " " +
                          std::to_string(x) + " " + std::to_string(y) + " --view " +
                          shell_quoted(docket.view.name);
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
    result.candidate = "zproof";
    result.reference = "embree";
    result.counts = verdict.counts;
    result.candidate_depth = verdict.candidate_depth;
    result.reference_depth = verdict.reference_depth;
    result.candidate_edges = verdict.candidate_edges;
    result.reference_edges = verdict.reference_edges;
    result.reference_defects = verdict.reference_defects;
    result.adjudicated = verdict.adjudicated;
    result.exact = verdict.exact;
    result.notes = docket.scene.notes;
    for (const Finding& finding : worst_of(verdict.findings))
        result.worst.push_back(
            {finding, in_words(docket.scene, finding), explain_command_for(docket, finding.x, finding.y)});
    return result;
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
