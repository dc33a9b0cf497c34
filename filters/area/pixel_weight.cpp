#include "filters/area/pixel_weight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "filters/area/bilinear_moments.h"

namespace zproof::oracle::area {

namespace {

Draw drawn_from_square(const glm::dvec2& unit) { return {unit - 0.5}; }

/// exp(-v), v from 0 to 2, to 1e-12 of itself: a series at v / 64.
double exp_of_minus(double v) {
    const double w = v / 64;
    const double by_1 =
        1 - w * (1 - w * 0.5 * (1 - w * (1.0 / 3) * (1 - w * 0.25 * (1 - w * 0.2 * (1 - w * (1.0 / 6))))));
    const double by_4 = by_1 * by_1 * (by_1 * by_1), by_16 = by_4 * by_4 * (by_4 * by_4);
    return by_16 * by_16 * (by_16 * by_16);
}

/// exp(-2 r^2) is a product of these. A unit square's corners are pixels' centres. Sums of one pixel stand
/// side by side, so that the compiler does several at once.
void gaussian_along(std::span<const double> offsets, AxisWeights* factors) {
    std::array<double, most_nodes> first, second;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        first[i] = exp_of_minus(2 * (offsets[i] + 0.5) * (offsets[i] + 0.5));
        second[i] = exp_of_minus(2 * (offsets[i] - 0.5) * (offsets[i] - 0.5));
    }
    for (std::size_t i = 0; i < offsets.size(); ++i) factors[i] = {first[i], second[i]};
}

template <AxisWeights (*along)(double)>
void each_along(std::span<const double> offsets, AxisWeights* factors) {
    for (const double offset : offsets) *factors++ = along(offset);
}

/// A weight of x times the same of y, even, of one sign up to `turn` and of the other beyond.
struct Profile {
    double half_side, turn;
    double (*at)(double distance);    ///< from 0 to half_side
    double (*mass)(double distance);  ///< its integral from 0 on
    /// Draws beyond the turn: a power of 2, so that nets hold it exactly.
    double share_beyond;
};

/// Where the mass between two distances reaches a share of itself.
template <const Profile& profile>
class Distances {
  public:
    Distances(double low, double high) : from_(profile.mass(low)), all_(profile.mass(high) - from_) {
        at_share_.fill(low);
        at_share_.back() = high;
        for (std::size_t i = 1; low < high && i < parts; ++i)
            at_share_[i] = between(low, high, (low + high) / 2, double(i) / parts);
    }

    double mass() const { return all_; }
    double at(double share) const {
        const std::size_t i = std::min(std::size_t(share * parts), parts - 1);
        const double low = at_share_[i], high = at_share_[i + 1];
        return between(low, high, low + (share * parts - double(i)) * (high - low), share);
    }

  private:
    static constexpr std::size_t parts = 256;

    /// Newton's steps from x, or halving where they leave the bracket.
    double between(double low, double high, double x, double share) const {
        for (int step = 0; step < 64; ++step) {
            const double missing = share - (profile.mass(x) - from_) / all_;
            (missing > 0 ? low : high) = x;
            if (std::abs(missing) < 0x1p-36 || high - low < 0x1p-36) break;
            x += missing * all_ / profile.at(x);
            if (!(x > low && x < high)) x = (low + high) / 2;
        }
        return x;
    }

