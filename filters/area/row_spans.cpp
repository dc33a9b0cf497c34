#include "filters/area/row_spans.h"

#include <algorithm>
#include <cmath>

#include "filters/area/polygon.h"

namespace zproof::oracle::area {

namespace {

struct Limits {
    double low = 0, high = 0;
};

Limits limits(const Polygon<double>& polygon, double Point<double>::*axis) {
    Limits range{polygon[0].*axis, polygon[0].*axis};
    for (const Point<double>& p : polygon)
        range = {std::min(range.low, p.*axis), std::max(range.high, p.*axis)};
    return range;
}

/// The first and the last of n squares along an axis that meet the range.
std::pair<int, int> squares_meeting(const Limits& range, const SquareGrid& squares, int n) {
    const double first = std::ceil(range.low - squares.first - squares.half_side),
                 last = std::floor(range.high - squares.first + squares.half_side);
    return {int(std::clamp(first, 0.0, double(n))), int(std::clamp(last, -1.0, n - 1.0))};
}

/// What all squares show of a triangle.
Polygon<double> visible_part(const SeenTriangle<double>& t, const Surfaces::NearFarRange& range,
                             const SquareGrid& squares) {
    const double left = squares.first - squares.half_side, beyond = squares.first + squares.half_side - 1;
    const double right = squares.size.width + beyond, bottom = squares.size.height + beyond;
    Polygon<double> polygon{{left, left}, {right, left}, {right, bottom}, {left, bottom}};
    for (const Affine<double>& edge : t.edge) polygon = cut(polygon, edge).inside;
    polygon = cut(polygon, t.inverse_depth - Affine<double>{0, 0, range.farthest}).inside;
    return cut(polygon, Affine<double>{0, 0, range.nearest} - t.inverse_depth).inside;
}

}  // namespace

RowSpans::RowSpans(const Surfaces& surfaces, const SquareGrid& squares)
    : rows_(std::size_t(squares.size.height)) {
    for (std::uint32_t id = 0; id < surfaces.triangle_count(); ++id) {
        if (!surfaces.seen(id)) continue;
        const Polygon<double> part = visible_part(*surfaces.seen(id), surfaces.range(), squares);
        if (part.size() < 3) continue;
        const auto [top, bottom] =
            squares_meeting(limits(part, &Point<double>::y), squares, squares.size.height);
        for (int y = top; y <= bottom; ++y) {
            const Polygon<double> below =
                cut(part, Affine<double>{0, 1, squares.half_side - squares.first - y}).inside;
            const Polygon<double> strip =
                cut(below, Affine<double>{0, -1, y + squares.first + squares.half_side}).inside;
            if (strip.size() < 3) continue;
            const auto [first, last] =
                squares_meeting(limits(strip, &Point<double>::x), squares, squares.size.width);
            if (first <= last) rows_[std::size_t(y)].push_back({id, first, last});
        }
    }
    for (auto& row : rows_) std::ranges::stable_sort(row, {}, &Span::first);
}

std::span<const std::uint32_t> RowSweep::at(int x) {
    std::erase_if(active_, [&](const Span& s) { return s.last < x; });
    for (; !waiting_.empty() && waiting_.front().first <= x; waiting_ = waiting_.subspan(1))
        active_.push_back(waiting_.front());
    ids_.clear();
    for (const Span& s : active_) ids_.push_back(s.triangle);
    std::ranges::sort(ids_);
    return ids_;
}

}  // namespace zproof::oracle::area
