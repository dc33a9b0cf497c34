#include "filters/conformance/conformance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace zproof {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

double slack_in(const LinearRgb& colour, const ColourRange& range) {
    const std::array<double, 3> value{colour.r, colour.g, colour.b};
    double slack = 0;
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(value[std::size_t(c)])) return inf;
        if (range.low[c] == -inf) continue;
        const double half = (range.high[c] - range.low[c]) / 2, middle = range.low[c] + half;
        const double off = std::abs(value[std::size_t(c)] - middle);
        // Inside is inside, whatever the quotient rounds to.
        const bool is_inside =
            value[std::size_t(c)] >= range.low[c] && value[std::size_t(c)] <= range.high[c];
        const double needed = off == 0 ? 0 : half == 0 ? inf : off / half;
        slack =
            std::max(slack, is_inside ? std::min(needed, 1.0) : std::max(needed, std::nextafter(1.0, 2.0)));
    }
    return slack;
}

}  // namespace

const ColourRange& nearest_range(const LinearRgb& colour, const PermittedColours& permitted) {
    const ColourRange* nearest = &permitted.front();
    double least = inf;
    for (const ColourRange& range : permitted)
        if (const double slack = slack_in(colour, range); slack < least) least = slack, nearest = &range;
    return *nearest;
}

glm::dvec3 widths_of(const PermittedColours& permitted) {
    glm::dvec3 sum{0};
    for (const ColourRange& range : permitted) sum += range.high - range.low;
    return sum;
}

double width_of(const PermittedColours& permitted) {
    const glm::dvec3 width = widths_of(permitted);
    return (width.x + width.y + width.z) / 3;
}

double slack_of(const LinearRgb& colour, const PermittedColours& permitted) {
    return slack_in(colour, nearest_range(colour, permitted));
}

LinearRgb reflected(const LinearRgb& colour, const PermittedColours& permitted) {
    const ColourRange& near = nearest_range(colour, permitted);
    const glm::dvec3 twice = near.low + near.high;
    return {float(twice.x - colour.r), float(twice.y - colour.g), float(twice.z - colour.b)};
}

std::vector<FilterPixel> some_pixels(const Conformance& found, float least_slack) {
    constexpr std::size_t most = 400;
    std::vector<FilterPixel> all;
    for (int y = 0; y < found.slack.size().height; ++y)
        for (int x = 0; x < found.slack.size().width; ++x)
            if (found.slack.at(x, y) >= least_slack) all.push_back({x, y});
    if (all.size() <= most) return all;
    std::vector<FilterPixel> some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
    return some;
}

std::vector<bool> have_pixels_outside(std::span<const Picture> pictures, const PixelReference& reference,
                                      const FilterPrecision& precision) {
    if (pictures.empty()) return {};
    std::vector<std::atomic<bool>> is_outside(pictures.size());
    const Resolution size = pictures.front().size();
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            if (std::ranges::all_of(is_outside, [](const std::atomic<bool>& is) { return is.load(); }))
                return;
            const PermittedColours permitted = reference(x, y, precision);
            for (std::size_t i = 0; i < pictures.size(); ++i)
                if (!is_outside[i] && slack_of(pictures[i].at(x, y), permitted) > 1) is_outside[i] = true;
        }
    });
    return {is_outside.begin(), is_outside.end()};
}

Conformance conformance(const Picture& picture, const PixelReference& reference,
                        const FilterPrecision& precision) {
    const Resolution size = picture.size();
    Conformance found{.judged = size.pixel_count(), .worst = {}, .where = {}, .slack = Plane<float>{size}};
    Plane<glm::dvec3> width{size};
    found.width = Plane<glm::vec3>{size};
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const PermittedColours permitted = reference(x, y, precision);
            const double slack = slack_of(picture.at(x, y), permitted);
            found.slack.at(x, y) = slack > 1 ? std::nextafter(float(slack), float(inf)) : float(slack);
            width.at(x, y) = widths_of(permitted);
            found.width.at(x, y) = glm::vec3{width.at(x, y)};
        }
    });
    glm::dvec3 widths{0};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double slack = double{found.slack.at(x, y)};
            const glm::dvec3& w = width.at(x, y);
            if (!std::isfinite(w.x + w.y + w.z))
                ++found.anything;
            else
                widths += w;
            if (slack > found.worst_slack) found.worst_slack = slack, found.worst = {x, y};
            if (!(slack > 1)) continue;
            ++found.outside;
            if (!found.where) found.where = ExtentOutside{{x, y}, {x, y}};
            found.where->first.x = std::min(found.where->first.x, x);
            found.where->last.x = std::max(found.where->last.x, x);
            found.where->last.y = y;
        }
    }
    found.mean_width_of = widths / double(std::max<std::uint64_t>(found.judged - found.anything, 1));
    found.mean_width = (found.mean_width_of.x + found.mean_width_of.y + found.mean_width_of.z) / 3;
    return found;
}

}  // namespace zproof
