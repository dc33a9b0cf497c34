#include "filters/report/plots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/study/claims.h"
#include "reports/pages/chart.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study;

/// Views taken together, method by method.
class Pool {
  public:
    Pool(const StudyResults& results, std::vector<const ViewStudy*> views)
        : results_(results), views_(std::move(views)) {}

    /// Root of the mean square over all pixels of the region; NaN where there are none.
    double rmse(const std::string& label, const std::string& region) const {
        double squares = 0, pixels = 0;
        for (const MethodScore* method : scores(label)) {
            const RegionScore* const score = find_score(*method, region);
            if (score == nullptr || score->pixels == 0) continue;
            const double value = score->values.at(metric_index(results_, "rmse"));
            squares += value * value * double(score->pixels);
            pixels += double(score->pixels);
        }
        return pixels == 0 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(squares / pixels);
    }

    /// Pixels of the region in all views; of a method, as all have the same.
    std::uint64_t pixels(const std::string& region) const {
        std::uint64_t sum = 0;
        for (const ViewStudy* view : views_) {
            const RegionScore* const score =
                view->methods.empty() ? nullptr : find_score(view->methods.front(), region);
            sum += score == nullptr ? 0 : score->pixels;
        }
        return sum;
    }

    double texels(const std::string& label) const {
        const auto found = scores(label);
        double sum = 0;
        for (const MethodScore* method : found) sum += method->cost.texels;
        return sum / double(found.size());
    }

    const StudyResults& results() const { return results_; }

  private:
    std::vector<const MethodScore*> scores(const std::string& label) const {
        std::vector<const MethodScore*> found;
        for (const ViewStudy* view : views_) {
            const auto method = std::ranges::find(view->methods, label, &MethodScore::label);
            if (method != view->methods.end()) found.push_back(&*method);
        }
        return found;
    }

    const StudyResults& results_;
    std::vector<const ViewStudy*> views_;
};

struct MethodPoint {
    std::string label;
    double cost, error;
};

std::vector<MethodPoint> method_points(const Pool& pool) {
    std::vector<MethodPoint> all;
    for (const MethodCard& card : pool.results().methods)
        all.push_back({card.label, pool.texels(card.label), pool.rmse(card.label, "interior")});
    std::erase_if(all,
                  [](const MethodPoint& s) { return !std::isfinite(s.cost) || !std::isfinite(s.error); });
    return all;
}

/// Those that nobody beats in both, by rising cost.
std::vector<MethodPoint> front_of(std::vector<MethodPoint> all) {
    std::ranges::stable_sort(all, [](const MethodPoint& a, const MethodPoint& b) {
        return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
    });
    std::vector<MethodPoint> front;
    for (const MethodPoint& s : all)
        if (front.empty() || s.error < front.back().error) front.push_back(s);
    return front;
}

/// Who is drawn in colour.
std::vector<std::string> stars(const Pool& pool, const std::vector<std::string>& wished) {
    if (!wished.empty()) return wished;
    std::vector<std::string> labels;
    for (const MethodPoint& s : front_of(method_points(pool))) labels.push_back(s.label);
    if (labels.size() >= 4) return labels;
    labels.clear();
    for (const MethodCard& card : pool.results().methods) labels.push_back(card.label);
    return labels;
}

bool is_among(const std::vector<std::string>& labels, const std::string& label) {
    return std::ranges::find(labels, label) != labels.end();
}

std::string titled(const std::string& what, const std::string& where) {
    return where.empty() ? what : what + " - " + where;
}

