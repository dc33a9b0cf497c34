#include "reports/pages/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "reports/wording.h"

namespace zproof {

namespace {

constexpr double left = 62, right = 560, top = 34, width = 760, name_height = 13.5;
constexpr double usual_height = names_beside * name_height + 6;
constexpr double note_height = 12;

/// Okabe and Ito 2008, yellow left out: it does not stand out from white.
constexpr std::array palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"};
constexpr const char* quiet_colour = "#b8b8b8";
constexpr const char* muted_colour = "#8a8a8a";

/// Two decimals are a hundredth of a unit.
std::string place(double value) { return shortest(std::round(100 * value) / 100); }

bool is_shown(const ChartAxis& axis, double value) {
    return std::isfinite(value) && (axis.scale == Scale::linear || value > 0);
}

double scaled(const ChartAxis& axis, double value) {
    return axis.scale == Scale::logarithmic ? std::log10(value) : value;
}

struct AxisRange {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void reach(double value) { low = std::min(low, value), high = std::max(high, value); }
    double share(double value) const { return (value - low) / (high - low); }
};

/// The range with room at the ends; a single value is in the middle.
AxisRange widen(AxisRange range) {
    if (!(range.low <= range.high)) return {0, 1};
    const double room = range.low == range.high ? 0.5 : 0.05 * (range.high - range.low);
    return {range.low - room, range.high + room};
}

/// The places of a chart's values on paper.
struct Frame2D {
    const Chart& chart;
    AxisRange x, y;
    double bottom;

