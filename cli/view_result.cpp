#include "cli/view_result.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "cli/arguments.h"
#include "compare/explanation/explain.h"
#include "frame/number_text.h"
#include "program/samples.h"
#include "program/shell_line.h"

namespace zproof {
namespace {

constexpr std::size_t most_reported_findings = 200, most_reported_of_oracle = 20;

/// A finding, and the waiver that lets it pass.
struct Ranked {
    const Finding* finding;
    std::string waiver;  ///< its id; empty: none

    /// Defects, then waived defects, then admissible differences.
    int grade() const { return passes(finding->verdict) ? 2 : waiver.empty() ? 0 : 1; }
    /// The ratio of what makes it a defect. A NaN comes last.
    double ratio() const {
        const auto& wrong = finding->wrong_attribute;
        const double error = wrong ? wrong->error_over_bound : finding->error_over_bound;
        return std::isnan(error) ? -1 : error;
    }
};

/// Orders by grade, then by the larger error/bound, then by raster order.
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
std::vector<ReportedFinding> stories(const ViewContext& context, const RendererChoice& candidate,
                                     const std::vector<Ranked>& findings) {
    std::vector<ReportedFinding> told;
    for (const auto& [finding, waiver] : findings)
        told.push_back({*finding, in_words(context.scene, *finding),
                        explain_command_for(context, candidate, finding->x, finding->y), waiver});
    return told;
}

/// Puts the findings to the waivers: counts, uses, and the findings as they rank.
std::vector<Ranked> hold_to_waivers(const ViewContext& context, std::span<const Finding> findings,
                                    const Gate& gate, ViewResult& result) {
    WaiverCoverage coverage = cover(gate.waivers,
                                    {.scene = context.source.name,
                                     .view = shown_name(context.view),
                                     .scene_sha256 = context.scene_sha256,
                                     .size = {context.view.width, context.view.height}},
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
std::string renderer_options(const ViewContext& context, const RendererChoice& candidate) {
    const Sample& sample = context.view.sample;
    std::string options = options_for(at_sample(candidate, sample));
    if (const std::string word = sample_word(sample); !word.empty()) options += " --sample " + word;
    const RendererChoice reference = at_sample(context.renderers.reference, sample);
    if (const auto* stored = std::get_if<StoredFrame>(&reference.who))
        options += " --reference " + shell_quoted(stored->file.string());
    if (const std::string& word = reference.precision_word; !word.empty())
        options += " --reference-precision " + shell_quoted(word);
    const auto& [convention, channels] = reference.convention;
    if (!convention.empty()) options += " --reference-convention " + shell_quoted(convention);
    if (!channels.empty()) options += " --reference-channels " + shell_quoted(channels);
    return options;
}

/// " --width 64 --height 36"; empty for what is usual.
std::string size_options(Resolution size) {
    if (size == default_resolution) return "";
    return " --width " + std::to_string(size.width) + " --height " + std::to_string(size.height);
}

}  // namespace

std::string explain_command_for(const ViewContext& context, const RendererChoice& candidate, int x, int y) {
    std::string command = "zproof explain " + shell_quoted(word_for(context.source)) + " " +
                          std::to_string(x) + " " + std::to_string(y) + " --view " +
                          shell_quoted(context.view.name) + renderer_options(context, candidate);
    const bool is_view_file = context.source.kind == SceneSource::Kind::view_file;
    if (is_view_file && !context.source.models.empty())
        command += " --models " + shell_quoted(context.source.models.string());
    return states_its_size(context.source)
               ? command
               : command + size_options({context.view.width, context.view.height});
}

std::string judging_command_for(const SceneSource& source, const ChosenRenderers& renderers,
                                Resolution resolution, const std::string& typed) {
    if (std::holds_alternative<StoredFrame>(renderers.candidate.who)) return typed;
    std::string command = "zproof run " + shell_quoted(word_for(source)) + options_for(renderers.candidate) +
                          (states_its_size(source) ? "" : size_options(resolution));
    for (const OracleChoice& oracle : renderers.oracles)
        if (oracle.need == OracleChoice::Need::required) command += " --oracle " + name_of(oracle.renderer);
    return renderers.oracles.empty() ? command + " --oracle none" : command;
}

/// "14 pixels are undecidable at eps = 200 px: ...".
std::string undecidable_words(const Verdict& verdict) {
    double eps_px = 0;
    for (const Finding& finding : verdict.findings)
        if (finding.verdict == PixelClass::undecidable) eps_px = std::max(eps_px, finding.eps_px);
    std::ostringstream text;
    text
        << undecidable_count(verdict) << " pixels are undecidable at eps = " << std::setprecision(3) << eps_px
        << " px: so many triangles may be shown there that deciding would take too long. Declare a finer "
           "precision if the renderer has one; else move scene and eye to the origin, where float32 is finer";
    return text.str();
}

/// What stands beside the verdict on the page and in the terminal.
std::vector<std::string> notes_on(const ViewContext& context, const Verdict& verdict) {
    std::vector<std::string> notes = context.scene.notes;
    if (const std::string note = sample_note(context.view.sample); !note.empty()) notes.push_back(note);
    const auto add_open = [&](const std::string& what, std::uint64_t pixels) {
        if (pixels > 0)
            notes.push_back(what + " not judged at some pixels: " + grouped(pixels) + " of " +
                            grouped(verdict.classes.size().pixel_count()) +
                            ", where rounding may leave a triangle no area");
    };
    add_open("depths", verdict.open_depths);
    add_open("attributes", verdict.open_attributes);
    return notes;
}

ViewResult to_view_result(const ViewContext& context, const Verdict& verdict, std::span<const Finding> told,
                          const Gate& gate, const CandidateFrame& candidate) {
    ViewResult result = unjudged(context.source, Outcome::proven, "");
    result.scene_sha256 = context.scene_sha256;
    result.view = shown_name(context.view);
    result.width = context.view.width;
    result.height = context.view.height;
    result.triangles = context.scene.triangles.size();
    result.candidate = name_of(context.renderers.candidate);
    result.reference = name_of(context.renderers.reference);
    result.counts = verdict.counts;
    result.candidate_depth = verdict.candidate_depth;
    result.reference_depth = verdict.reference_depth;
    result.candidate_edges = verdict.candidate_edges;
    result.reference_edges = verdict.reference_edges;
    result.reference_defects = verdict.reference_defects;
    result.adjudicated = verdict.adjudicated;
    result.exact = verdict.exact;
    result.notes = notes_on(context, verdict);
    result.worst = stories(context, context.renderers.candidate,
                           worst_of(hold_to_waivers(context, told, gate, result), most_reported_findings));
    if (undecidable_count(verdict) > 0) {
        result.outcome = Outcome::undecided;
        result.message = undecidable_words(verdict);
    }
    for (ReportedFinding& reported : result.worst)
        reported.explanation += candidate.label_sentence(reported.finding.x, reported.finding.y);
    if (unwaived_defects(result) > 0) result.outcome = Outcome::defective;
    return result;
}

OracleResult to_oracle_result(const ViewContext& context, const RendererChoice& oracle,
                              const Verdict& verdict) {
    std::vector<Ranked> defects;
    for (const Finding& finding : verdict.findings)
        if (is_defect(finding.verdict)) defects.push_back({&finding, ""});
    return {.name = name_of(oracle),
            .absent = "",
            .counts = verdict.counts,
            .depth = verdict.candidate_depth,
            .edges = verdict.candidate_edges,
            .worst = stories(context, oracle, worst_of(std::move(defects), most_reported_of_oracle))};
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
