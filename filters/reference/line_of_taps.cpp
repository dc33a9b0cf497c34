#include "filters/reference/line_of_taps.h"

namespace zproof::oracle::filter_reference {

/// J J^T = [a h; h c]. With r = hypot(a - c, 2 h) the longer axis lies along (r + a - c, 2 h) and along
/// (2 h, r - (a - c)); the one without cancellation is taken.
TexelInterval major_direction(const PixelFootprint& f) {
    const Interval a = square(f.per_x.u) + square(f.per_y.u), c = square(f.per_x.v) + square(f.per_y.v);
    const Interval h2 = Interval{2} * (f.per_x.u * f.per_x.v + f.per_y.u * f.per_y.v), difference = a - c;
    const Interval r = length(difference, h2);
    const bool is_across = middle(difference) >= 0;
    const TexelInterval vector =
        is_across ? TexelInterval{r + difference, h2} : TexelInterval{h2, r - difference};
    const Interval norm = length(vector.u, vector.v);
    if (!(norm.low() > 0)) return {Interval{-1, 1}, Interval{-1, 1}};
    return {clamped(vector.u / norm, -1, 1), clamped(vector.v / norm, -1, 1)};
}

std::vector<int> ceilings(const Interval& a, int most) {
    const auto up = [&](double x) { return x >= most ? most : x > 1 ? int(std::ceil(x)) : 1; };
    std::vector<int> all;
    for (int n = up(a.low()); n <= up(a.high()); ++n) all.push_back(n);
    return all;
}

ColourRange weighted_mean(const std::vector<Interval>& weights, const std::vector<ColourRange>& colours) {
    double sum = 0, least = 0;
    glm::dvec3 mean{0}, radius{0}, deviation{0};
    ColourRange all = colours.front();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double w = middle(weights[i]);
        sum += w;
        all = hull(all, colours[i]);
        least += std::max(weights[i].low(), 0.0);
        mean += w * (colours[i].low + colours[i].high) / 2.0;
    }
    mean /= sum;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const glm::dvec3 c = (colours[i].low + colours[i].high) / 2.0,
                         own = (colours[i].high - colours[i].low) / 2.0;
        deviation += (zproof::radius(weights[i]) + 0x1p-50 * std::abs(middle(weights[i]))) *
                     (glm::abs(c - mean) + 0x1p-50);
        radius += weights[i].high() * own;
    }
    const ColourRange near = around(mean, (deviation + radius) / std::max(least, 0x1p-60) + 0x1p-50);
    return {glm::max(near.low, all.low - 0x1p-50), glm::min(near.high, all.high + 0x1p-50)};
}

ColourRange mean_along(const TexelInterval& centre, const TexelInterval& along,
                       const std::vector<LineTap>& taps,
                       const std::function<ColourRange(const TexelInterval&)>& read) {
    std::vector<Interval> weights;
    std::vector<ColourRange> colours;
    for (const LineTap& tap : taps) {
        weights.push_back(tap.weight);
        colours.push_back(read({centre.u + tap.at * along.u, centre.v + tap.at * along.v}));
    }
    return weighted_mean(weights, colours);
}

}  // namespace zproof::oracle::filter_reference
