#include "reports/html.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reports/class_colour.h"
#include "reports/document/page.h"
#include "reports/extent.h"
#include "reports/html_parts.h"
#include "reports/page_parts.h"
#include "reports/page_scripts.h"
#include "reports/wording.h"

namespace zproof {

namespace {

constexpr std::size_t reserve_per_view = 2'000;  // for what the page says of it to the viewer

std::ptrdiff_t number_of(const Results& results, Outcome outcome) {
    return std::ranges::count(results.views, outcome, &ViewResult::outcome);
}

/// Ink that stands out from a ground; the weights are luma's (BT.601).
std::string_view ink_on(Rgb8 c) {
    return 299 * c.r + 587 * c.g + 114 * c.b > 110'000 ? "#16181c" : "#ffffff";
}

std::string class_colours() {
    std::string css;
    for (int i = 0; i < pixel_class_count; ++i) {
        const Rgb8 colour = colour_of(PixelClass(i));
        css += ".c" + std::to_string(i) + "{background:" + css_colour(colour) +
               ";color:" + std::string(ink_on(colour)) + "}\n";
    }
    return css;
}

/// The page in one sentence.
std::string headline(const Results& results) {
    const auto views = results.views.size();
    const auto proven = std::size_t(number_of(results, Outcome::proven));
    if (views == 0) return "No view was judged, so nothing is proven.";
    if (proven == views)
        return views == 1 ? "The view is proven." : "All " + std::to_string(views) + " views are proven.";
    std::string text;
    const auto add = [&](Outcome outcome) {
        const auto count = number_of(results, outcome);
        if (count > 0)
            text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(in_words(outcome));
    };
    for (const Outcome outcome : all_outcomes)
        if (outcome != Outcome::proven) add(outcome);
    return text + ", of " + in_words(extent_of(results)) + ".";
}

std::string provenance(const Results& r) {
    std::string text = "zproof " + escaped(r.version);
    if (!r.commit.empty()) text += " · commit " + escaped(r.commit);
    if (!r.embree.empty()) text += " · " + escaped(r.embree);
    if (!r.compiler.empty()) text += " · " + escaped(r.compiler);
    if (r.threads > 0) text += " · " + counted(std::uint64_t(r.threads), "thread");
    if (!r.isa.empty()) text += " · " + escaped(r.isa);
    return "<p class=\"facts\">" + text + "</p>\n" +
           (r.command.empty() ? "" : "<p class=\"facts\"><code>" + escaped(r.command) + "</code></p>\n");
}

std::string count_cell(const ViewResult& v, PixelClass c) {
    const std::uint64_t count = v.counts[std::size_t(c)];
    return "<td class=\"n" + std::string(count == 0 ? " zero" : "") + "\">" + grouped(count) + "</td>";
}

/// The columns of measured_cells(): two before the classes, three behind.
int measured_columns() {
    int columns = 5;
    for (int i = 0; i < pixel_class_count; ++i) columns += has_column(PixelClass(i));
    return columns;
}

std::string measured_cells(const ViewResult& v) {
    const std::uint64_t pixels = std::uint64_t(v.width) * std::uint64_t(v.height),
                        defects = unwaived_defects(v);
    std::string cells =
        "<td class=\"n\">" + grouped(v.triangles) + "</td><td class=\"n\">" + grouped(pixels) + "</td>";
    for (int i = 0; i < pixel_class_count; ++i)
        if (has_column(PixelClass(i))) cells += count_cell(v, PixelClass(i));
    return cells + "<td class=\"n defects" + (defects == 0 ? " zero" : "") + "\">" + grouped(defects) +
           (waived_count(v) == 0 ? "" : "<br>" + grouped(waived_count(v)) + " waived") +
           "</td><td class=\"n\">" + rounded(v.candidate_depth.max_error_over_bound) +
           "</td><td class=\"n\">" + rounded(v.reference_depth.max_error_over_bound) + "</td>";
}

std::string summary_row(const PageView& page) {
    const ViewResult& v = *page.view;
    return "<tr><td>" + outcome_badge(v.outcome) + "</td><td><a href=\"#" + page.anchor + "\">" +
           escaped(v.scene) + " <span class=\"view\">" + escaped(v.view) + "</span></a></td>" +
           (was_judged(v) ? measured_cells(v)
                          : "<td colspan=\"" + std::to_string(measured_columns()) + "\" class=\"message\">" +
                                escaped(v.message) + "</td>") +
           "<td class=\"n\">" + fixed(seconds(v.times), 2) + "</td></tr>\n";
}

/// The class's name, broken at each underscore.
std::string heading_of(PixelClass c) {
    std::string name;
    for (const char letter : name_of(c)) name += letter == '_' ? std::string("<br>") : std::string(1, letter);
    return "<th class=\"n\">" + name + "</th>";
}

std::string summary(const std::vector<PageView>& pages) {
    if (pages.empty()) return "";
    std::string rows;
    for (const PageView& page : pages) rows += summary_row(page);
    std::string classes;
    for (int i = 0; i < pixel_class_count; ++i)
        if (has_column(PixelClass(i))) classes += heading_of(PixelClass(i));
    classes += "<th class=\"n\">defects</th>";
    return "<div class=\"wide\"><table class=\"summary sortable\"><thead><tr><th>verdict</th><th>scene, "
           "view</th>"
           "<th class=\"n\">triangles</th><th class=\"n\">pixels</th>" +
           classes +
           "<th class=\"n\" title=\"largest depth error / bound, candidate\">error / bound,<br>candidate</th>"
           "<th class=\"n\" title=\"largest depth error / bound, reference\">error / bound,<br>reference</th>"
           "<th class=\"n\">seconds</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div>\n";
}

std::string legend_rows(const std::string& heading, std::initializer_list<GateEffect> effects) {
    std::string rows;
    for (int i = 0; i < pixel_class_count; ++i)
        if (const ClassFacts& facts = facts_of(PixelClass(i)); std::ranges::count(effects, facts.gate) > 0)
            rows +=
                "<dt>" + class_badge(PixelClass(i)) + "</dt><dd>" + std::string(facts.meaning) + "</dd>\n";
    return "<h3>" + heading + "</h3><dl>" + rows + "</dl>";
}

std::string legend() {
    return "<section class=\"legend\">\n<h2>How to read this</h2>\n"
           "<p>At every pixel centre the renderer under test, the <em>candidate</em>, and an independent "
           "<em>reference</em> name the triangle that they see and its depth. A pixel is a defect when no "
           "faultless "
           "renderer of the candidate's declared precision could have answered so. The bounds follow from "
           "that "
           "arithmetic; nothing is tuned. Each pixel gets one word:</p>\n"
           "<div class=\"columns\"><div>" +
           legend_rows("Admissible", {GateEffect::pass}) + legend_rows("Neither", {GateEffect::undecided}) +
           "</div><div>" + legend_rows("Defects", {GateEffect::fail, GateEffect::fail_always}) +
           "<p class=\"fine\">Depth error / bound: how much of the permitted depth error was used up. Near 0 "
           "the bound is loose, above 1 something is wrong.</p></div></div>\n</section>\n";
}

std::string head(const Results& results) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
           content_policy(viewer_script()) +
           "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"color-scheme\" content=\"light dark\">\n<title>zproof: " +
           escaped(headline(results)) + "</title>\n<style>\n" + std::string(html_style()) + class_colours() +
           std::string(document::page_style()) + std::string(viewer_style()) + "</style>\n</head>\n";
}

std::string anchor_of_study(std::size_t i) { return "study-" + std::to_string(i + 1); }

std::string links_to(std::span<const document::Document> studies) {
    if (studies.empty()) return "";
    std::string links;
    for (std::size_t i = 0; i < studies.size(); ++i)
        links += "<li><a href=\"#" + anchor_of_study(i) + "\">" + escaped(studies[i].title) + "</a></li>\n";
    return "<h2>Studies</h2>\n<ul>\n" + links + "</ul>\n";
}

std::string study_section(const document::Document& study, const std::string& anchor) {
    std::string text = "<article id=\"" + anchor + "\">\n<h1>" + escaped(study.title) + "</h1>\n";
    for (const std::string& one : study.introduction)
        text += "<p class=\"reason\">" + escaped(one) + "</p>\n";
    return text + "<p class=\"facts\"><code>" + escaped(study.command) + "</code></p>\n" +
           document::page_sections(study, anchor + "-") + "</article>\n";
}

}  // namespace