    double from_, all_;
    std::array<double, parts + 1> at_share_;
};

/// Over squared radii, on which masses under exp(-2 r^2) - exp(-2) have a closed form.
constexpr double gaussian_floor = 0.13533528323661269;  // exp(-2)
double gaussian_at(double squared) { return std::exp(-2 * squared) - gaussian_floor; }
double gaussian_mass(double squared) { return (1 - std::exp(-2 * squared)) / 2 - gaussian_floor * squared; }

constexpr Profile gaussian_profile{1, 1, gaussian_at, gaussian_mass, 0};

Draw drawn_from_gaussian(const glm::dvec2& unit) {
    static const Distances<gaussian_profile> squared(0, 1);
    const double radius = std::sqrt(squared.at(unit.x)), angle = 2 * std::numbers::pi * unit.y;
    return {radius * glm::dvec2{std::cos(angle), std::sin(angle)}};
}

/// A coordinate, and the weight there over the density of draws.
struct AxisDraw {
    double place, weight;
};

template <const Profile& profile>
AxisDraw drawn_along(double unit) {
    static const Distances<profile> within(0, profile.turn), beyond(profile.turn, profile.half_side);
    static const double half = within.mass() + beyond.mass();
    const bool is_beyond = unit < profile.share_beyond;
    const Distances<profile>& distances = is_beyond ? beyond : within;
    const double share = is_beyond ? profile.share_beyond : 1 - profile.share_beyond;
    const double side = 2 * (is_beyond ? unit : unit - profile.share_beyond) / share - 1;
    const double distance = distances.at(std::abs(side));
    return {side < 0 ? -distance : distance, distances.mass() / (share * half)};
}

template <const Profile& profile>
Draw drawn_from(const glm::dvec2& unit) {
    const AxisDraw x = drawn_along<profile>(unit.x), y = drawn_along<profile>(unit.y);
    return {{x.place, y.place}, x.weight * y.weight};
}

/// Mitchell and Netravali (1988), B = C = 1/3: cubics that meet at 1 px and end at 2 px.
double mitchell_within(double x) { return ((7 * x - 12) * x * x + 16.0 / 3) / 6; }
double mitchell_beyond(double x) {
    const double y = 2 - x;
    return (7 * y - 6) * y * y / 18;
}
double mitchell_at(double x) { return x < 1 ? mitchell_within(x) : mitchell_beyond(x); }
double mitchell_mass(double x) {
    const double y = 2 - x;
    return x < 1 ? ((7 * x / 4 - 4) * x * x + 16.0 / 3) * x / 6 : 0.5 + (2 - 7 * y / 4) * y * y * y / 18;
}
AxisWeights mitchell_along(double x) {
    return {mitchell_beyond(1.5 + x), mitchell_within(0.5 + x), mitchell_within(0.5 - x),
            mitchell_beyond(1.5 - x)};
}

constexpr Profile mitchell_profile{2, 8.0 / 7, mitchell_at, mitchell_mass, 1.0 / 16};

/// The four-term window of Harris (1978), 3 px from end to end.
constexpr std::array harris{0.35875, 0.48829, 0.14128, 0.01168};
constexpr double harris_turn = 2 * std::numbers::pi / 3;  // of a pixel
double harris_of(double c) {
    return harris[0] + harris[1] * c + harris[2] * (2 * c * c - 1) + harris[3] * (4 * c * c - 3) * c;
}
double harris_at(double x) { return harris_of(std::cos(harris_turn * x)); }
double harris_mass(double x) {
    const double c = std::cos(harris_turn * x), s = std::sin(harris_turn * x);
    return harris[0] * x + (harris[1] + harris[2] * c + harris[3] * (4 * c * c - 1) / 3) * s / harris_turn;
}
/// A pixel on is a third of a turn.
AxisWeights harris_along(double x) {
    const double c = std::cos(harris_turn * x) / 2, s = std::sqrt(0.75) * std::sin(harris_turn * x);
    return {harris_of(-c - s), harris_of(2 * c), harris_of(-c + s)};
}

constexpr Profile harris_profile{1.5, 1.5, harris_at, harris_mass, 0};

/// The unit square in n by n squares, each for all pixels.
std::vector<WeightBlock> square_blocks(int n, int across) {
    const auto line = [&](int i) { return double(2 * i - n) / (2 * n); };
    std::vector<WeightBlock> blocks;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const double left = line(column), right = line(column + 1), top = line(row),
                         bottom = line(row + 1);
            blocks.push_back({{{left, top}, {right, top}, {right, bottom}, {left, bottom}},
                              (1U << (across * across)) - 1});
        }
    return blocks;
}

