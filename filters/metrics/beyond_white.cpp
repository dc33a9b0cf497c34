// Metrics of light that no sRGB picture shows as it is.
#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/metrics/map.h"
#include "filters/metrics/metrics.h"

namespace zproof {

namespace {

/// The least normal number of OpenEXR's half: what is darker counts as that.
constexpr double darkest = 0x1p-14;

double stops_between(double a, double b) {
    const double stops = std::abs(std::log2(std::max(a, darkest) / std::max(b, darkest)));
    return std::isfinite(a) ? stops : std::numeric_limits<double>::infinity();
}

Plane<double> stops_map(const LinearPicture& candidate, const LinearPicture& truth) {
    require_one_size(candidate, truth);
    return mapped(truth.size(), [&](int x, int y) {
        const glm::dvec3 &a = candidate.at(x, y), &b = truth.at(x, y);
        return (stops_between(a.r, b.r) + stops_between(a.g, b.g) + stops_between(a.b, b.b)) / 3;
    });
}

/// Reinhard, Stark, Shirley and Ferwerda 2002, (3), channel by channel. NaN stays.
LinearPicture tone_mapped(const LinearPicture& light) {
    const auto mapped_to = [](double c) { return c < 0 ? 0 : std::isinf(c) ? 1 : c / (1 + c); };
    return mapped(light.size(), [&](int x, int y) {
        const glm::dvec3& c = light.at(x, y);
        return glm::dvec3{mapped_to(c.r), mapped_to(c.g), mapped_to(c.b)};
    });
}

Plane<double> flip_tone_map(const LinearPicture& candidate, const LinearPicture& truth) {
    return flip_metric().map(tone_mapped(candidate), tone_mapped(truth));
}

}  // namespace

PictureMetric stops_metric() {
    return {.name = "stops",
            .definition =
                "Mean absolute difference of the three channels in stops, log2 of their ratio; what "
                "is darker than 2^-14, the least normal half, counts as that.",
            .source = "",
            .map = stops_map,
            .pool = mean_of};
}

PictureMetric flip_tone_metric() {
    return {.name = "flip-tone",
            .definition = "flip of light c / (1 + c), channel by channel, in place of light cut to [0, 1].",
            .source = "Reinhard et al., Photographic Tone Reproduction for Digital Images, SIGGRAPH 2002",
            .map = flip_tone_map,
            .pool = mean_of};
}

}  // namespace zproof
