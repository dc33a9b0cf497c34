#include "filters/area/pixel_weight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "filters/area/bilinear_moments.h"

namespace zproof::oracle::area {

namespace {

Draw drawn_from_square(const glm::dvec2& unit) { return {unit - 0.5}; }

/// exp(-2 r^2) - exp(-2) for r < 1 px, else 0.
double gaussian_at(const Point<double>& p) {
    static const double at_rim = std::exp(-2.0);
    return std::max(std::exp(-2 * (p.x * p.x + p.y * p.y)) - at_rim, 0.0);
}

/// The squared radius within which lies a share of the Gaussian. With q = r^2, the share is (1 - exp(-2 q)) /
/// 2 - exp(-2) q over its value at 1. Newton's method starts at 0 and never overshoots, since the share is
/// concave in q.
double gaussian_radius_squared(double share) {
    static const double floor_weight = std::exp(-2.0), all = (1 - floor_weight) / 2 - floor_weight;
    double q = 0;
    for (int step = 0; step < 64; ++step) {
        const double weight = std::exp(-2 * q) - floor_weight;
        const double missing = share * all - ((1 - std::exp(-2 * q)) / 2 - floor_weight * q);
        if (!(weight > 0) || !(missing > 0x1p-50)) break;
        q = std::min(q + missing / weight, 1.0);
    }
    return q;
}

Draw drawn_from_gaussian(const glm::dvec2& unit) {
    const double radius = std::sqrt(gaussian_radius_squared(unit.x)), angle = 2 * std::numbers::pi * unit.y;
    return {radius * glm::dvec2{std::cos(angle), std::sin(angle)}};
}

/// A weight of x times the same of y, even, of one sign up to `turn` and of the other beyond.
struct Profile {
    double half_side, turn;
    double (*at)(double distance);    ///< from 0 to half_side
    double (*mass)(double distance);  ///< its integral from 0 on
    /// Draws beyond the turn: a power of 2, so that nets hold it exactly.
    double share_beyond;
};

/// Where the mass between two distances reaches a share: Newton's steps, or halving where they leave the
/// bracket.
double distance_of(const Profile& profile, double low, double high, double share) {
    const double from = profile.mass(low), all = profile.mass(high) - from;
    double x = (low + high) / 2;
    for (int step = 0; step < 64; ++step) {
        const double missing = share - (profile.mass(x) - from) / all;
        (missing > 0 ? low : high) = x;
        if (std::abs(missing) < 0x1p-50 || high - low < 0x1p-50) break;
        x += missing * all / profile.at(x);
        if (!(x > low && x < high)) x = (low + high) / 2;
    }
    return x;
}

/// A coordinate, and the weight there over the density of draws.
struct AxisDraw {
    double place, weight;
};

AxisDraw drawn_along(const Profile& profile, double unit) {
    const bool is_beyond = unit < profile.share_beyond;
    const double low = is_beyond ? profile.turn : 0, high = is_beyond ? profile.half_side : profile.turn;
    const double share = is_beyond ? profile.share_beyond : 1 - profile.share_beyond;
    const double side = 2 * (is_beyond ? unit : unit - profile.share_beyond) / share - 1;
    const double distance = distance_of(profile, low, high, std::abs(side));
    return {side < 0 ? -distance : distance,
            (profile.mass(high) - profile.mass(low)) / (share * profile.mass(profile.half_side))};
}

Draw drawn_from(const Profile& profile, const glm::dvec2& unit) {
    const AxisDraw x = drawn_along(profile, unit.x), y = drawn_along(profile, unit.y);
    return {{x.place, y.place}, x.weight * y.weight};
}

double at_place(const Profile& profile, const Point<double>& p) {
    return profile.at(std::abs(p.x)) * profile.at(std::abs(p.y));
}

/// Mitchell and Netravali (1988), B = C = 1/3: cubics that meet at 1 px and end at 2 px.
double mitchell_along(double x) {
    const double y = 2 - x;
    return x < 1 ? ((7 * x - 12) * x * x + 16.0 / 3) / 6 : (7 * y - 6) * y * y / 18;
}
double mitchell_mass(double x) {
    const double y = 2 - x;
    return x < 1 ? ((7 * x / 4 - 4) * x * x + 16.0 / 3) * x / 6 : 0.5 + (2 - 7 * y / 4) * y * y * y / 18;
}

constexpr Profile mitchell_profile{2, 8.0 / 7, mitchell_along, mitchell_mass, 1.0 / 16};
double mitchell_at(const Point<double>& p) { return at_place(mitchell_profile, p); }
Draw drawn_from_mitchell(const glm::dvec2& unit) { return drawn_from(mitchell_profile, unit); }

/// The four-term window of Harris (1978), 3 px from end to end.
constexpr std::array harris{0.35875, 0.48829, 0.14128, 0.01168};
constexpr double harris_px = 3;
double harris_along(double x) {
    const double c = std::cos(2 * std::numbers::pi / harris_px * x);
    return harris[0] + harris[1] * c + harris[2] * (2 * c * c - 1) + harris[3] * (4 * c * c - 3) * c;
}
double harris_mass(double x) {
    double sum = harris[0] * x;
    for (std::size_t k = 1; k < harris.size(); ++k) {
        const double frequency = 2 * std::numbers::pi / harris_px * double(k);
        sum += harris[k] * std::sin(frequency * x) / frequency;
    }
    return sum;
}

constexpr Profile harris_profile{harris_px / 2, harris_px / 2, harris_along, harris_mass, 0};
double blackman_harris_at(const Point<double>& p) { return at_place(harris_profile, p); }
Draw drawn_from_blackman_harris(const glm::dvec2& unit) { return drawn_from(harris_profile, unit); }

/// The square |x|, |y| <= half_side in n by n squares.
std::vector<Polygon<double>> square_blocks(double half_side, int n) {
    const auto line = [&](int i) { return half_side * (2 * i - n) / n; };
    std::vector<Polygon<double>> blocks;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const double left = line(column), right = line(column + 1), top = line(row),
                         bottom = line(row + 1);
            blocks.push_back({{left, top}, {right, top}, {right, bottom}, {left, bottom}});
        }
    return blocks;
}

/// The disk of radius 1 px in squares of 1/4 px; its rim is a regular polygon whose corners lie on it.
std::vector<Polygon<double>> disk_blocks() {
    constexpr int rim_corners = 64;
    std::vector<Polygon<double>> blocks = square_blocks(1, 8);
    for (Polygon<double>& block : blocks)
        for (int i = 0; i < rim_corners; ++i) {
            const double angle = (2 * i + 1) * std::numbers::pi / rim_corners;
            block = cut(block, Affine<double>{-std::cos(angle), -std::sin(angle),
                                              std::cos(std::numbers::pi / rim_corners)})
                        .inside;
        }
    std::erase_if(blocks, [](const Polygon<double>& block) { return block.size() < 3; });
    return blocks;
}

/// With its total.
PixelWeight summed(PixelWeight weight) {
    const Affine<double> one{0, 0, 1};
    weight.total = 0;
    for (const Polygon<double>& block : weight.blocks)
        weight.total += weighted_moments(block, {one, one, one}, weight).one;
    return weight;
}

}  // namespace

