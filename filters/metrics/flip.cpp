// LDR-FLIP, from the formulas of Andersson et al., "FLIP: A Difference Evaluator for Alternating Images",
// HPG 2020; section numbers below are the paper's.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "filters/metrics/convolution.h"
#include "filters/metrics/map.h"
#include "filters/metrics/metrics.h"

namespace zproof {

namespace {

/// A 0.7 m wide screen of 3840 pixels seen from 0.7 m: 67 pixels per degree, the paper's own choice (4.1).
constexpr double pixels_per_degree = 0.7 * (3840 / 0.7) * std::numbers::pi / 180;

using Taps = std::vector<double>;
using Channel = Plane<double>;

/// CIE XYZ of linear Rec. 709 light over that of white (1, 1, 1), D65.
glm::dvec3 relative_xyz(const glm::dvec3& rgb) {
    constexpr glm::dvec3 x{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
        y{2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
        z{1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382};
    const auto relative = [&](const glm::dvec3& row) { return glm::dot(row, rgb) / (row.r + row.g + row.b); };
    return {relative(x), relative(y), relative(z)};
}

/// The inverse of relative_xyz().
glm::dvec3 linear_from_relative_xyz(const glm::dvec3& xyz) {
    const glm::dmat3 forward{relative_xyz({1, 0, 0}), relative_xyz({0, 1, 0}), relative_xyz({0, 0, 1})};
    static const glm::dmat3 backward = glm::inverse(forward);
    return backward * xyz;
}

/// Opponent space, linear in light: achromatic, red-green, blue-yellow (4.1).
glm::dvec3 opponent(const glm::dvec3& rgb) {
    const glm::dvec3 c = relative_xyz(rgb);
    return {116 * c.y - 16, 500 * (c.x - c.y), 200 * (c.y - c.z)};
}

glm::dvec3 linear_from_opponent(const glm::dvec3& o) {
    const double y = (o.x + 16) / 116;
    return linear_from_relative_xyz({y + o.y / 500, y, y - o.z / 200});
}

/// CIE L*a*b* with a* and b* weakened where it is dark: Hunt's effect (4.1).
glm::dvec3 hunt_lab(const glm::dvec3& rgb) {
    const auto f = [](double t) {
        constexpr double delta = 6.0 / 29;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    };
    const glm::dvec3 c = relative_xyz(rgb);
    const double lightness = 116 * f(c.y) - 16;
    return {lightness, 0.01 * lightness * 500 * (f(c.x) - f(c.y)),
            0.01 * lightness * 200 * (f(c.y) - f(c.z))};
}

/// Abasi, Amani Tehran and Fairchild 2020.
double hyab(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = a - b;
    return std::abs(d.x) + std::hypot(d.y, d.z);
}

/// Gaussian exp(-pi^2 d^2 / b) of the distance d in degrees: the eye's contrast sensitivity (4.1).
Taps sensitivity(double b) {
    const int radius =
        int(std::ceil(3 * std::sqrt(0.04 / (2 * std::numbers::pi * std::numbers::pi)) * pixels_per_degree));
    Taps taps;
    for (int i = -radius; i <= radius; ++i) {
        const double degrees = i / pixels_per_degree;
        taps.push_back(std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / b));
    }
    return taps;
}

double sum_of(const Taps& taps) {
    double sum = 0;
    for (const double tap : taps) sum += tap;
    return sum;
}

Channel seen_by_one(const Channel& values, double b) {
    const Taps taps = normalised(sensitivity(b));
    return convolved(values, taps, taps);
}

/// Blue-yellow has two Gaussians, of weights a sqrt(pi / b); the whole kernel sums to 1.
Channel seen_by_two(const Channel& values) {
    constexpr double a1 = 34.1, b1 = 0.04, a2 = 13.5, b2 = 0.025;
    const double sum1 = sum_of(sensitivity(b1)), sum2 = sum_of(sensitivity(b2));
    const double weight1 = a1 * std::sqrt(std::numbers::pi / b1) * sum1 * sum1,
                 weight2 = a2 * std::sqrt(std::numbers::pi / b2) * sum2 * sum2;
    const Channel one = seen_by_one(values, b1), two = seen_by_one(values, b2);
    return mapped(values.size(), [&](int x, int y) {
        return (weight1 * one.at(x, y) + weight2 * two.at(x, y)) / (weight1 + weight2);
    });
}

Channel channel_of(const LinearPicture& picture, int channel) {
    return mapped(picture.size(), [&](int x, int y) { return picture.at(x, y)[channel]; });
}

/// Channels outside [0, 1] are cut: what an 8-bit picture could show. NaN stays.
LinearPicture in_opponent_space(const LinearPicture& light) {
    return mapped(light.size(), [&](int x, int y) { return opponent(glm::clamp(light.at(x, y), 0.0, 1.0)); });
}

/// What is left of the colours at this distance, in Hunt-adjusted L*a*b*.
LinearPicture perceived(const LinearPicture& opponents) {
    const Channel a = seen_by_one(channel_of(opponents, 0), 0.0047),
                  rg = seen_by_one(channel_of(opponents, 1), 0.0053),
                  by = seen_by_two(channel_of(opponents, 2));
    return mapped(opponents.size(), [&](int x, int y) {
        const glm::dvec3 rgb = linear_from_opponent({a.at(x, y), rg.at(x, y), by.at(x, y)});
        return hunt_lab(glm::clamp(rgb, 0.0, 1.0));
    });
}

/// Maps the difference to [0, 1]: it stretches values below 0.4 of the greatest to 0.95 and squeezes those
/// above (4.1).
double colour_difference(const glm::dvec3& a, const glm::dvec3& b) {
    constexpr double exponent = 0.7, knee = 0.4, at_knee = 0.95;
    static const double greatest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), exponent);
    const double d = std::pow(hyab(a, b), exponent), bend = knee * greatest;
    if (d < bend) return d * at_knee / bend;
    return at_knee + (d - bend) / (greatest - bend) * (1 - at_knee);
}

/// Positive taps sum to 1, negative ones to -1 (4.2).
Taps balanced(Taps taps) {
    double up = 0, down = 0;
    for (const double tap : taps) (tap > 0 ? up : down) += tap;
    for (double& tap : taps) tap /= tap > 0 ? up : -down;
    return taps;
}

/// First and second derivative of a Gaussian, across its own smoothing.
struct FeatureKernels {
    Taps smooth, edge, point;
};

FeatureKernels feature_kernels() {
    const double deviation = 0.5 * 0.082 * pixels_per_degree;  // 0.082 degrees: the width of a feature (4.2)
    const int radius = int(std::ceil(3 * deviation));
    FeatureKernels kernels;
    for (int i = -radius; i <= radius; ++i) {
        const double t = i / deviation, g = std::exp(-t * t / 2);
        kernels.smooth.push_back(g);
        kernels.edge.push_back(-t * g);
        kernels.point.push_back((t * t - 1) * g);
    }
    return {normalised(kernels.smooth), balanced(kernels.edge), balanced(kernels.point)};
}

Channel length_of(const Channel& across, const Channel& along) {
    return mapped(across.size(), [&](int x, int y) { return std::hypot(across.at(x, y), along.at(x, y)); });
}

struct Features {
    Channel edges, points;
};

Features features_of(const LinearPicture& opponents) {
    const Channel light =
        mapped(opponents.size(), [&](int x, int y) { return (opponents.at(x, y).x + 16) / 116; });
    const FeatureKernels k = feature_kernels();
    return {length_of(convolved(light, k.edge, k.smooth), convolved(light, k.smooth, k.edge)),
            length_of(convolved(light, k.point, k.smooth), convolved(light, k.smooth, k.point))};
}

Plane<double> flip_map(const LinearPicture& candidate, const LinearPicture& truth) {
    require_one_size(candidate, truth);
    const LinearPicture a = in_opponent_space(candidate), b = in_opponent_space(truth);
    const LinearPicture seen_a = perceived(a), seen_b = perceived(b);
    const Features in_a = features_of(a), in_b = features_of(b);
    return mapped(truth.size(), [&](int x, int y) {
        const double edges = std::abs(in_a.edges.at(x, y) - in_b.edges.at(x, y)),
                     points = std::abs(in_a.points.at(x, y) - in_b.points.at(x, y));
        const double feature = std::sqrt(std::max(edges, points) / std::numbers::sqrt2);  // (4.2)
        return std::pow(colour_difference(seen_a.at(x, y), seen_b.at(x, y)),
                        1 - std::clamp(feature, 0.0, 1.0));  // (4.3)
    });
}

}  // namespace

PictureMetric flip_metric() {
    return {.name = "flip",
            .definition =
                "Mean LDR-FLIP at 67 pixels per degree (a 0.7 m wide 3840-pixel screen, seen from "
                "0.7 m); light is cut to [0, 1] and not quantised.",
            .source = "Andersson et al., FLIP: A Difference Evaluator for Alternating Images, HPG 2020",
            .map = flip_map,
            .pool = mean_of};
}

}  // namespace zproof