Plot pareto(const Pool& pool, const std::string& where) {
    const std::vector<MethodPoint> all = method_points(pool);
    Series front{.name = "", .points = {}, .style = SeriesStyle::quiet, .joining = Joining::steps};
    std::vector<std::string> unbeaten;
    for (const MethodPoint& s : front_of(all)) {
        front.points.emplace_back(s.cost, s.error);
        unbeaten.push_back(s.label);
    }
    Chart chart{.title = titled("Cost and error", where),
                .x = {"texels read per pixel", Scale::logarithmic, {}},
                .y = {"RMSE against GT-" + pool.results().truth + ", interior", Scale::logarithmic, {}},
                .series = {front}};
    const SeriesStyle others = all.size() <= names_beside ? SeriesStyle::muted : SeriesStyle::quiet;
    for (const MethodPoint& s : all)
        chart.series.push_back({s.label,
                                {{s.cost, s.error}},
                                is_among(unbeaten, s.label) ? SeriesStyle::marked : others,
                                Joining::points});
    return {"pareto",
            "What a method reads, and how far it is off. The line joins those that no other beats in both.",
            chart_svg(chart)};
}

/// Few pixels are drawn weakly: by the logarithm of their number, from 0.15 for none to 1 for the most.
std::vector<double> strengths_of(const std::vector<std::uint64_t>& pixels) {
    const double most = std::log1p(double(std::ranges::max(pixels)));
    std::vector<double> strengths;
    for (const std::uint64_t n : pixels)
        strengths.push_back(most > 0 ? 0.15 + 0.85 * std::log1p(double(n)) / most : 1);
    return strengths;
}

/// RMSE over the regions whose name begins so, in their order.
Chart by_region(const Pool& pool, const std::string& prefix, const std::vector<std::string>& stars) {
    std::vector<std::string> regions;
    std::vector<std::uint64_t> pixels;
    Chart chart{.title = {},
                .x = {},
                .y = {"RMSE against GT-" + pool.results().truth, Scale::logarithmic, {}},
                .series = {}};
    for (const RegionCard& card : pool.results().regions) {
        if (!card.name.starts_with(prefix)) continue;
        regions.push_back(card.name);
        chart.x.names.push_back(card.name.substr(prefix.size()));
        pixels.push_back(pool.pixels(card.name));
        chart.x.notes.push_back("n " + grouped(pixels.back()));
    }
    if (!pixels.empty()) chart.x.strengths = strengths_of(pixels);
    for (const MethodCard& card : pool.results().methods) {
        Series series{card.label,
                      {},
                      is_among(stars, card.label) ? SeriesStyle::marked : SeriesStyle::quiet,
                      Joining::line};
        for (std::size_t i = 0; i < regions.size(); ++i)
            series.points.emplace_back(double(i), pool.rmse(card.label, regions[i]));
        chart.series.push_back(std::move(series));
    }
    return chart;
}

std::vector<Plot> plots(const Pool& pool, const std::string& where, const std::vector<std::string>& labels) {
    const std::vector<std::string> coloured = stars(pool, labels);
    Chart anisotropy = by_region(pool, "anisotropy ", coloured), angle = by_region(pool, "angle ", coloured);
    anisotropy.title = titled("Error by anisotropy", where);
    anisotropy.x.title = "major / minor axis of the pixel's ellipse on the texture";
    angle.title = titled("Error by angle", where);
    angle.x.title = "degrees between major axis and texture axis u, anisotropy 2 and more";
    return {pareto(pool, where),
            {"anisotropy",
             "Where a method fails: by how long the pixel's footprint is. n: pixels; few are drawn weakly.",
             chart_svg(anisotropy)},
            {"angle", "Whether a method minds how the texture is turned. n: pixels; few are drawn weakly.",
             chart_svg(angle)}};
}

}  // namespace

std::vector<Plot> filters_plots(const StudyResults& results, const std::vector<std::string>& labels) {
    std::vector<const ViewStudy*> views;
    for (const ViewStudy& view : results.views) views.push_back(&view);
    return plots(Pool{results, views}, results.views.size() == 1 ? results.views[0].scene : "all views",
                 labels);
}

std::vector<Plot> filters_plots(const StudyResults& results, const ViewStudy& view,
                                const std::vector<std::string>& labels) {
    return plots(Pool{results, {&view}}, view.scene + " / " + view.view, labels);
}

}  // namespace zproof
