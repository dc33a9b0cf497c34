#include <memory>

#include "oracle/filter_reference/levels.h"

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
            stochastic_definition("trilinear", trilinear_draws)};
}

}  // namespace zproof::oracle::filter_reference
