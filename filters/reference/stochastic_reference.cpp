#include <memory>

#include "filters/reference/blue_noise.h"
#include "filters/reference/levels.h"

namespace zproof::oracle::filter_reference {

namespace {

/// One of two neighbours on a line is drawn, each with the probability of its linear weight.
struct Choice {
    std::int64_t index;
    Interval probability;
    double slope;  ///< change of the probability where the place moves on
};

/// Weight 1 - |p - i| of the whole number i for a place p between its neighbours. Where intervals do not know
/// between which, three are possible.
std::vector<Choice> neighbours(const Interval& place, double error) {
    std::vector<Choice> all;
    for (double i = std::floor(place.low()); i <= std::floor(place.high()) + 1; ++i) {
        const Interval weight = Interval{1} - magnitude(place - Interval{i});
        all.push_back({std::int64_t(i), clamped(widen(weight, error), 0, 1), i > middle(place) ? 1.0 : -1.0});
    }
    return all;
}

ColourDraw draw_of(const IntervalImage::Texel& texel, const Choice& u, const Choice& v, const Choice& level) {
    const double across = middle(u.probability), down = middle(v.probability),
                 deep = middle(level.probability);
    return {u.probability * v.probability * level.probability,
            around(texel.value, texel.radius),
            {u.slope * down * deep, across * v.slope * deep, across * down * level.slope,
             u.slope * v.slope * deep}};
}

/// A place this wide is known to nobody (the plane's horizon, or a rule relaxed in search of a cause).
constexpr double widest_draw = 8;

void add_draws_of_level(const Levels& levels, const Choice& level, const FilterQuery& q, ColourDraws& all) {
    const IntervalImage& image = levels.at(int(level.index));
    const TexelInterval place = place_in(image, levels.at(0), q.footprint().centre, q.precision);
    const Interval half{0.5}, u = place.u - half, v = place.v - half;
    if (!(u.high() - u.low() < widest_draw && v.high() - v.low() < widest_draw)) throw UndecidedSign{};
    const double error = std::exp2(-q.precision.weight_bits);
    const WrapRules& wrap = levels.settings().wrap;
    for (const Choice& row : neighbours(v, error))
        for (const Choice& column : neighbours(u, error)) {
            const auto& texel = image.at(wrapped_index(wrap.u, column.index, image.width),
                                         wrapped_index(wrap.v, row.index, image.height));
            all.draws.push_back(draw_of(texel, column, row, level));
        }
}

ColourDraws trilinear_draws(const Levels& levels, const FilterQuery& q) {
    const Interval level =
        level_of(lod(LodRule::gl_maximum, q.footprint()), levels.settings(), levels.count(), q.precision);
    ColourDraws all{levels.settings().samples, {}};
    for (const Choice& choice : neighbours(level, std::exp2(-q.precision.weight_bits)))
        if (choice.index < std::int64_t(levels.count())) add_draws_of_level(levels, choice, q, all);
    return all;
}

ColourDraws bilinear_draws(const Levels& levels, const FilterQuery& q) {
    ColourDraws all{levels.settings().samples, {}};
    add_draws_of_level(levels, {0, Interval{1}, 0}, q, all);
    return all;
}

/// One sample is a texel; the mean of several lies within the texels' range.
PermittedColours permitted_by(const ColourDraws& all) {
    PermittedColours possible;
    for (const ColourDraw& draw : all.draws)
        if (draw.probability.high() > 0) possible.push_back(draw.colour);
    if (all.samples == 1) return possible;
    ColourRange range = possible.front();
    for (const ColourRange& colour : possible) range = hull(range, colour);
    return {range};
}

/// What a number between 0 and 1 decides, and what it leaves of itself for the next decision.
struct Decided {
    std::int64_t index;
    Interval left;
};

/// Jimenez 2014, of pixel and frame. Its inner sum is of some hundreds, of which 53 times the rounding is
/// kept.
Interval interleaved_number(int x, int y, std::uint32_t frame) {
    const Interval offset = Interval{5.588238} * Interval{double(frame % 64)};
    const Interval inner = Interval{0.06711056} * (Interval{double(x)} + offset) +
                           Interval{0.00583715} * (Interval{double(y)} + offset);
    const auto fraction = [](const Interval& a) {
        const double whole = std::floor(a.low());
        return a.high() < whole + 1 ? a - Interval{whole} : Interval{0, 1};
    };
    const double rounding = 16 * 0x1p-53 * (1 + magnitude(inner).high());
    return fraction(Interval{52.9829189} * widen(fraction(inner), rounding));
}

/// The mask's rank in 4096ths, in the middle of its step, and so many golden ratios of 2^32 further.
Interval blue_number(int x, int y, std::uint32_t frame) {
    const int rank = mask_ranks()[std::size_t(y % mask_side * mask_side + x % mask_side)];
    const std::uint64_t steps =
        (2 * std::uint64_t(rank) + 1) * (1u << 19) + std::uint64_t{frame} * 2654435769u;
    return Interval{double(steps % (std::uint64_t{1} << 32)) / 0x1p32};
}

/// Between the whole numbers around a place, by the share of the second. Quotients have a few roundings.
std::vector<Decided> decided(const Interval& number, const Interval& place, double error) {
    const auto left = [](const Interval& a, const Interval& of) {
        return of.low() > 0 ? clamped(widen(a / of, 0x1p-50 / of.low()), 0, 1) : Interval{0, 1};
    };
    std::vector<Decided> all;
    for (double low = std::floor(place.low()); low <= std::floor(place.high()); ++low) {
        const Interval share = clamped(widen(place - Interval{low}, error), 0, 1);
        if (number.low() <= share.high() && share.high() > 0)
            all.push_back({std::int64_t(low) + 1, left(number, share)});
        if (number.high() >= share.low() && share.low() < 1)
            all.push_back({std::int64_t(low), left(number - share, Interval{1} - share)});
    }
    return all;
}

/// Every texel of a level that a number may decide for.
void add_decided(const Levels& levels, const Decided& level, const FilterQuery& q, PermittedColours& all) {
    const IntervalImage& image = levels.at(int(level.index));
    const TexelInterval place = place_in(image, levels.at(0), q.footprint().centre, q.precision);
    const Interval half{0.5}, u = place.u - half, v = place.v - half;
    if (!(u.high() - u.low() < widest_draw && v.high() - v.low() < widest_draw)) throw UndecidedSign{};
    const double error = std::exp2(-q.precision.weight_bits);
    const WrapRules& wrap = levels.settings().wrap;
    for (const Decided& column : decided(level.left, u, error))
        for (const Decided& row : decided(column.left, v, error)) {
            const auto& texel = image.at(wrapped_index(wrap.u, column.index, image.width),
                                         wrapped_index(wrap.v, row.index, image.height));
            all.push_back(around(texel.value, texel.radius));
        }
}

using NumberOf = Interval (*)(int x, int y, std::uint32_t frame);

/// One sample: every texel that it may be. Several: their mean, each within the range of its texels.
template <NumberOf number>
PermittedColours by_one_number(const Levels& levels, const FilterQuery& q) {
    const Interval lod_of_pixel =
        level_of(lod(LodRule::gl_maximum, q.footprint()), levels.settings(), levels.count(), q.precision);
    const Settings& settings = levels.settings();
    ColourRange sum;
    for (int sample = 0; sample < settings.samples; ++sample) {
        const std::uint32_t frame = settings.seed + std::uint32_t(sample);
        PermittedColours possible;
        for (const Decided& level :
             decided(number(q.x, q.y, frame), lod_of_pixel, std::exp2(-q.precision.weight_bits)))
            if (level.index < std::int64_t(levels.count())) add_decided(levels, level, q, possible);
        if (settings.samples == 1) return possible;
        ColourRange range = possible.front();
        for (const ColourRange& colour : possible) range = hull(range, colour);
        sum = sum + Interval{1.0 / settings.samples} * range;
    }
    return {sum};
}

using DrawsOf = ColourDraws (*)(const Levels&, const FilterQuery&);

Definition stochastic_definition(const std::string& name, DrawsOf draws_of) {
    const auto draws = [draws_of](const texture::LinearImage& image,
                                  const Settings& settings) -> DrawReference {
        return [levels = std::make_shared<const Levels>(image, settings), draws_of](const FilterQuery& q) {
            return draws_of(*levels, q);
        };
    };
    return {
        .name = "stochastic-" + name,
        .prepare = [draws](const texture::LinearImage& image, const Settings& settings) -> MethodReference {
            return [of = draws(image, settings)](const FilterQuery& q) { return permitted_by(of(q)); };
        },
        .draws = draws};
}

}  // namespace

std::vector<Definition> stochastic_definitions() {
    return {stochastic_definition("bilinear", bilinear_draws),
            stochastic_definition("trilinear", trilinear_draws),
            {"stochastic-interleaved", over_levels(by_one_number<interleaved_number>)},
            {"stochastic-blue", over_levels(by_one_number<blue_number>)}};
}

}  // namespace zproof::oracle::filter_reference
