#include "lessons/depth/gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenes/suite/random.h"

namespace zproof::study::depth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int side_px = 48, triangles_per_distance = 6, most_rungs = 80;
constexpr double place_spread = 1 + 1.0 / 64;

/// A triangle in the image with its corners' depths in double, and the pixels that it covers.
struct Probe {
    std::array<glm::dvec2, 3> p_raster;
    std::array<double, 3> depth;
    std::vector<Pixel> pixels;

    Drawn at(double scale) const {
        return {p_raster, {float(depth[0] * scale), float(depth[1] * scale), float(depth[2] * scale)}};
    }
};

std::vector<Pixel> covered(const Drawn& triangle) {
    std::vector<Pixel> pixels;
    for (int y = 0; y < side_px; ++y)
        for (int x = 0; x < side_px; ++x) {
            const auto w = weights_at(triangle, {x + 0.5, y + 0.5});
            if (w[0] >= 0 && w[1] >= 0 && w[2] >= 0) pixels.push_back({x, y});
        }
    return pixels;
}

Probe probe_at(double depth, suite::Random& random) {
    const auto place = [&] { return glm::dvec2{random.uniform(0, side_px), random.uniform(0, side_px)}; };
    const auto distance = [&] { return depth * random.uniform(1 / place_spread, place_spread); };
    while (true) {
        Probe probe{{place(), place(), place()}, {distance(), distance(), distance()}, {}};
        if (std::abs(probe.at(1).doubled_area()) < side_px) continue;
        probe.pixels = covered(probe.at(1));
        if (probe.pixels.size() >= 8) return probe;
    }
}

bool keeps_order(const Probe& probe, const Coder& coder, Interpolation interpolation, double rho) {
    const std::vector<float> front = interpolated(probe.at(1), probe.pixels, coder, interpolation);
    const std::vector<float> back = interpolated(probe.at(1 + rho), probe.pixels, coder, interpolation);
    for (std::size_t i = 0; i < front.size(); ++i)
        if (!coder.is_nearer(coder.stored(front[i]), coder.stored(back[i]))) return false;
    return true;
}

/// The least rho of the ladder down to which all of it is ordered right; +inf where not even the first is.
double smallest_rho(const std::vector<Probe>& probes, const Coder& coder, Interpolation interpolation,
                    double first) {
    double last_right = infinity;
    for (int rung = 0; rung < most_rungs; ++rung) {
        const double rho = first * std::exp2(-rung / 8.0);
        const auto is_right = [&](const Probe& p) { return keeps_order(p, coder, interpolation, rho); };
        if (!std::ranges::all_of(probes, is_right)) break;
        last_right = rho;
    }
    return last_right;
}

/// The largest predicted gap of a probe's pixels, as a share of their depth: at either end of their depths,
/// or where s passes a power of two and a float32's step is largest beside it.
double predicted_rho(const Coder& coder, Interpolation interpolation, double depth) {
    const double nearest = depth / place_spread, farthest = depth * place_spread;
    std::vector<double> depths{nearest, farthest};
    const double a = coder.ideal(nearest), b = coder.ideal(farthest);
    const int exponent = std::ilogb(std::max(a, b));
    if (std::min(a, b) < std::ldexp(1.0, exponent))
        depths.push_back(coder.depth_of(std::ldexp(1.0, exponent)));
    double largest = 0;
    for (const double d : depths)
        largest =
            std::max(largest, smallest_gap_behind(coder, interpolation, d, place_spread * place_spread) / d);
    return largest;
}

/// Four times what is predicted, on the ladder that holds the prediction itself, or what far leaves room for.
double first_rho(const GapAt& point, double room) {
    if (!std::isfinite(point.predicted)) return room;
    const double predicted = point.predicted / point.depth;
    return predicted * std::exp2(std::min(16.0, std::floor(8 * std::log2(room / predicted))) / 8);
}

GapAt gap_at(const Coder& coder, Interpolation interpolation, const Planes& planes, double depth) {
    GapAt point{depth, depth * predicted_rho(coder, interpolation, depth), infinity};
    suite::Random random{17};
    std::vector<Probe> probes;
    for (int i = 0; i < triangles_per_distance; ++i) probes.push_back(probe_at(depth, random));
    const double room = planes.far / (depth * place_spread) - 1;  // rho of far
    if (room > 0) point.measured = depth * smallest_rho(probes, coder, interpolation, first_rho(point, room));
    return point;
}

}  // namespace

GapCurve gap_curve(const Format& format, Interpolation interpolation, const Planes& planes, int distances) {
    GapCurve curve{format, interpolation, planes, {}};
    const Coder coder{format, planes};
    const double first = planes.near * place_spread, last = planes.far / (place_spread * place_spread);
    for (int i = 0; i < distances; ++i) {
        const double depth = first * std::pow(last / first, double(i) / (distances - 1));
        curve.points.push_back(gap_at(coder, interpolation, planes, depth));
    }
    return curve;
}

}  // namespace zproof::study::depth
