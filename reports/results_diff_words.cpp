#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/results_diff.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t pixels_named = 5;

std::string verdict_on(const ViewChange& c) {
    if (is_worse(c)) return "worse";
    return is_any_different(c) ? "changed" : "same";
}

std::string outcome_of(const ViewResult* v, std::string_view otherwise) {
    return v == nullptr ? std::string(otherwise) : std::string(name_of(v->outcome));
}

std::string outcomes(const ViewChange& c) {
    const std::string before = outcome_of(c.before, "new"), after = outcome_of(c.after, "gone");
    return before == after ? after : before + " -> " + after;
}

std::string signed_text(std::uint64_t before, std::uint64_t after) {
    return after >= before ? "+" + grouped(after - before) : "-" + grouped(before - after);
}

std::string count_changes(const ViewChange& c) {
    if (c.before == nullptr || c.after == nullptr) return "";
    std::string text;
    for (std::size_t i = c.before->counts.size(); i-- > 0;)
        if (c.before->counts[i] != c.after->counts[i])
            text += "  " + std::string(name_of(PixelClass(i))) + " " +
                    signed_text(c.before->counts[i], c.after->counts[i]);
    if (waived_count(*c.before) != waived_count(*c.after))
        text += "  waived " + signed_text(waived_count(*c.before), waived_count(*c.after));
    return text;
}

std::string pixel_line(std::string_view what, const std::optional<std::vector<DefectPixel>>& pixels) {
    if (!pixels || pixels->empty()) return "";
    std::string text = "    " + counted(pixels->size(), std::string(what) + " defect") + ":";
    for (std::size_t i = 0; i < std::min(pixels_named, pixels->size()); ++i)
        text += " (" + std::to_string((*pixels)[i].x) + ", " + std::to_string((*pixels)[i].y) + ") " +
                std::string(name_of((*pixels)[i].verdict));
    return text + (pixels->size() > pixels_named ? " ..." : "") + "\n";
}

std::string who(const Results& r) {
    std::string text = "zproof " + r.version + ", " + r.embree;
    for (const RendererFacts& facts : r.renderers)
        if (title_of(facts) != r.embree) text += "; " + title_of(facts);
    return one_line(text);
}

Json pixels(const std::optional<std::vector<DefectPixel>>& list) {
    if (!list) return nullptr;
    Json all = Json::array();
    for (const DefectPixel& p : *list) all.push_back({{"x", p.x}, {"y", p.y}, {"class", name_of(p.verdict)}});
    return all;
}

Json one_side(const ViewResult* v) {
    if (v == nullptr) return nullptr;
    Json counts = Json::object();
    for (std::size_t i = 0; i < v->counts.size(); ++i)
        counts[std::string(name_of(PixelClass(i)))] = v->counts[i];
    return {{"outcome", name_of(v->outcome)},
            {"defects", defect_count(*v)},
            {"waived", waived_count(*v)},
            {"counts", counts}};
}

Json run_of(const Results& r) {
    Json renderers = Json::array();
    for (const RendererFacts& facts : r.renderers)
        renderers.push_back({{"name", facts.name}, {"version", facts.version}});
    return {{"version", r.version}, {"embree", r.embree}, {"renderers", renderers}};
}

}  // namespace

std::string differences_table(const Results& before, const Results& after,
                              const std::vector<ViewChange>& changes) {
    std::string text;
    if (who(before) != who(after)) text = "before: " + who(before) + "\nafter:  " + who(after) + "\n";
    for (const ViewChange& c : changes) {
        if (!is_any_different(c)) continue;
        text += (is_worse(c) ? "worse    " : "changed  ") + one_line(c.scene) +
                (c.view.empty() ? "" : "/" + one_line(c.view)) + "  " + outcomes(c) + count_changes(c) +
                "\n" + pixel_line("new", c.appeared) + pixel_line("fixed", c.gone);
    }
    const auto worse = std::ranges::count_if(changes, is_worse);
    const auto different = std::ranges::count_if(changes, is_any_different);
    return text + counted(changes.size(), "view") + ": " +
           grouped(changes.size() - std::uint64_t(different)) + " the same, " +
           grouped(std::uint64_t(different - worse)) + " changed and not worse, " +
           grouped(std::uint64_t(worse)) + " worse\n";
}

std::string differences_json(const Results& before, const Results& after,
                             const std::vector<ViewChange>& changes) {
    Json views = Json::array();
    for (const ViewChange& c : changes)
        views.push_back({{"scene", c.scene},
                         {"view", c.view},
                         {"verdict", verdict_on(c)},
                         {"before", one_side(c.before)},
                         {"after", one_side(c.after)},
                         {"new_defects", pixels(c.appeared)},
                         {"fixed_defects", pixels(c.gone)}});
    const Json root = {{"schema_version", "1.0"},
                       {"worse", std::ranges::count_if(changes, is_worse) > 0},
                       {"before", run_of(before)},
                       {"after", run_of(after)},
                       {"views", views}};
    return root.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace zproof