/// What a polygon has in common with the disk of radius 1 px round a place: its rim is a regular polygon
/// whose corners lie on it.
Polygon<double> within_disk(Polygon<double> polygon, const Point<double>& middle) {
    constexpr int rim_corners = 64;
    for (int i = 0; i < rim_corners; ++i) {
        const double angle = (2 * i + 1) * std::numbers::pi / rim_corners;
        const double x = std::cos(angle), y = std::sin(angle);
        const Affine<double> inward{-x, -y,
                                    std::cos(std::numbers::pi / rim_corners) + x * middle.x + y * middle.y};
        const Halves<double> halves = cut(polygon, inward);
        if (halves.outside.size() > 2) polygon = halves.inside;
    }
    return polygon;
}

/// Squares of 1/4 px: what lies within several pixels' disks once for all of these, what a rim cuts once for
/// its pixel.
std::vector<WeightBlock> disk_blocks() {
    std::vector<WeightBlock> blocks;
    for (WeightBlock block : square_blocks(4, 2)) {
        const Polygon<double> whole = block.polygon;
        block.pixels = 0;
        for (int pixel = 0; pixel < 4; ++pixel) {
            const Polygon<double> part = within_disk(whole, {pixel % 2 - 0.5, pixel / 2 - 0.5});
            if (part.size() < 3) continue;
            if (area_of(part) == area_of(whole))
                block.pixels |= 1U << pixel;
            else
                blocks.push_back({part, 1U << pixel});
        }
        if (block.pixels != 0) blocks.push_back(block);
    }
    return blocks;
}

double sum_of(const PixelWeight& weight, const WeightBlock& block) {
    const Affine<double> one{0, 0, 1};
    const auto sum = [&]<int across>(std::integral_constant<int, across>) {
        const auto masses = bilinear_moments<across>(block.polygon, {one, one, one}, weight).one;
        double all = 0;
        for (int pixel = 0; pixel < across * across; ++pixel)
            if (block.counts_for(pixel)) all += masses[std::size_t(pixel)];
        return all;
    };
    return for_across(weight.across, sum);
}

/// With its total: what one unit square weighs for all its pixels is what one pixel's squares weigh.
PixelWeight summed(PixelWeight weight) {
    weight.total = 0;
    for (const WeightBlock& block : weight.blocks) weight.total += sum_of(weight, block);
    return weight;
}

constexpr double any_side = std::numeric_limits<double>::infinity();

}  // namespace

const PixelWeight& weight_of(Reconstruction reconstruction) {
    static const PixelWeight box{.rules = {{any_side, rule_of_degree_5()}}, .drawn = drawn_from_square};
    static const PixelWeight gaussian =
        summed({.half_side = 1,
                .across = 2,
                .along = gaussian_along,
                .at_rim = gaussian_floor,
                .blocks = disk_blocks(),
                .rules = {{0.05, rule_of_degree_5()}, {any_side, rule_of_degree_8()}},
                .error = 5.4e-5,
                .cost = 4,
                .drawn = drawn_from_gaussian});
    static const PixelWeight mitchell =
        summed({.half_side = 2,
                .across = 4,
                .along = each_along<mitchell_along>,
                .blocks = square_blocks(1, 4),
                .rules = {{1.0 / 8, rule_of_degree_8()}, {any_side, rule_of_degree_10()}},
                .error = 3e-6,
                .cost = 2,
                .drawn = drawn_from<mitchell_profile>,
                .greatest_draw = 1.2188});
    static const PixelWeight blackman_harris =
        summed({.half_side = 1.5,
                .across = 3,
                .along = each_along<harris_along>,
                .blocks = square_blocks(2, 3),
                .rules = {{1.0 / 4, rule_of_degree_8()}, {any_side, rule_of_degree_10()}},
                .error = 1.6e-5,
                .cost = 8,
                .drawn = drawn_from<harris_profile>});
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
