#include <algorithm>
#include <cmath>

#include "reports/html_parts.h"
#include "reports/wording.h"

namespace zproof {

namespace {

constexpr double left = 38, top = 8, bar = 12, height = 96;
constexpr double bottom = top + height;
constexpr double bars_end = left + 20 * bar;
constexpr double beyond = bars_end + 8;  // where the bin from 1 up starts
constexpr double width = beyond + bar + 12;

std::string at(std::string_view name, double value) {
    return " " + std::string(name) + "=\"" + shortest(value) + "\"";
}

std::string text_at(double x, double y, std::string_view kind, std::string_view text) {
    return "<text class=\"" + std::string(kind) + "\"" + at("x", x) + at("y", y) + ">" + std::string(text) +
           "</text>";
}

std::string line(std::string_view kind, double x1, double y1, double x2, double y2) {
    return "<line class=\"" + std::string(kind) + "\"" + at("x1", x1) + at("y1", y1) + at("x2", x2) +
           at("y2", y2) + "/>";
}

/// Whole decades that the counts reach, at least one.
int decades(const BoundHistogram& histogram) {
    const double most = double(*std::ranges::max_element(histogram));
    return std::max(1, int(std::ceil(std::log10(std::max(1.0, most)))));
}

/// A count of one still stands off the ground.
double bar_height(std::uint64_t count, int top_decade) {
    if (count == 0) return 0;
    return std::round(100 * (3 + (height - 3) * std::log10(double(count)) / top_decade)) / 100;
}

std::string range_of(std::size_t bin) {
    return bin == 20 ? "1 and more" : fixed(double(bin) / 20, 2) + " to " + fixed(double(bin + 1) / 20, 2);
}

std::string bars(const BoundHistogram& histogram, int top_decade) {
    std::string svg;
    for (std::size_t bin = 0; bin < histogram.size(); ++bin) {
        const double tall = bar_height(histogram[bin], top_decade);
        if (tall == 0) continue;
        const double x = bin == 20 ? beyond : left + bar * double(bin);
        svg += std::string("<rect class=\"") + (bin == 20 ? "over" : "bar") + "\"" + at("x", x + 0.5) +
               at("y", bottom - tall) + at("width", bar - 1) + at("height", tall) + "><title>" +
               range_of(bin) + ": " + counted(histogram[bin], "pixel") + "</title></rect>";
    }
    return svg;
}

std::string decade_name(int decade) {
    if (decade < 3) return shortest(std::pow(10.0, decade));
    return "10<tspan dy=\"-4\" font-size=\"7\">" + std::to_string(decade) + "</tspan>";
}

std::string scale(int top_decade) {
    std::string svg;
    const int step = top_decade > 4 ? 2 : 1;
    for (int decade = 0; decade <= top_decade; decade += step) {
        const double y = bottom - bar_height(std::uint64_t(std::pow(10.0, decade)), top_decade);
        svg += line("grid", left, y, bars_end, y) + text_at(left - 5, y + 3, "y", decade_name(decade));
    }
    return svg;
}

std::string axis() {
    std::string svg = line("axis", left, bottom, beyond + bar, bottom);
    for (const auto& [bin, name] : {std::pair{0, "0"}, {5, "¼"}, {10, "½"}, {15, "¾"}, {20, "bound"}})
        svg += text_at(left + bar * bin, bottom + 13, "x", name);
    return svg + line("bound", bars_end + 4, top - 4, bars_end + 4, bottom + 3);
}

}  // namespace

std::string histogram_svg(std::string_view what, const BoundRecord& record) {
    const int top_decade = decades(record.histogram);
    return "<svg role=\"img\" aria-label=\"" + escaped(what) + ", at most " +
           rounded(record.max_error_over_bound) + "\" viewBox=\"0 0 " + shortest(width) + " " +
           shortest(bottom + 20) + "\">" + scale(top_decade) + axis() + bars(record.histogram, top_decade) +
           "</svg>";
}

}  // namespace zproof
