#include "reports/html.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reports/class_colour.h"
#include "reports/extent.h"
#include "reports/html_parts.h"
#include "reports/page_parts.h"
#include "reports/page_scripts.h"
#include "reports/pages/writers.h"
#include "reports/wording.h"

namespace zproof {

namespace {

constexpr std::size_t unfolded_views = 3;  // of those that are not proven
constexpr std::size_t room_for_remarks =
    10'000;  // on what is left out, and what it tells the viewer of classes

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

std::string legend_rows(const std::string& heading, std::initializer_list<GateEffect> effects) {
    std::string rows;
    for (int i = 0; i < pixel_class_count; ++i)
        if (const ClassFacts& facts = facts_of(PixelClass(i)); std::ranges::count(effects, facts.gate) > 0)
            rows +=
                "<dt>" + class_badge(PixelClass(i)) + "</dt><dd>" + std::string(facts.meaning) + "</dd>\n";
    return "<h3>" + heading + "</h3><dl>" + rows + "</dl>";
}

std::string legend() {
    return "<section class=\"legend\">\n<details><summary><h2>How to read this</h2></summary>\n"
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
           "the bound is loose, above 1 something is wrong.</p></div></div>\n</details></section>\n";
}

std::string head(const std::string& title) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
           content_policy(viewer_script()) +
           "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"color-scheme\" content=\"light dark\">\n<title>zproof: " +
           escaped(title) + "</title>\n<style>\n" + std::string(html_style()) + class_colours() +
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

/// How many bytes a page may still grow by.
class PageRoom {
  public:
    PageRoom(std::size_t budget, std::size_t taken) : left_(budget) { take(taken); }

    void take(std::size_t bytes) { left_ -= std::min(left_, bytes); }
    std::size_t left() const { return left_; }
    std::size_t half() const { return left_ / 2; }

  private:
    std::size_t left_;
};

/// What readers of a page must know that does not show all views at once; empty where it does.
std::string remark_on_length(std::size_t views, std::size_t listed, std::size_t with_section) {
    if (views <= views_in_markup) return "";
    std::string text =
        "<span class=\"without-scripts\">These are the first " + grouped(views_in_markup) + " of " +
        counted(views, "view") +
        ", failed ones first. Where scripts run, the table turns its pages over the others, and "
        "is searched and sorted as a whole.</span>";
    if (listed < views) text += " The table has the first " + grouped(listed) + " views alone.";
    if (with_section < views)
        text += " The first " + grouped(with_section) +
                " have a section below; those of the others were left out to keep this page small.";
    return "<p class=\"facts\" id=\"length\">" + text + " results.json has everything.</p>\n";
}

std::string sections_of(std::span<const PageView> views) {
    std::string text = "<div id=\"sections\">\n";
    for (std::size_t i = 0; i < views.size(); ++i)
        text += html_view(views[i], i < unfolded_views && views[i].view->outcome != Outcome::proven
                                        ? Folded::no
                                        : Folded::yes);
    return text + "</div>\n";
}

std::string study_section(const document::Document& study, const std::string& anchor) {
    std::string text = "<article id=\"" + anchor + "\">\n<h1>" + escaped(study.title) + "</h1>\n";
    for (const std::string& one : study.introduction)
        text += "<p class=\"reason\">" + escaped(one) + "</p>\n";
    return text + "<p class=\"facts\"><code>" + escaped(study.command) + "</code></p>\n" +
           document::page_sections(study, anchor + "-") + "</article>\n";
}

std::string studies_of(std::span<const document::Document> studies) {
    std::string text;
    for (std::size_t i = 0; i < studies.size(); ++i) text += study_section(studies[i], anchor_of_study(i));
    return text;
}

std::string foreword_of(const document::Document& foreword) {
    return "<header>\n" + study_section(foreword, "foreword") + "</header>\n";
}

}  // namespace

Page html_page(const Results& results, const std::filesystem::path& run_folder, std::size_t budget,
               std::span<const document::Document> studies, const document::Document* foreword) {
    std::vector<PageView> views = page_views(results, run_folder);
    const std::span<PageView> in_markup{views.data(), std::min(views.size(), views_in_markup)};
    const std::string script = script_element(viewer_script());
    std::string begin = head(foreword ? foreword->title : headline(results)) + "<body>\n" +
                        (foreword ? foreword_of(*foreword) : "") + "<header>\n<h1>" +
                        escaped(headline(results)) + "</h1>\n" + html_answer(results) + "</header>\n<main>\n";
    const std::string table = html_summary(in_markup);
    std::string middle = html_renderers(results) + legend() + links_to(studies),
                end = studies_of(studies) + provenance(results) + "</main>\n";
    PageRoom room{budget, begin.size() + table.size() + middle.size() + end.size() + script.size() +
                              room_for_remarks + html_cards(in_markup).size() +
                              sections_of(in_markup).size()};
    PackedViews facts = packed_facts(views, room.half());
    room.take(facts.bytes);
    PackedViews sections = packed_sections(std::span{views}.subspan(in_markup.size()), room.half());
    room.take(sections.bytes);
    room.take(take_pictures(in_markup, run_folder, std::min(room.half(), picture_budget(budget))));
    PackedViews pictures =
        packed_pictures(std::span{views}.subspan(in_markup.size()), run_folder, room.half());
    room.take(pictures.bytes);
    begin += html_cards(in_markup) + table;
    middle = sections_of(in_markup) + middle;
    PagePlanes planes = page_planes(results, views, run_folder, room.left());

    Page page;
    std::string remark = remark_on_length(views.size(), facts.views, in_markup.size() + sections.views);
    for (std::string* text : {&begin, &remark, &planes.omissions, &middle, &end})
        page.emplace_back(std::move(*text));
    for (PackedViews* packed : {&facts, &pictures, &sections})
        std::ranges::move(packed->elements, std::back_inserter(page));
    std::ranges::move(planes.elements, std::back_inserter(page));
    page.emplace_back(script + "</body>\n</html>\n");
    return page;
}

std::string to_html(const Results& results, const std::filesystem::path& run_folder, std::size_t budget,
                    std::span<const document::Document> studies, const document::Document* foreword) {
    return text_of(html_page(results, run_folder, budget, studies, foreword));
}

}  // namespace zproof
