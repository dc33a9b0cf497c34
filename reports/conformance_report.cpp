#include "reports/conformance_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "reports/measurement_report.h"
#include "reports/wording.h"

namespace zproof {
namespace {

using document::Row;
using document::Table;

/// Verdicts; what is kept is none of the others.
constexpr const char *kept = "kept", *broken = "NOT KEPT", *not_promised = "not promised",
                     *not_asked = "not asked", *not_judged = "not judged";

Table promises(std::string name, std::string caption) {
    return {.name = std::move(name),
            .caption = std::move(caption),
            .columns = {{"asked", "", ""},
                        {"promise", "", "What is declared, or follows from it."},
                        {"figure", "", "What was found."},
                        {"verdict", "", "kept, NOT KEPT, not promised, not judged, or not asked."}},
            .rows = {}};
}

/// Those of the suite, or those that were drawn by chance.
std::vector<const ViewResult*> views_of(const Results& results, bool (*is_meant)(const ViewResult&)) {
    std::vector<const ViewResult*> views;
    for (const ViewResult& view : results.views)
        if (is_meant(view)) views.push_back(&view);
    return views;
}

bool is_of_suite(const ViewResult& view) { return view.source == "suite"; }
bool is_random(const ViewResult& view) { return !is_of_suite(view); }

std::uint64_t pixels_of(const std::vector<const ViewResult*>& views) {
    std::uint64_t pixels = 0;
    for (const ViewResult* view : views)
        for (const std::uint64_t count : view->counts) pixels += count;
    return pixels;
}

std::string visibility_verdict(const std::vector<const ViewResult*>& views) {
    const auto has = [&](Outcome outcome) {
        return std::ranges::any_of(views, [&](const ViewResult* v) { return v->outcome == outcome; });
    };
    if (has(Outcome::defective)) return broken;
    const bool all_proven =
        std::ranges::all_of(views, [](const ViewResult* v) { return v->outcome == Outcome::proven; });
    return all_proven && !views.empty() ? kept : not_judged;
}

Row visibility(const std::string& asked, const std::vector<const ViewResult*>& views) {
    std::uint64_t defects = 0;
    for (const ViewResult* view : views) defects += defect_count(*view);
    return {asked, std::string{"each pixel is admissible"},
            counted(views.size(), "view") + ", " + counted(pixels_of(views), "pixel") + ", " +
                counted(defects, "defect"),
            visibility_verdict(views)};
}

/// The row of a bound: the largest error / bound over the views, and whether no pixel is beyond it.
Row bound(const std::string& asked, const Results& results, BoundRecord ViewResult::*record,
          PixelClass beyond) {
    double largest = 0;
    std::uint64_t defects = 0, judged = 0;
    for (const ViewResult& view : results.views) {
        largest = std::max(largest, (view.*record).max_error_over_bound);
        defects += view.counts[std::size_t(beyond)];
        judged += was_judged(view);
    }
    const std::string figure = "largest error / bound " + with_digits(largest, 3) + ", " +
                               std::to_string(defects) + " " + std::string(name_of(beyond));
    return {asked, std::string{"error / bound <= 1"}, figure,
            std::string{judged == 0    ? not_judged
                        : defects == 0 ? kept
                                       : broken}};
}

Row attributes(const Results& results) {
    const std::string asked = "attributes", promise = "means of the corners' values, within their bound";
    std::set<std::string> names;
    std::uint64_t views = 0, wrong = 0;
    for (const ViewResult& view : results.views) {
        names.insert(view.attributes.begin(), view.attributes.end());
        views += !view.attributes.empty();
        wrong += view.counts[std::size_t(PixelClass::wrong_attribute)];
    }
    if (views == 0) return {asked, promise, std::string{"the frames have none"}, std::string{not_asked}};
    std::string figure;
    for (const std::string& name : names) figure += name + ", ";
    return {asked, promise, figure + counted(views, "view") + ", " + counted(wrong, "defect"),
            std::string{wrong == 0 ? kept : broken}};
}

std::string verdict_of(measure::Conformity conformity) {
    switch (conformity) {
        case measure::Conformity::as_declared:
            return kept;
        case measure::Conformity::worse:
            return broken;
        case measure::Conformity::undeclared:
            return not_promised;
    }
    return not_promised;
}

Table rasterization(const Results& results, const MeasuredPromises& measured) {
    Table table = promises("rasterization", "Which triangle each pixel shows, and at which depth");
    table.rows = {visibility("visibility, the suite", views_of(results, is_of_suite)),
                  visibility("visibility, random scenes", views_of(results, is_random))};
    for (const measure::Finding& finding : measured.findings)
        table.rows.push_back({finding.title, finding.declared, one_line(measured_in_words(finding)),
                              verdict_of(finding.conformity)});
    if (!measured.refusal.empty())
        table.rows.push_back({std::string{"grid, fill rule, watertightness, depth steps, clip"},
                              std::string{}, one_line(measured.refusal), std::string{not_judged}});
    return table;
}

Table interpolation(const Results& results) {
    Table table = promises("interpolation", "What lies between the corners of a triangle");
    table.rows = {bound("depth", results, &ViewResult::candidate_depth, PixelClass::wrong_depth),
                  attributes(results)};
    return table;
}

Row filter(const TexturePromise& texture) {
    const std::string asked = texture.filter + " filter";
    if (!texture.refusal.empty())
        return {asked, texture.promise, one_line(texture.refusal), std::string{not_judged}};
    return {asked, texture.promise,
            "largest error / bound " + with_digits(texture.error_over_bound, 3) + ", " +
                counted(texture.pixels, "pixel") + ", " + std::to_string(texture.outside) + " outside",
            std::string{texture.is_broken ? broken : kept}};
}

Table sampling(const std::vector<TexturePromise>& textures) {
    Table table = promises("sampling", "Textures");
    for (const TexturePromise& texture : textures) table.rows.push_back(filter(texture));
    if (textures.empty())
        table.rows = {{std::string{"texture filters"}, std::string{"a definition, at declared bits"},
                       std::string{"zproof filters check asks them"}, std::string{not_asked}}};
    return table;
}

std::size_t rows_with(const std::vector<const Table*>& tables, const std::string& verdict) {
    std::size_t rows = 0;
    for (const Table* table : tables)
        rows += std::size_t(std::ranges::count_if(
            table->rows, [&](const Row& row) { return std::get<std::string>(row.back()) == verdict; }));
    return rows;
}

std::string title_of(const std::string& renderer, const std::vector<const Table*>& tables) {
    const std::size_t wrong = rows_with(tables, broken), unknown = rows_with(tables, not_judged),
                      all = rows_with(tables, kept) + wrong + unknown;
    if (wrong > 0) return renderer + " breaks " + std::to_string(wrong) + " of " + counted(all, "promise");
    if (unknown > 0)
        return renderer + ": " + std::to_string(unknown) + " of " + counted(all, "promise") + " not judged";
    return renderer + " keeps " + (all == 1 ? "its promise" : "all " + counted(all, "promise"));
}

}  // namespace

void read_filter_check(TexturePromise& promise, const std::string& json) {
    const auto found = nlohmann::json::parse(json).at("pictures").at(0);
    promise.pixels = found.at("pixels");
    promise.outside = found.at("outside");
    promise.error_over_bound = found.at("slack");
    promise.is_broken = found.at("outcome") == "failed";
    if (found.at("outcome") == "nothing") promise.refusal = "nothing is proved";
}

document::Document conformance_document(const Results& results, const MeasuredPromises& measured) {
    const RendererFacts& device = results.renderers.front();
    const Table raster = rasterization(results, measured), between = interpolation(results),
                textures = sampling(measured.textures);
    return {
        .title = title_of(device.name, {&raster, &between, &textures}),
        .command = results.command,
        .version = results.version,
        .introduction = {title_of(device)},
        .sections = {
            {"Rasterization", {}, {raster}}, {"Interpolation", {}, {between}}, {"Sampling", {}, {textures}}}};
}

}  // namespace zproof
