#include "lessons/projection/wireframe_svg.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/page_parts.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study::projection;

constexpr const char *seen_colour = "#d6006c", *hidden_colour = "#9aa0a6";

/// `per_px` steps of a decimal place to a pixel.
std::string place(double value, double per_px) { return shortest(std::round(per_px * value) / per_px); }

std::string path_of(const std::vector<WireLine>& lines, Visibility visibility, double per_px) {
    std::string path;
    for (const WireLine& line : lines) {
        if (line.visibility != visibility) continue;
        path += "M" + place(line.segment.a.x, per_px) + " " + place(line.segment.a.y, per_px) + "L" +
                place(line.segment.b.x, per_px) + " " + place(line.segment.b.y, per_px);
    }
    return path;
}

std::string stroked(const std::string& path, const std::string& colour, double width) {
    if (path.empty()) return "";
    return "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
           shortest(width) + "\" stroke-linecap=\"round\"/>\n";
}

std::vector<WireLine> drawn_lines(const Wireframe& wireframe) {
    std::vector<WireLine> lines = wireframe.lines;
    if (lines.size() <= most_lines) return lines;
    std::ranges::stable_sort(lines, std::ranges::greater{},
                             [](const WireLine& line) { return length_of(line.segment); });
    lines.resize(most_lines);
    return lines;
}

/// What an SVG file begins with: units are pixels.
std::string begun(double x, double y, Resolution size, double magnification) {
    const auto side = [&](int px) { return shortest(px * magnification); };
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + shortest(x) + " " + shortest(y) + " " +
           std::to_string(size.width) + " " + std::to_string(size.height) + "\" width=\"" + side(size.width) +
           "\" height=\"" + side(size.height) + "\">\n<rect x=\"" + shortest(x) + "\" y=\"" + shortest(y) +
           "\" width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
}

std::string image(const Plane<Rgb8>& picture, int x, int y) {
    return "<image x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\" width=\"" +
           std::to_string(picture.size().width) + "\" height=\"" + std::to_string(picture.size().height) +
           "\" style=\"image-rendering:pixelated\" href=\"" + png_uri(picture) + "\"/>\n";
}

struct Square {
    int x, y, side;
};

/// Around the middle of a pair of neighbours, within a picture that is at least as large.
Square around(const Boundary& boundary, int reach, Resolution size) {
    const int side = std::min({2 * reach, size.width, size.height});
    return {std::clamp(boundary.x + 1 - side / 2, 0, size.width - side),
            std::clamp(boundary.y + 1 - side / 2, 0, size.height - side), side};
}

Plane<Rgb8> cut_out(const Plane<Rgb8>& picture, const Square& square) {
    Plane<Rgb8> part{{square.side, square.side}};
    for (int y = 0; y < square.side; ++y)
        for (int x = 0; x < square.side; ++x) part.at(x, y) = picture.at(square.x + x, square.y + y);
    return part;
}

std::vector<WireLine> lines_in(const Wireframe& wireframe, const Square& square) {
    const glm::dvec2 low{square.x, square.y}, high = low + double(square.side);
    std::vector<WireLine> lines;
    for (const WireLine& line : wireframe.lines)
        if (const auto shown = within(line.segment, low, high))
            lines.push_back({*shown, line.edge, line.visibility});
    return lines;
}

std::string dot(double x, double y, const std::string& look) {
    return "<circle cx=\"" + shortest(x) + "\" cy=\"" + shortest(y) + "\" " + look + "/>\n";
}

std::string centres(const Square& square) {
    std::string svg;
    for (int y = 0; y < square.side; ++y)
        for (int x = 0; x < square.side; ++x)
            svg += dot(square.x + x + 0.5, square.y + y + 0.5,
                       "r=\"0.05\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"0.015\"");
    return svg;
}

std::string marked_pair(const Boundary& b) {
    return "<path d=\"M" + shortest(b.x + 0.5) + " " + shortest(b.y + 0.5) + "L" + shortest(b.to_x + 0.5) +
           " " + shortest(b.to_y + 0.5) +
           "\" stroke=\"#000\" stroke-width=\"0.06\" stroke-dasharray=\"0.12 0.08\"/>\n";
}

}  // namespace

std::string wireframe_svg(const WireframeDrawing& drawing) {
    const std::vector<WireLine> lines = drawn_lines(drawing.wireframe);
    const std::string hidden = path_of(lines, Visibility::hidden, 100),
                      seen = path_of(lines, Visibility::seen, 100) + path_of(lines, Visibility::unknown, 100);
    std::string svg = begun(0, 0, drawing.size, 1);
    if (drawing.backdrop != nullptr)
        return svg + image(*drawing.backdrop, 0, 0) + stroked(seen, seen_colour, 0.8) + "</svg>\n";
    return svg + stroked(hidden, hidden_colour, 0.35) + stroked(seen, "#1c2026", 0.9) + "</svg>\n";
}

std::string remark_on_lines(const Wireframe& wireframe) {
    if (wireframe.lines.size() <= most_lines) return "";
    return "The longest " + grouped(most_lines) + " of " + grouped(wireframe.lines.size()) +
           " lines are drawn.";
}

std::string magnified_svg(const WireframeDrawing& drawing, const Boundary& boundary, int reach) {
    const Square square = around(boundary, reach, drawing.size);
    std::string svg = begun(square.x, square.y, {square.side, square.side}, 30);
    if (drawing.backdrop != nullptr) svg += image(cut_out(*drawing.backdrop, square), square.x, square.y);
    const std::vector<WireLine> lines = lines_in(drawing.wireframe, square);
    constexpr double per_px = 1e4;
    svg += stroked(path_of(lines, Visibility::hidden, per_px), hidden_colour, 0.03);
    svg += stroked(path_of(lines, Visibility::seen, per_px) + path_of(lines, Visibility::unknown, per_px),
                   seen_colour, 0.05);
    return svg + centres(square) + marked_pair(boundary) + "</svg>\n";
}

}  // namespace zproof
