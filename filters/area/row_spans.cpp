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

/// The first and the last of n pixels whose square of half-side reach meets the range.
std::pair<int, int> pixels_meeting(const Limits& range, double reach, int n) {
    const double first = std::ceil(range.low - 0.5 - reach), last = std::floor(range.high - 0.5 + reach);
    return {int(std::clamp(first, 0.0, double(n))), int(std::clamp(last, -1.0, n - 1.0))};
}

/// What the image, widened by reach, shows of a triangle.
Polygon<double> visible_part(const SeenTriangle<double>& t, const Surfaces::NearFarRange& range,
                             const View& view, double reach) {
    const double left = 0.5 - reach, right = view.width - left, bottom = view.height - left;
    Polygon<double> polygon{{left, left}, {right, left}, {right, bottom}, {left, bottom}};
    for (const Affine<double>& edge : t.edge) polygon = cut(polygon, edge).inside;
    polygon = cut(polygon, t.inverse_depth - Affine<double>{0, 0, range.farthest}).inside;
    return cut(polygon, Affine<double>{0, 0, range.nearest} - t.inverse_depth).inside;
}

}  // namespace

RowSpans::RowSpans(const Surfaces& surfaces, const View& view, double reach_px)
    : rows_(std::size_t(view.height)) {
    for (std::uint32_t id = 0; id < surfaces.triangle_count(); ++id) {
        if (!surfaces.seen(id)) continue;
        const Polygon<double> part = visible_part(*surfaces.seen(id), surfaces.range(), view, reach_px);
        if (part.size() < 3) continue;
        const auto [top, bottom] = pixels_meeting(limits(part, &Point<double>::y), reach_px, view.height);
        for (int y = top; y <= bottom; ++y) {
            const Polygon<double> below = cut(part, Affine<double>{0, 1, reach_px - 0.5 - y}).inside;
            const Polygon<double> strip = cut(below, Affine<double>{0, -1, y + 0.5 + reach_px}).inside;
            if (strip.size() < 3) continue;
            const auto [first, last] = pixels_meeting(limits(strip, &Point<double>::x), reach_px, view.width);
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
