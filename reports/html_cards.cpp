// The answer, and the views as pictures.
#include <algorithm>

#include "reports/html_parts.h"
#include "reports/run_causes.h"
#include "reports/wording.h"

namespace zproof {

namespace {

/// The first failed view's worst pixel: where a reader goes on.
std::string next_step(const Results& results) {
    for (const ViewResult* view : failed_first(results))
        if (view->outcome == Outcome::defective && !view->worst.empty())
            return "<p>Begin with <code>" + escaped(view->worst.front().command) + "</code></p>\n";
    return "";
}

std::string other_causes(const std::vector<RunCause>& causes) {
    std::string items;
    for (std::size_t i = 1; i < causes.size(); ++i)
        items += (items.empty() ? "" : "; ") + escaped(causes[i].name) + " (" +
                 counted(causes[i].views, "view") + ")";
    return items.empty() ? "" : "<p class=\"fine\">Of others: " + items + ".</p>\n";
}

/// The tally; of a view with defects, theirs alone.
std::string differences(const ViewResult& v) {
    ClassCounts counts = v.counts;
    for (std::size_t i = 0; defect_count(v) > 0 && i < counts.size(); ++i)
        if (!is_defect(PixelClass(i))) counts[i] = 0;
    return tally(counts);
}

std::string card_picture(const PageView& page) {
    return page.picture.empty() ? "" : "<img alt=\"\" src=\"" + page.picture + "\">";
}

std::string likely_cause(const ViewResult& v) {
    if (!v.diagnosis || !v.diagnosis->cause) return "";
    return "<span>" + escaped(one_line(v.diagnosis->cause->name)) + "</span>";
}

std::string card(const PageView& page) {
    const ViewResult& v = *page.view;
    return "<a class=\"card\" href=\"#" + page.anchor + "\">" + card_picture(page) + "<span class=\"name\">" +
           escaped(v.scene) + " <span class=\"view\">" + escaped(v.view) + "</span></span>" +
           outcome_badge(v.outcome) + "<span class=\"fine\">" +
           (was_judged(v) ? differences(v) : escaped(one_line(v.message))) + "</span>" + likely_cause(v) +
           "</a>\n";
}

/// What the rings of the run's pictures mean; empty where there is none.
std::string ring_legend(std::span<const PageView> pages) {
    if (std::ranges::all_of(pages, &std::string::empty, &PageView::picture)) return "";
    ClassCounts all{};
    for (const PageView& page : pages)
        for (std::size_t i = 0; i < all.size(); ++i) all[i] += page.view->counts[i];
    std::string badges;
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i] > 0) badges += " " + class_badge(PixelClass(i));
    return "What the renderer saw, shaded by zproof" +
           (badges.empty() ? "."
                           : ". A ring surrounds pixels that differ; its colour is their class:" + badges);
}

/// Why some have no picture.
std::string without_pictures(std::span<const PageView> pages) {
    const auto left_no_frames = [](const PageView& page) {
        return was_judged(*page.view) && page.view->folder.empty();
    };
    if (std::ranges::none_of(pages, left_no_frames)) return "";
    return " Views without a picture left no frames; --evidence all keeps them.";
}

}  // namespace

std::string html_answer(const Results& results) {
    const std::vector<RunCause> causes = run_causes(results);
    const std::string words = cause_in_words(results);
    return (words.empty() ? "" : "<p class=\"cause\">" + escaped(words) + "</p>\n") + other_causes(causes) +
           next_step(results);
}

std::string html_cards(std::span<const PageView> pages) {
    if (pages.empty()) return "";
    std::string cards;
    for (const PageView& page : pages) cards += card(page);
    return "<p class=\"fine rings\">" + ring_legend(pages) + without_pictures(pages) +
           "</p>\n<div id=\"cards\" class=\"cards\">\n" + cards + "</div>\n";
}

}  // namespace zproof
