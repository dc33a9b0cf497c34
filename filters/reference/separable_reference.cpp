#include <cmath>
#include <memory>
#include <numbers>

#include "filters/reference/levels.h"

namespace zproof::oracle::filter_reference {

namespace {

/// The weights of four texels on a line; the place lies a share of the way from the second to the third.
using Weights = std::array<Interval, 4>;
using WeightsAt = Weights (*)(const Interval& share);

Interval cube(const Interval& a) { return a * square(a); }

/// Keys 1981, a = -1/2, at distance d = |x| from a texel's centre, within one and beyond.
Interval catmull_rom_near(const Interval& d) {
    return Interval{1} + square(d) * (Interval{1.5} * d - Interval{2.5});
}
Interval catmull_rom_far(const Interval& d) {
    return Interval{2} + d * (Interval{-4} + d * (Interval{2.5} - Interval{0.5} * d));
}

Weights catmull_rom_weights(const Interval& share) {
    const Interval one{1};
    return {catmull_rom_far(one + share), catmull_rom_near(share), catmull_rom_near(one - share),
            catmull_rom_far(Interval{2} - share)};
}

/// Vulkan, VK_CUBIC_FILTER_WEIGHTS_B_SPLINE: (1 t t^2 t^3) times a matrix, over 6.
Weights b_spline_weights(const Interval& t) {
    const Interval one{1}, three{3}, sixth = one / Interval{6}, t2 = square(t), t3 = cube(t);
    return {sixth * cube(one - t), sixth * (Interval{4} - Interval{6} * t2 + three * t3),
            sixth * (one + three * (t + t2 - t3)), sixth * t3};
}

/// Divided by their sum.
Weights divided(Weights weights) {
    const Interval sum = weights[0] + weights[1] + weights[2] + weights[3];
    for (Interval& weight : weights) weight = weight / sum;
    return weights;
}

/// Profiles of the distance from a texel's centre, by their value in the middle and their steepest slope.
Weights by_slope(const Interval& share, double (*profile)(double), double steepest) {
    const double t = middle(share), error = steepest * radius(share) + 0x1p-46;
    Weights weights;
    for (int i = 0; i < 4; ++i)
        weights[std::size_t(i)] = widen(Interval{profile(std::abs(t - (i - 1)))}, error);
    return divided(weights);
}

/// |d sinc(x) / dx| < 1.4, so that of the product is below 1.4 (1 + 1/2).
double lanczos_of_two_lobes(double d) {
    if (d >= 2) return 0;
    const double x = std::numbers::pi * d;
    return x == 0 ? 1 : 2 * std::sin(x) * std::sin(x / 2) / (x * x);
}
Weights lanczos_weights(const Interval& share) { return by_slope(share, lanczos_of_two_lobes, 2.1); }

/// |d exp(-2 x^2) / dx| <= 2 exp(-1/2) < 1.3.
double cut_gaussian(double d) { return d >= 2 ? 0 : std::exp(-2 * d * d) - std::exp(-8.0); }
Weights gaussian_weights(const Interval& share) { return by_slope(share, cut_gaussian, 1.3); }

/// The part of an interval that lies between two centres, and the texel before it.
struct Piece {
    std::int64_t first;
    Interval share;
};

/// A place this wide is known to nobody (a rule relaxed in search of a cause).
constexpr double widest_place = 8;

std::vector<Piece> pieces(const Interval& at) {
    if (!(at.high() - at.low() < widest_place)) throw UndecidedSign{};
    std::vector<Piece> all;
    for (double k = std::floor(at.low()); k <= at.high(); ++k)
        all.push_back({std::int64_t(k), clamped(at, k, k + 1) - Interval{k}});
    return all;
}

struct Source {
    std::shared_ptr<const IntervalImage> image;
    WrapRules wrap;
};

ColourRange weighted_sixteen(const Source& source, const Piece& u, const Piece& v, const Weights& across,
                             const Weights& down) {
    ColourRange sum;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const auto& texel =
                source.image->at(wrapped_index(source.wrap.u, u.first + i - 1, source.image->width),
                                 wrapped_index(source.wrap.v, v.first + j - 1, source.image->height));
            sum = sum + across[std::size_t(i)] * down[std::size_t(j)] * around(texel.value, texel.radius);
        }
    return sum;
}

ColourRange hull_of_all(const std::vector<ColourRange>& all) {
    ColourRange whole = all.front();
    for (const ColourRange& range : all) whole = hull(whole, range);
    return whole;
}

TexelInterval seen_place(const Source& source, const FilterQuery& q) {
    return place_in(*source.image, *source.image, q.seen.at(q.x + 0.5, q.y + 0.5), q.precision);
}

Weights good_to(Weights weights, double error) {
    for (Interval& weight : weights) weight = widen(weight, error);
    return weights;
}

ColourRange sixteen_texels(const Source& source, const FilterQuery& q, WeightsAt weights_at) {
    const TexelInterval place = seen_place(source, q);
    const double error = std::exp2(-q.precision.weight_bits);
    std::vector<ColourRange> all;
    for (const Piece& v : pieces(place.v - Interval{0.5}))
        for (const Piece& u : pieces(place.u - Interval{0.5}))
            all.push_back(weighted_sixteen(source, u, v, good_to(weights_at(u.share), error),
                                           good_to(weights_at(v.share), error)));
    return hull_of_all(all);
}

template <WeightsAt weights_at>
MethodReference separable_reference(const texture::LinearImage& image, const Settings& settings) {
    return [source = Source{exact_level(image, settings), settings.wrap}](
               const FilterQuery& q) -> PermittedColours { return {sixteen_texels(source, q, weights_at)}; };
}

/// Sigg and Hadwiger 2005: weights w0 to w3 as two linear reads.
struct LinearReads {
    std::array<Interval, 2> places, weights;

