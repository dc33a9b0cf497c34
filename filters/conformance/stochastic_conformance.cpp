#include "filters/conformance/stochastic_conformance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "math/interval_functions.h"

namespace zproof {

namespace {

constexpr std::array<const char*, 3> channel_names{"red", "green", "blue"};
/// The mean, weighted by 1 and by what each tilt would change; then the variance.
constexpr std::array<const char*, 2 + draw_tilts> statistic_names{"mean", "place along u",    "place along v",
                                                                  "LOD",  "twist of u and v", "variance"};
constexpr std::size_t statistics = statistic_names.size();

/// A sum of independent terms, each of expectation 0 but for an error: what is known of it.
struct Sum {
    double value = 0, variance = 0;
    double error = 0;    ///< bound of its expectation's absolute value
    double largest = 0;  ///< bound of a term's absolute value

    void add(const Sum& other) {
        value += other.value, variance += other.variance, error += other.error;
        largest = std::max(largest, other.largest);
    }
};

using Sums = std::array<Sum, 3 * statistics>;

/// What one channel of a pixel's draws is known to be.
struct ChannelMoments {
    double mean = 0;
    double error = 0;                       ///< of the mean
    double low = 0, second = 0;             ///< bounds of the expectation of (draw - mean)^2
    double fourth = 0;                      ///< upper bound of that of its square
    double range = 0;                       ///< largest |draw - mean|
    double colour_error = 0;                ///< a draw's
    std::array<double, draw_tilts> tilt{};  ///< change of the mean
};

ChannelMoments moments(const ColourDraws& all, int channel) {
    const auto colour = [&](const ColourDraw& draw) {
        return Interval{draw.colour.low[channel], draw.colour.high[channel]};
    };
    ChannelMoments m;
    double total = 0;
    for (const ColourDraw& draw : all.draws) {
        m.mean += middle(draw.probability) * middle(colour(draw));
        total += middle(draw.probability);
    }
    m.mean /= total;
    for (const ColourDraw& draw : all.draws) {
        const double off = std::abs(middle(colour(draw)) - m.mean), own = radius(colour(draw));
        if (draw.probability.high() > 0) m.range = std::max(m.range, off + own);
        // The middles' own moments about this mean cancel: what is left is how far probabilities are off.
        m.error += radius(draw.probability) * off;
        m.colour_error = std::max(m.colour_error, own);
        m.low += std::max(draw.probability.low(), 0.0) * std::pow(std::max(off - own, 0.0), 2);
        m.second += draw.probability.high() * std::pow(off + own, 2);
        m.fourth += draw.probability.high() * std::pow(off + own, 4);
        for (std::size_t t = 0; t < draw_tilts; ++t) m.tilt[t] += draw.tilt[t] * middle(colour(draw));
    }
    // Sums of a few dozen terms, in double.
    m.error += m.colour_error + 0x1p-44 * (std::abs(m.mean) + m.range);
    return m;
}

/// (v - mean) times a weight that does not depend on the draws.
Sum weighted_mean_term(const ChannelMoments& m, int samples, double value, double weight) {
    return {weight * (value - m.mean), weight * weight * m.second / samples, std::abs(weight) * m.error,
            std::abs(weight) * m.range};
}

/// (v - mean)^2 less its expectation. With e the error of the mean: the true variance lies within [low - e^2,
/// second], and E (v - true mean)^4 = fourth / n^3 + 3 (n - 1) variance^2 / n^3 for a mean of n draws.
Sum variance_term(const ChannelMoments& m, int samples, double value) {
    const double n = samples, e = m.error, most = m.second / n + e * e,
                 least = std::max(m.low - e * e, 0.0) / n, expected = (most + least) / 2;
    const double about_mean = std::pow(std::pow(m.fourth, 0.25) + e, 4),
                 fourth = (about_mean + 3 * (n - 1) * m.second * m.second) / (n * n * n);
    const double deviation =
        std::sqrt(std::max(fourth - least * least, 0.0)) + 2 * e * std::sqrt(m.second / n);
    const double shown = 2 * m.range * m.colour_error + m.colour_error * m.colour_error;
    return {std::pow(value - m.mean, 2) - expected, deviation * deviation,
            (most - least) / 2 + shown + 0x1p-44 * most, std::max(m.range * m.range, most)};
}

void add_pixel(const LinearRgb& colour, const ColourDraws& all, Sums& sums) {
    const std::array<double, 3> value{colour.r, colour.g, colour.b};
    for (int c = 0; c < 3; ++c) {
        const ChannelMoments m = moments(all, c);
        const double v = value[std::size_t(c)];
        Sum* const sum = &sums[std::size_t(c) * statistics];
        sum[0].add(weighted_mean_term(m, all.samples, v, 1));
        for (std::size_t t = 0; t < draw_tilts; ++t)
            sum[1 + t].add(weighted_mean_term(m, all.samples, v, m.tilt[t]));
        sum[1 + draw_tilts].add(variance_term(m, all.samples, v));
    }
}

/// Bernstein: P(|S| >= t) <= 2 exp(-t^2 / 2 / (V + M t / 3)) for a sum of independent terms of mean 0,
/// variances that sum to V, each at most M. So t = L M / 3 + sqrt((L M / 3)^2 + 2 L V), L = ln(2 /
/// probability).
double farthest(const Sum& sum, double probability) {
    const double l = std::log(2 / probability), linear = l * sum.largest / 3;
    return linear + std::sqrt(linear * linear + 2 * l * sum.variance);
}

StochasticTest test_of(const std::string& name, const Sum& sum) {
    const double deviation = std::sqrt(sum.variance);
    const double beyond = std::copysign(std::max(std::abs(sum.value) - sum.error, 0.0), sum.value);
    if (beyond == 0) return {name, 0, 0};
    return {name, deviation > 0 ? beyond / deviation : beyond * std::numeric_limits<double>::infinity(),
            deviation > 0 ? farthest(sum, false_alarm_rate / double(3 * statistics)) / deviation : 0};
}

}  // namespace

bool StochasticConformance::is_outside() const {
    return std::ranges::any_of(tests, &StochasticTest::is_outside);
}

const StochasticTest& StochasticConformance::worst() const {
    const auto in_limits = [](const StochasticTest& t) { return t.z == 0 ? 0 : std::abs(t.z) / t.limit; };
    return *std::ranges::max_element(tests, {}, in_limits);
}

StochasticConformance stochastic_conformance(const Picture& picture, const DrawQuery& draws_at) {
    const Resolution size = picture.size();
    std::vector<Sums> rows(std::size_t(size.height));
    std::vector<std::uint64_t> pixels(std::size_t(size.height));
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const std::optional<ColourDraws> draws = draws_at(x, y);
            if (!draws) continue;
            ++pixels[std::size_t(y)];
            add_pixel(picture.at(x, y), *draws, rows[std::size_t(y)]);
        }
    });
    StochasticConformance found;
    Sums sums{};
    for (std::size_t y = 0; y < rows.size(); ++y) {
        found.pixels += pixels[y];
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i].add(rows[y][i]);
    }
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t s = 0; s < statistics; ++s)
            found.tests.push_back(
                test_of(std::string{statistic_names[s]} + ", " + channel_names[c], sums[c * statistics + s]));
    return found;
}

}  // namespace zproof