const PixelWeight& weight_of(Reconstruction reconstruction) {
    static const PixelWeight box{.drawn = drawn_from_square};
    static const PixelWeight gaussian = summed({.half_side = 1,
                                                .at = gaussian_at,
                                                .blocks = disk_blocks(),
                                                .rule = rule_of_degree_8(),
                                                .error = 5.4e-5,
                                                .cost = 4,
                                                .drawn = drawn_from_gaussian});
    static const PixelWeight mitchell = summed({.half_side = 2,
                                                .at = mitchell_at,
                                                .blocks = square_blocks(2, 4),
                                                .rule = rule_of_degree_10(),
                                                .error = 3e-7,
                                                .cost = 2,
                                                .drawn = drawn_from_mitchell,
                                                .greatest_draw = 1.2188});
    static const PixelWeight blackman_harris = summed({.half_side = harris_px / 2,
                                                       .at = blackman_harris_at,
                                                       .blocks = square_blocks(harris_px / 2, 6),
                                                       .rule = rule_of_degree_10(),
                                                       .error = 1.6e-5,
                                                       .cost = 8,
                                                       .drawn = drawn_from_blackman_harris});
    switch (reconstruction) {
        case Reconstruction::gaussian:
        case Reconstruction::gaussian_of_nearest:
            return gaussian;
        case Reconstruction::mitchell:
            return mitchell;
        case Reconstruction::blackman_harris:
            return blackman_harris;
        case Reconstruction::nearest:
        case Reconstruction::bilinear:
            break;
    }
    return box;
}

}  // namespace zproof::oracle::area
