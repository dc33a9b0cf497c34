/// A line or scatter chart as an SVG file of its own, for papers and pages: no scripts, no fonts of its own.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zproof {

enum class Scale {
    linear,
    logarithmic,  ///< values must be positive; others are left out
};

enum class SeriesStyle {
    marked,  ///< in a colour of its own, dashed where the colours have all been used; named at the right
             ///< margin
    muted,   ///< grey, named
    quiet,   ///< grey, without a name
};

enum class Joining { points, line, steps };

struct Series {
    std::string name;
    std::vector<std::pair<double, double>> points;  ///< (x, y); what is not finite is left out
    SeriesStyle style = SeriesStyle::marked;
    Joining joining = Joining::line;
    bool operator==(const Series&) const = default;
};

struct ChartAxis {
    std::string title;
    Scale scale = Scale::linear;
    /// Named places instead of round numbers: names[i] stands at x = i.
    std::vector<std::string> names;
    std::vector<std::string> notes{};  ///< a second row below the names; empty: none
    /// How strongly the marks at each named place are drawn, 0 to 1; empty: all fully.
    std::vector<double> strengths{};
    bool operator==(const ChartAxis&) const = default;
};

struct Chart {
    std::string title;
    ChartAxis x, y;
    std::vector<Series> series;
    bool operator==(const Chart&) const = default;
};

/// So many names fit beside a chart of usual height.
inline constexpr std::size_t names_beside = 24;

/// 760 units wide; as high as the names at the margin need. Each series with its name at the margin is a
/// group, <g class="series" data-series="NAME">, for pages whose reader chooses
/// (reports/viewer/src/charts.ts).
std::string chart_svg(const Chart& chart);

}  // namespace zproof
