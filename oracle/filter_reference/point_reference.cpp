#include "oracle/filter_reference/filter_query.h"

namespace zproof::oracle::filter_reference {

namespace {

MethodReference nearest_reference(const texture::LinearImage& image, const Settings& settings) {
    return [level = exact_image(image), wrap = settings.wrap](const FilterQuery& q) {
        return nearest(level, wrap, place_in(level, level, q.seen.at(q.x + 0.5, q.y + 0.5), q.precision));
    };
}

MethodReference bilinear_reference(const texture::LinearImage& image, const Settings& settings) {
    return [level = exact_image(image), wrap = settings.wrap](const FilterQuery& q) -> PermittedColours {
        const TexelInterval place = place_in(level, level, q.seen.at(q.x + 0.5, q.y + 0.5), q.precision);
        return {bilinear(level, wrap, place, q.precision)};
    };
}

enum class CubicPart { within_one, beyond_one };

/// Keys 1981, a = -1/2, at distance d = |x| from a texel's centre.
Interval catmull_rom(const Interval& d, CubicPart side) {
    const Interval one{1}, two{2}, half{0.5};
    if (side == CubicPart::within_one) return one + square(d) * (Interval{1.5} * d - Interval{2.5});
    return two + d * (Interval{-4} + d * (Interval{2.5} - half * d));
}

/// Weights of the four texels around a place whose share of the way to the next centre is in [0, 1].
std::array<Interval, 4> cubic_weights(const Interval& share, double error) {
    const Interval one{1};
    std::array<Interval, 4> w{catmull_rom(one + share, CubicPart::beyond_one),
                              catmull_rom(share, CubicPart::within_one),
                              catmull_rom(one - share, CubicPart::within_one),
                              catmull_rom(Interval{2} - share, CubicPart::beyond_one)};
    for (Interval& weight : w) weight = widen(weight, error);
    return w;
}

/// The part of an interval that lies between two centres, and the texel before it.
struct Piece {
    std::int64_t first;
    Interval share;
};

std::vector<Piece> pieces(const Interval& at) {
    std::vector<Piece> all;
    for (double k = std::floor(at.low()); k <= at.high(); ++k)
        all.push_back({std::int64_t(k), clamped(at, k, k + 1) - Interval{k}});
    return all;
}

ColourRange bicubic(const IntervalImage& image, const WrapRules& wrap, const TexelInterval& place,
                    double error) {
    std::vector<ColourRange> all;
    for (const Piece& v : pieces(place.v - Interval{0.5})) {
        for (const Piece& u : pieces(place.u - Interval{0.5})) {
            const auto across = cubic_weights(u.share, error), down = cubic_weights(v.share, error);
            ColourRange sum;
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i) {
                    const auto& texel = image.at(standing_at(wrap.u, u.first + i - 1, image.width),
                                                 standing_at(wrap.v, v.first + j - 1, image.height));
                    sum = sum +
                          across[std::size_t(i)] * down[std::size_t(j)] * around(texel.value, texel.radius);
                }
            all.push_back(sum);
        }
    }
    ColourRange whole = all.front();
    for (const ColourRange& range : all) whole = hull(whole, range);
    return whole;
}

MethodReference bicubic_reference(const texture::LinearImage& image, const Settings& settings) {
    return [level = exact_image(image), wrap = settings.wrap](const FilterQuery& q) -> PermittedColours {
        const TexelInterval place = place_in(level, level, q.seen.at(q.x + 0.5, q.y + 0.5), q.precision);
        return {bicubic(level, wrap, place, std::exp2(-q.precision.weight_bits))};
    };
}

}  // namespace

std::vector<Definition> point_definitions() {
    return {{"nearest", nearest_reference}, {"bilinear", bilinear_reference}, {"bicubic", bicubic_reference}};
}

}  // namespace zproof::oracle::filter_reference
