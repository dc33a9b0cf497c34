#include "filters/report/pooled.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/report/provenance.h"
#include "filters/study/claims.h"
#include "frame/joined.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study;

const MetricCard& metric_of(const StudyResults& results, const PooledScores& pool) {
    return results.metrics.at(metric_index(results, pool.choice.metric));
}

std::string number(double value, int decimals) {
    if (std::isnan(value)) return "-";
    return std::isinf(value) ? shortest(value) : fixed(value, decimals);
}

std::string spread(const Spread& spread, int decimals) {
    if (std::isnan(spread.low)) return "-";
    return number(spread.low, decimals) + " to " + number(spread.high, decimals);
}

std::string ranks(const Spread& ranks) {
    return ranks.low == ranks.high ? fixed(ranks.low, 0)
                                   : fixed(ranks.low, 0) + " to " + fixed(ranks.high, 0);
}

constexpr double width = 760, label_width = 210, right = 740, top = 40, row_height = 17;

/// Values on paper, from the least to the greatest that an interval reaches.
struct Ruler {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void reach(double value) {
        if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    }
    double across(double value) const {
        const double share = high > low ? (value - low) / (high - low) : 0.5;
        return label_width + (right - label_width) * std::clamp(share, 0.0, 1.0);
    }
};

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
    return "<text x=\"" + fixed(x, 1) + "\" y=\"" + fixed(y, 1) + "\" text-anchor=\"" + anchor + "\">" +
           escaped(text) + "</text>\n";
}

std::string line_from(double x0, double y0, double x1, double y1, const char* colour) {
    return "<line x1=\"" + fixed(x0, 1) + "\" y1=\"" + fixed(y0, 1) + "\" x2=\"" + fixed(x1, 1) + "\" y2=\"" +
           fixed(y1, 1) + "\" stroke=\"" + colour + "\"/>\n";
}

std::string row_of(const PooledMethod& method, const Ruler& ruler, double y) {
    std::string text = text_at(label_width - 10, y + 4, "end", method.label);
    if (!std::isfinite(method.mean)) return text;
    const auto& [low, high] = method.mean_spread;
    if (std::isfinite(low)) text += line_from(ruler.across(low), y, ruler.across(high), y, "#0072b2");
    return text + "<circle cx=\"" + fixed(ruler.across(method.mean), 1) + "\" cy=\"" + fixed(y, 1) +
           "\" r=\"3.5\" fill=\"#0072b2\"/>\n";
}

/// Multiples of 1, 2 or 5 times a power of ten: about five of them.
std::vector<double> round_values(const Ruler& ruler) {
    const double part = (ruler.high - ruler.low) / 5;
    if (!(part > 0)) return {ruler.low};
    const double power = std::pow(10, std::floor(std::log10(part))), in_powers = part / power;
    const double step = power * (in_powers < 1.5 ? 1 : in_powers < 3.5 ? 2 : in_powers < 7.5 ? 5 : 10);
    std::vector<double> values;
    for (double k = std::ceil(ruler.low / step); k * step <= ruler.high; ++k) values.push_back(k * step);
    return values;
}

std::string ruled(const Ruler& ruler, int decimals, double bottom) {
    std::string text;
    for (const double value : round_values(ruler)) {
        const double x = ruler.across(value);
        text += line_from(x, top - 6, x, bottom, "#dddddd") +
                text_at(x, top - 10, "middle", fixed(value, decimals));
    }
    return text;
}

std::string csv_row(const StudyResults& results, const PooledScores& pool, const PooledMethod& m) {
    const PoolChoice& choice = pool.choice;
    std::string text = choice.metric + "," + csv_field(choice.region) + "," + results.truth + "," +
                       std::to_string(pool.textures) + "," + std::to_string(pool.views) + "," +
                       std::to_string(choice.samples) + "," + std::to_string(choice.seed) + "," +
                       csv_field(choice.baseline) + "," + csv_field(m.label);
    for (const double value :
         {m.mean, m.mean_spread.low, m.mean_spread.high, double(m.rank), m.rank_spread.low,
          m.rank_spread.high, m.first_share, m.difference, m.difference_spread.low, m.difference_spread.high})
        text += "," + shortest(value);
    return text + "\n";
}

}  // namespace

TableCells pooled_cells(const StudyResults& results, const PooledScores& pool) {
    const MetricCard& metric = metric_of(results, pool);
    const int decimals = metric.decimals;
    TableCells table{.title = metric.name + ", mean over " + counted(pool.textures, "texture") + " (" +
                              counted(pool.views, "view") + "), region '" + pool.choice.region + "', GT-" +
                              results.truth,
                     .columns = {{"rank"},
                                 {"method", true},
                                 {metric.name},
                                 {"95 %"},
                                 {"ranks"},
                                 {"first"},
                                 {"less " + pool.choice.baseline},
                                 {"95 % of it"}},
                     .rows = {}};
    for (const PooledMethod& m : pool.methods)
        table.rows.push_back({std::to_string(m.rank), m.label, number(m.mean, decimals),
                              spread(m.mean_spread, decimals), ranks(m.rank_spread),
                              fixed(100 * m.first_share, 0) + " %", number(m.difference, decimals),
                              spread(m.difference_spread, decimals)});
    return table;
}

std::vector<std::string> left_out_in_words(const PooledScores& pool) {
    std::vector<std::string> lines;
    if (!pool.left_out.empty())
        lines.push_back("Left out, since they have no number in some view: " + joined(pool.left_out) + ".");
    if (!pool.textures_left_out.empty())
        lines.push_back(
            "Left out, since a method is without error on them: " + joined(pool.textures_left_out) + ".");
    return lines;
}

std::string pooled_csv(const StudyResults& results, const std::string& region) {
    std::string text =
        provenance_comment(results) +
        "metric,region,truth,textures,views,samples,seed,baseline,method,mean,low,high,rank,rank_low,rank_"
        "high,"
        "first_share,difference,difference_low,difference_high\n";
    for (const MetricCard& metric : results.metrics) {
        const PooledScores pool = pooled(results, {.metric = metric.name, .region = region});
        for (const PooledMethod& m : pool.methods) text += csv_row(results, pool, m);
    }
    return text;
}

std::vector<PooledScores> page_pools(const StudyResults& results) {
    std::vector<PooledScores> pools;
    for (const char* metric : {"psnr", "flip"})
        if (metric_index(results, metric) < results.metrics.size())
            pools.push_back(pooled(results, {.metric = metric}));
    return pools;
}

Plot pooled_plot(const StudyResults& results, const PooledScores& pool) {
    const MetricCard& metric = metric_of(results, pool);
    Ruler ruler;
    for (const PooledMethod& m : pool.methods)
        for (const double value : {m.mean, m.mean_spread.low, m.mean_spread.high}) ruler.reach(value);
    const double bottom = top + row_height * double(pool.methods.size());
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + fixed(width, 0) +
                      "\" height=\"" + fixed(bottom + 10, 0) +
                      "\" font-family=\"sans-serif\" font-size=\"11\">\n" +
                      text_at(label_width, 14, "start",
                              metric.name + ", mean and 95 % over " + counted(pool.textures, "texture"));
    if (ruler.low <= ruler.high) svg += ruled(ruler, metric.decimals, bottom);
    for (std::size_t i = 0; i < pool.methods.size(); ++i)
        svg += row_of(pool.methods[i], ruler, top + row_height * (double(i) + 0.5));
    return {"pooled-" + metric.name,
            "Mean " + metric.name + " over textures, with the 95 % interval of the choice of textures.",
            svg + "</svg>\n"};
}

}  // namespace zproof