Page html_page(const Results& results, const std::filesystem::path& run_folder, std::size_t budget,
               std::span<const document::Document> studies) {
    const std::vector<PageView> pages = page_views(results, run_folder, picture_budget(budget));
    const std::string script = script_element(viewer_script());
    std::string sections;
    for (const PageView& one : pages) sections += html_view(one);
    for (std::size_t i = 0; i < studies.size(); ++i)
        sections += study_section(studies[i], anchor_of_study(i));
    std::string begin = head(results) + "<body>\n<header>\n<h1>" + escaped(headline(results)) + "</h1>\n" +
                        provenance(results) + "</header>\n<main>\n" + summary(pages) + links_to(studies);
    std::string end = html_renderers(results) + legend() + sections + "</main>\n";
    const std::size_t spent =
        begin.size() + end.size() + script.size() + (1 + pages.size()) * reserve_per_view;
    PagePlanes planes = page_planes(pages, run_folder, budget > spent ? budget - spent : 0);
    Page page;
    for (std::string* text : {&begin, &planes.omissions, &end}) page.emplace_back(std::move(*text));
    std::ranges::move(planes.elements, std::back_inserter(page));
    page.emplace_back(script + "</body>\n</html>\n");
    return page;
}

std::string to_html(const Results& results, const std::filesystem::path& run_folder, std::size_t budget,
                    std::span<const document::Document> studies) {
    return text_of(html_page(results, run_folder, budget, studies));
}

}  // namespace zproof