    double across(double value) const { return left + (right - left) * x.share(scaled(chart.x, value)); }
    double down(double value) const { return bottom - (bottom - top) * y.share(scaled(chart.y, value)); }
    bool shows(const std::pair<double, double>& p) const {
        return is_shown(chart.x, p.first) && is_shown(chart.y, p.second);
    }
};

Frame2D framed(const Chart& chart) {
    const auto named = std::ranges::count_if(
        chart.series, [](const Series& series) { return series.style != SeriesStyle::quiet; });
    AxisRange x, y;
    for (const Series& series : chart.series)
        for (const auto& p : series.points) {
            if (!is_shown(chart.x, p.first) || !is_shown(chart.y, p.second)) continue;
            x.reach(scaled(chart.x, p.first));
            y.reach(scaled(chart.y, p.second));
        }
    return {chart, widen(x), widen(y), top + std::max(usual_height, name_height * double(named))};
}

std::string line(double x1, double y1, double x2, double y2, const std::string& colour) {
    return "<line x1=\"" + place(x1) + "\" y1=\"" + place(y1) + "\" x2=\"" + place(x2) + "\" y2=\"" +
           place(y2) + "\" stroke=\"" + colour + "\"/>";
}

std::string text(double x, double y, const std::string& attributes, const std::string& words) {
    return "<text x=\"" + place(x) + "\" y=\"" + place(y) + "\"" + attributes + ">" + escaped(words) +
           "</text>";
}

constexpr const char* at_middle = " text-anchor=\"middle\"";
constexpr const char* at_end = " text-anchor=\"end\"";

/// Round numbers within a scaled range: 1, 2, 5 per decade where a logarithmic axis is short, else decades.
std::vector<double> ticks(const ChartAxis& axis, const AxisRange& range) {
    std::vector<double> found;
    const auto add = [&](double value) {
        const double at = scaled(axis, value);
        if (at >= range.low && at <= range.high) found.push_back(value);
    };
    if (axis.scale == Scale::logarithmic) {
        const bool is_short = range.high - range.low < 2.5;
        constexpr double most_decades = 9;  // so many numbers stand side by side
        const int every = std::max(1, int(std::ceil((range.high - range.low) / most_decades)));
        for (int decade = int(std::floor(range.low)); decade <= int(std::ceil(range.high)); ++decade)
            for (const double factor : {1.0, 2.0, 5.0})
                if (decade % every == 0 && (is_short || factor == 1)) add(factor * std::pow(10.0, decade));
        return found;
    }
    const double rough = (range.high - range.low) / 5, unit = std::pow(10.0, std::floor(std::log10(rough)));
    const double step = rough > 5 * unit ? 10 * unit : rough > 2 * unit ? 5 * unit : 2 * unit;
    for (double k = std::ceil(range.low / step); k * step <= range.high; ++k) add(k * step + 0.0);  // no -0
    return found;
}

std::string tick_name(double value) {
    if (value >= 1000 && value < 1e9 && value == std::floor(value)) return grouped(std::uint64_t(value));
    return std::abs(value) >= 1e-4 && std::abs(value) < 1000 ? rounded(value) : shortest(value);
}

/// "0.01", not "0.0100".
std::string without_idle_zeros(std::string number) {
    if (number.find('.') == std::string::npos || number.find('e') != std::string::npos) return number;
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    return number;
}

/// Only every n-th name is written, so that none runs into the next: n.
std::size_t name_step(const ChartAxis& axis) {
    constexpr double letter_width = 6.5, gap = 8;
    std::size_t longest = 0;
    for (const auto* words : {&axis.names, &axis.notes})
        for (const std::string& word : *words) longest = std::max(longest, word.size());
    return std::size_t(
        std::ceil(double(axis.names.size()) * (double(longest) * letter_width + gap) / (right - left)));
}

double note_room(const Chart& chart) { return chart.x.notes.empty() ? 0 : note_height; }

std::string x_axis(const Frame2D& frame) {
    std::string svg;
    const auto add = [&](double value, const std::string& name) {
        svg += line(frame.across(value), top, frame.across(value), frame.bottom, "#e6e6e6") +
               text(frame.across(value), frame.bottom + 15, at_middle, name);
    };
    const ChartAxis& axis = frame.chart.x;
    const std::size_t step = axis.names.empty() ? 1 : name_step(axis);
    for (std::size_t i = 0; i < axis.names.size(); ++i) {
        if (double(i) < frame.x.low || double(i) > frame.x.high) continue;
        add(double(i), i % step == 0 ? axis.names[i] : "");
        if (i % step == 0 && !axis.notes.empty())
            svg += text(frame.across(double(i)), frame.bottom + 15 + note_height,
                        std::string{at_middle} + " fill=\"#8a8a8a\"", axis.notes[i]);
    }
    if (axis.names.empty())
        for (const double value : ticks(axis, frame.x)) add(value, without_idle_zeros(tick_name(value)));
    return svg + text((left + right) / 2, frame.bottom + 33 + note_room(frame.chart), at_middle, axis.title);
}

std::string y_axis(const Frame2D& frame) {
    std::string svg;
    for (const double value : ticks(frame.chart.y, frame.y))
        svg += line(left, frame.down(value), right, frame.down(value), "#e6e6e6") +
               text(left - 6, frame.down(value) + 4, at_end, without_idle_zeros(tick_name(value)));
    const double middle = (top + frame.bottom) / 2;
    return svg + text(15, middle,
                      std::string{at_middle} + " transform=\"rotate(-90 15 " + place(middle) + ")\"",
                      frame.chart.y.title);
}

std::string path_of(const Series& series, const Frame2D& frame) {
    std::string path;
    double last_y = 0;
    for (const auto& p : series.points) {
        if (!frame.shows(p)) continue;
        const double x = frame.across(p.first), y = frame.down(p.second);
        if (!path.empty() && series.joining == Joining::steps) path += "L" + place(x) + " " + place(last_y);
        path += (path.empty() ? "M" : "L") + place(x) + " " + place(y);
        last_y = y;
    }
    return path;
}

/// How a series is inked.
struct Ink {
    std::string colour, dashes;
};

/// How strongly the marks at a value are drawn.
double strength_at(const ChartAxis& axis, double value) {
    const auto i = std::size_t(std::max(0.0, std::round(value)));
    return i < axis.strengths.size() ? axis.strengths[i] : 1;
}

std::string faded(const char* attribute, double strength) {
    return strength < 1 ? " " + std::string{attribute} + "=\"" + place(strength) + "\"" : "";
}

/// One path; where the places differ in strength, a path for each step, as weak as its weaker end.
std::string joined(const Series& series, const Frame2D& frame, const std::string& stroke) {
    const auto path = [&](const Series& part, double strength) {
        return "<path d=\"" + path_of(part, frame) + "\" fill=\"none\"" + stroke +
               faded("stroke-opacity", strength) + "/>";
    };
    const ChartAxis& axis = frame.chart.x;
    if (axis.strengths.empty()) return path(series, 1);
    std::string svg;
    const std::pair<double, double>* last = nullptr;
    for (const auto& p : series.points) {
        if (!frame.shows(p)) continue;
        if (last != nullptr) {
            Series step = series;
            step.points = {*last, p};
            svg += path(step, std::min(strength_at(axis, last->first), strength_at(axis, p.first)));
        }
        last = &p;
    }
    return svg;
}

std::string drawn(const Series& series, const Frame2D& frame, const Ink& ink) {
    const auto& [colour, dashes] = ink;
    std::string svg;
    if (series.joining != Joining::points)
        svg += joined(series, frame,
                      " stroke=\"" + colour + "\" stroke-width=\"" +
                          (series.style == SeriesStyle::marked ? "1.6" : "1") + "\"" + dashes);
    for (const auto& p : series.points)
        if (frame.shows(p))
            svg += "<circle cx=\"" + place(frame.across(p.first)) + "\" cy=\"" + place(frame.down(p.second)) +
                   "\" r=\"2.8\" fill=\"" + colour + "\"" +
                   faded("fill-opacity", strength_at(frame.chart.x, p.first)) + "><title>" +
                   escaped(series.name) + ": " + tick_name(p.first) + ", " + tick_name(p.second) +
                   "</title></circle>";
    return svg;
}

/// What belongs to a series, as one thing to those who look at the picture's elements.
std::string grouped_as(const std::string& name, const std::string& svg) {
    return name.empty() || svg.empty()
               ? svg
               : "<g class=\"series\" data-series=\"" + escaped(name) + "\">" + svg + "</g>";
}

/// A name at the margin, tied to the last point of its series.
struct Label {
    std::string name, colour;
    double x, y;  ///< of the point
    double y_name = 0;
};

/// Pushed apart from the top down, then back up from the bottom.
void spread(std::vector<Label>& labels, double bottom) {
    std::ranges::stable_sort(labels, {}, &Label::y);
    double free = top + 4;
    for (Label& label : labels) {
        label.y_name = std::max(label.y, free);
        free = label.y_name + name_height;
    }
    double least = bottom;
    for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
        label->y_name = std::min(label->y_name, least);
        least = label->y_name - name_height;
    }
}

std::string set(std::vector<Label> labels, double bottom) {
    spread(labels, bottom);
    std::string svg;
    for (const Label& label : labels)
        svg += grouped_as(
            label.name, "<path d=\"M" + place(label.x + 4) + " " + place(label.y) + "L" + place(right + 8) +
                            " " + place(label.y_name) + "\" fill=\"none\" stroke=\"" + label.colour +
                            "\" stroke-width=\"0.5\" stroke-dasharray=\"2 2\"/>" +
                            text(right + 11, label.y_name + 4, " fill=\"" + label.colour + "\"", label.name));
    return svg;
}

Ink ink_of(SeriesStyle style, std::size_t marked_before) {
    if (style == SeriesStyle::quiet) return {quiet_colour, ""};
    if (style == SeriesStyle::muted) return {muted_colour, ""};
    return {palette[marked_before % palette.size()],
            marked_before < palette.size() ? "" : " stroke-dasharray=\"6 3\""};
}

std::string all_series(const Frame2D& frame) {
    std::string below, above;
    std::vector<Label> labels;
    std::size_t marked = 0;
    for (const Series& series : frame.chart.series) {
        const bool is_marked = series.style == SeriesStyle::marked;
        const Ink ink = ink_of(series.style, marked);
        marked += is_marked ? 1 : 0;
        (is_marked ? above : below) += grouped_as(series.name, drawn(series, frame, ink));
        const auto last = std::ranges::find_if(series.points.rbegin(), series.points.rend(),
                                               [&](const auto& p) { return frame.shows(p); });
        if (series.style != SeriesStyle::quiet && last != series.points.rend())
            labels.push_back({series.name, ink.colour, frame.across(last->first), frame.down(last->second)});
    }
    return below + above + set(std::move(labels), frame.bottom);
}

}  // namespace

std::string chart_svg(const Chart& chart) {
    const Frame2D frame = framed(chart);
    const double height = frame.bottom + 44 + note_room(chart);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + place(width) + " " + place(height) +
           "\" width=\"" + place(width) + "\" height=\"" + place(height) +
           "\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"11\" fill=\"#222\">"
           "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
           text(left, 20, " font-size=\"13\" font-weight=\"bold\"", chart.title) + x_axis(frame) +
           y_axis(frame) + "\n" + all_series(frame) + "\n</svg>\n";
}

}  // namespace zproof
