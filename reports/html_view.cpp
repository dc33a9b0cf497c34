#include <algorithm>
#include <cmath>

#include "reports/diagnosis_words.h"
#include "reports/html_parts.h"
#include "reports/wording.h"

namespace zproof {

namespace {

constexpr std::size_t defects_shown = 20, close_calls_shown = 5;
constexpr int sharp_side = 240;  // pictures up to this side are enlarged, pixel for pixel

std::string cell(std::string_view kind, const std::string& content) {
    return "<td" + (kind.empty() ? std::string() : " class=\"" + std::string(kind) + "\"") + ">" + content +
           "</td>";
}

std::string code(const std::string& text) { return "<code>" + escaped(text) + "</code>"; }

std::string file_link(const ViewResult& v, const std::string& file) {
    return "<a href=\"" + as_url(v.folder + "/" + file) + "\">" + escaped(file) + "</a>";
}

std::string paragraph(std::string_view kind, const std::string& text) {
    return text.empty() ? "" : "<p class=\"" + std::string(kind) + "\">" + escaped(text) + "</p>\n";
}

std::string facts(const ViewResult& v) {
    std::string text = escaped(v.source);
    if (!v.candidate.empty()) text += " · " + escaped(v.candidate) + " against " + escaped(v.reference);
    if (v.width > 0) text += " · " + std::to_string(v.width) + " × " + std::to_string(v.height) + " pixels";
    if (v.triangles > 0) text += " · " + counted(v.triangles, "triangle");
    if (!v.command.empty()) text += "<br>" + code(v.command);
    return "<p class=\"facts\">" + text + "</p>\n";
}

std::string figure(const ViewResult& v, const PagePicture& picture) {
    if (picture.data.empty() && !picture.left_out) return "";
    const std::string file = as_url(v.folder + "/" + picture.file);
    if (picture.left_out)
        return "<figure><p class=\"absent\">Left out to keep this page small.</p><figcaption><a href=\"" +
               file + "\">" + picture.caption + "</a></figcaption></figure>";
    const bool sharp = picture.name == "class" || std::max(v.width, v.height) <= sharp_side;
    return "<figure><a href=\"" + file + "\"><img" + (sharp ? " class=\"sharp\"" : "") + " alt=\"" +
           picture.caption + "\" src=\"" + picture.data + "\"></a><figcaption>" + picture.caption +
           "</figcaption></figure>";
}

/// The pictures from first up to last, in a row.
std::string figures(const PageView& page, std::size_t first, std::size_t last) {
    std::string text;
    for (std::size_t i = first; i < std::min(last, page.pictures.size()); ++i)
        text += figure(*page.view, page.pictures[i]);
    return text;
}

/// What the candidate saw; of a view without evidence the picture of its card, which a script copies here.
std::string first_figure(const PageView& page) {
    const std::string large = figures(page, 0, 1);
    return large.empty() && !page.view->folder.empty() ? "<figure class=\"of-card\"></figure>" : large;
}

std::string count_row(PixelClass c, std::uint64_t count, std::uint64_t waived) {
    const std::string word = passes(c)         ? "admissible"
                             : !is_defect(c)   ? "undecidable"
                             : waived == 0     ? "<strong>defect</strong>"
                             : waived == count ? "defect, waived"
                                               : "<strong>defect</strong>, " + grouped(waived) + " waived";
    return "<tr>" + cell("", class_badge(c)) + cell("n", grouped(count)) + cell("gate", word) + "</tr>\n";
}

/// What each waiver that names the view did about it.
std::string waiver_lines(const ViewResult& v) {
    std::string items;
    for (const WaiverUse& use : v.waivers)
        items += "<li>" + code(use.id) + " (" + std::string(name_of(use.effect)) +
                 "): " + counted(use.matched, "pixel") + " fit, " + grouped(use.waived) + " let pass</li>\n";
    return items.empty() ? "" : "<h3>Waivers</h3><ul>" + items + "</ul>";
}

std::string class_table(const ViewResult& v) {
    std::string rows;
    for (std::size_t i = 0; i < v.counts.size(); ++i)
        if (v.counts[i] > 0) rows += count_row(PixelClass(i), v.counts[i], v.waived[i]);
    return "<div><h3>Pixels by class</h3><table class=\"counts\">" + rows + "</table>" +
           "<p class=\"fine\">" + grouped(v.adjudicated) + " needed the admissible set, " + grouped(v.exact) +
           " of them exact rationals; " + counted(v.reference_defects, "pixel") +
           " where the reference's own answer is impossible.</p>" + waiver_lines(v) + "</div>\n";
}

std::string explanation_row(const Explanation& e, const Diagnosis& d) {
    const std::string broken = e.contradicted > 0
                                   ? "; but " + grouped(e.contradicted) + " of " + grouped(e.checked) +
                                         " pixels that agree would be wrong"
                                   : "";
    return "<li><strong>" + escaped(e.name) + "</strong>: " + extent_of(e, d) + broken +
           ". <span class=\"fine\">" + escaped(e.description + (e.look_at.empty() ? "" : " " + e.look_at)) +
           "</span></li>\n";
}

std::string diagnosis(const ViewResult& v) {
    if (!v.diagnosis) return "";
    const Diagnosis& d = *v.diagnosis;
    std::string cause =
        d.cause
            ? "<ul>" + explanation_row(*d.cause, d) + "</ul>\n"
            : "<p>No hypothesis explains enough of the defects with nothing that speaks against it.</p>\n";
    std::string rest;
    for (const Explanation& e : d.further) rest += explanation_row(e, d);
    if (!rest.empty()) cause += "<p>Of the defects that it leaves:</p>\n<ul>" + rest + "</ul>\n";
    rest.clear();
    for (const Explanation& e : d.runners_up) rest += explanation_row(e, d);
    if (!rest.empty())
        rest = "<p class=\"fine\">Also tested, and explaining some:</p>\n<ul>" + rest + "</ul>\n";
    return "<h3>" + std::string(d.cause ? "Likely cause" : "No single cause") + "</h3>\n" + cause + rest;
}

std::string histogram(std::string_view what, const std::string& renderer, const BoundRecord& record) {
    const std::string bars = record.histogram == BoundHistogram{} ? "" : histogram_svg(what, record);
    return "<div><h3>" + std::string(what) + "</h3>" + bars + "<p class=\"fine\">" + escaped(renderer) +
           ": at most " + rounded(record.max_error_over_bound) + " times the bound.</p></div>\n";
}

std::string histograms(const ViewResult& v) {
    return histogram("Depth error / bound, candidate", v.candidate, v.candidate_depth) +
           histogram("Depth error / bound, reference", v.reference, v.reference_depth) +
           histogram("Edge displacement / bound, candidate", v.candidate, v.candidate_edges) +
           histogram("Edge displacement / bound, reference", v.reference, v.reference_edges);
}

std::string depth_cell(const Answer& answer) {
    return id_text(answer.primitive) + "<br><span class=\"fine\" title=\"" + hex_bits(answer.camera_depth) +
           "\">" + (std::isnan(answer.camera_depth) ? "not a number" : shortest(answer.camera_depth)) +
           "</span>";
}

/// The depth's error says nothing of a defect of the id, and would read like a pass.
bool says_of_depth(const Finding& f) {
    const bool id_is_wrong = is_defect(f.verdict) && f.verdict != PixelClass::wrong_depth &&
                             f.verdict != PixelClass::wrong_attribute;
    return !id_is_wrong && !std::isnan(f.error_over_bound);
}

std::string worst_row(const ReportedFinding& reported) {
    const Finding& f = reported.finding;
    return "<tr data-x=\"" + std::to_string(f.x) + "\" data-y=\"" + std::to_string(f.y) + "\">" +
           cell("n", std::to_string(f.x) + ", " + std::to_string(f.y)) + cell("", class_badge(f.verdict)) +
           cell("n", depth_cell(f.candidate)) + cell("n", depth_cell(f.reference)) +
           cell("n", says_of_depth(f) ? rounded(f.error_over_bound) : "–") +
           cell("words", escaped(reported.explanation) + "<br>" + code(reported.command) +
                             (reported.waiver.empty() ? "" : "<br>waived by " + code(reported.waiver))) +
           "</tr>\n";
}

std::size_t worst_shown(const ViewResult& v) {
    return std::min(v.worst.size(), defect_count(v) > 0 ? defects_shown : close_calls_shown);
}

std::string worst_remainder(const ViewResult& v) {
    std::string text;
    if (v.worst.size() > worst_shown(v))
        text = grouped(v.worst.size() - worst_shown(v)) + " more with their stories in results.json";
    if (!v.folder.empty())
        text += (text.empty() ? "E" : "; e") + ("very differing pixel in " + file_link(v, "findings.csv"));
    return text.empty() ? "" : "<p class=\"fine\">" + text + ".</p>\n";
}

std::string worst_table(const ViewResult& v) {
    if (v.worst.empty()) return "";
    std::string rows;
    for (std::size_t i = 0; i < worst_shown(v); ++i) rows += worst_row(v.worst[i]);
    return "<h3>" + std::string(defect_count(v) > 0 ? "Worst pixels" : "Closest calls") +
           "</h3>\n<div class=\"wide\"><table class=\"worst sortable\"><thead><tr><th class=\"n\">x, "
           "y</th>"
           "<th>class</th><th class=\"n\">candidate<br>id, depth</th><th class=\"n\">reference<br>id, "
           "depth</th>"
           "<th class=\"n\">error /<br>bound</th><th>why</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div>\n" + worst_remainder(v);
}

std::string notes(const ViewResult& v) {
    std::string items;
    for (const std::string& note : v.notes) items += "<li>" + escaped(note) + "</li>";
    return items.empty() ? "" : "<ul class=\"notes\">" + items + "</ul>\n";
}

std::string stage(std::string_view name, double time) {
    return "<span>" + std::string(name) + " " + fixed(time, 2) + " s</span>";
}

std::string stages(const StageTimes& t) {
    return "<p class=\"fine stages\">" + stage("load", t.load) + stage("render", t.render) +
           stage("reference build", t.reference_build) + stage("reference", t.reference) +
           stage("judge", t.judge) + stage("oracles", t.oracles) + stage("write", t.write) +
           stage("in all", seconds(t)) + "</p>\n";
}

std::string row(std::string_view kind, const std::string& content) {
    return content.empty() ? "" : "<div class=\"" + std::string(kind) + "\">" + content + "</div>\n";
}

/// A view that left no frames says so.
std::string without_evidence(const PageView& page) {
    const bool has_frames = std::ranges::any_of(
        page.pictures, [](const PagePicture& picture) { return picture.left_out || !picture.data.empty(); });
    return has_frames ? "" : paragraph("fine", "Its frames were not kept; --evidence all keeps them.");
}

std::string judgement(const PageView& page) {
    const ViewResult& v = *page.view;
    if (!was_judged(v)) return "";
    return row("diagnosis", diagnosis(v)) + without_evidence(page) +
           row("map", first_figure(page) + class_table(v)) +
           row("figures", figures(page, 1, page.pictures.size())) + row("panels", histograms(v)) +
           row("panels", html_oracles(v)) + worst_table(v);
}

}  // namespace

std::string class_badge(PixelClass c) {
    return "<span class=\"class\"><i class=\"c" + std::to_string(int(c)) + "\" aria-hidden=\"true\">" +
           escaped(facts_of(c).glyph) + "</i>" + std::string(name_of(c)) + "</span>";
}

std::string outcome_badge(Outcome outcome) {
    return "<span class=\"outcome " + std::string(name_of(outcome)) + "\">" + std::string(glyph_of(outcome)) +
           " " + std::string(in_words(outcome)) + "</span>";
}

std::string html_view(const PageView& page, Folded folded) {
    const ViewResult& v = *page.view;
    const std::string open = folded == Folded::yes ? "" : " open";
    return "<section id=\"" + page.anchor + "\">\n<details" + open + "><summary><h2>" + escaped(v.scene) +
           " <span class=\"view\">" + escaped(v.view) + "</span> " + outcome_badge(v.outcome) +
           "</h2></summary>\n" + paragraph("reason", v.reason) + paragraph("message", v.message) + facts(v) +
           notes(v) + judgement(page) + stages(v.times) + "</details></section>\n";
}

}  // namespace zproof