    LinearReads(const Piece& piece, double error) {
        const Weights w = b_spline_weights(piece.share);
        for (std::size_t pair = 0; pair < 2; ++pair) {
            const Interval sum = w[2 * pair] + w[2 * pair + 1];
            weights[pair] = widen(sum, error);
            // Texel `first` has its centre at first + 1/2; the pairs begin one before it and one behind it.
            places[pair] = Interval{double(piece.first) + 2 * double(pair) - 0.5} + w[2 * pair + 1] / sum;
        }
    }
};

ColourRange four_reads(const Source& source, const FilterQuery& q) {
    const TexelInterval place = seen_place(source, q);
    const double error = std::exp2(-q.precision.weight_bits);
    std::vector<ColourRange> all;
    for (const Piece& row : pieces(place.v - Interval{0.5}))
        for (const Piece& column : pieces(place.u - Interval{0.5})) {
            const LinearReads u{column, error}, v{row, error};
            ColourRange sum;
            for (std::size_t down = 0; down < 2; ++down)
                for (std::size_t right = 0; right < 2; ++right) {
                    const TexelInterval at{u.places[right], v.places[down]};
                    const TexelInterval read = place_in(*source.image, *source.image, at, q.precision);
                    sum = sum + u.weights[right] * v.weights[down] *
                                    bilinear(*source.image, source.wrap, read, q.precision);
                }
            all.push_back(sum);
        }
    return hull_of_all(all);
}

MethodReference b_spline_by_reads(const texture::LinearImage& image, const Settings& settings) {
    return [source = Source{exact_level(image, settings), settings.wrap}](
               const FilterQuery& q) -> PermittedColours { return {four_reads(source, q)}; };
}

/// Trilinear, level 0 by the B-spline. Affine in the LOD between whole levels, so the ends hold the extremes.
MethodReference smart_bicubic(const texture::LinearImage& image, const Settings& settings) {
    return [levels = std::make_shared<const Levels>(image, settings),
            source = Source{exact_level(image, settings), settings.wrap}](
               const FilterQuery& q) -> PermittedColours {
        const PixelFootprint f = q.footprint();
        const Interval level =
            level_of(lod(LodRule::gl_maximum, f), levels->settings(), levels->count(), q.precision);
        std::vector<ColourRange> all;
        if (level.low() < 1) {
            const ColourRange finest = sixteen_texels(source, q, b_spline_weights);
            const double error = std::exp2(-q.precision.weight_bits);
            const Interval share = clamped(widen(clamped(level, 0, 1), error), 0, 1);
            all.push_back(levels->count() == 1
                              ? finest
                              : blended(finest, levels->bilinear_in(1, f.centre, q.precision), share));
        }
        if (level.high() >= 1)
            all.push_back(levels->trilinear(larger(level, Interval{1}), f.centre, q.precision));
        return {hull_of_all(all)};
    };
}

}  // namespace

std::vector<Definition> separable_definitions() {
    return {{"bicubic", separable_reference<catmull_rom_weights>},
            {"bspline", separable_reference<b_spline_weights>},
            {"bspline-bilinear", b_spline_by_reads},
            {"lanczos2", separable_reference<lanczos_weights>},
            {"gaussian", separable_reference<gaussian_weights>},
            {"smart-bicubic", smart_bicubic}};
}

}  // namespace zproof::oracle::filter_reference
