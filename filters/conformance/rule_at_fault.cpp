#include "filters/conformance/rule_at_fault.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace zproof {

namespace {

/// The share of the wrong pixels that an explanation must reach.
constexpr double all_of_them = 1;
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// One rule relaxed until it holds to so many bits only.
FilterPrecision relaxed(const FilterPrecision& declared, FilterRule rule, double bits) {
    FilterPrecision p = declared;
    switch (rule) {
        case FilterRule::coordinates:
            p.place_bits = bits;
            break;
        case FilterRule::footprint:
            p.step_bits = bits;
            break;
        case FilterRule::lod:
            p.lod_bits = bits;
            break;
        case FilterRule::weights:
            p.weight_bits = bits;
            break;
        case FilterRule::taps:
            p.tap_bits = bits;
            break;
        case FilterRule::sums:
            p.colour_bits = bits;
            break;
        case FilterRule::factor:
        case FilterRule::other:
            break;
    }
    return p;
}

struct ShownPixel {
    FilterPixel at;
    LinearRgb colour;
};

struct RelaxationQuery {
    const PixelReference& reference;
    const FilterPrecision& declared;
    std::vector<ShownPixel> pixels;
};

RelaxationQuery query_of(const Picture& picture, const std::vector<FilterPixel>& pixels,
                         const PixelReference& reference, const FilterPrecision& declared) {
    RelaxationQuery query{reference, declared, {}};
    for (const FilterPixel& pixel : pixels) query.pixels.push_back({pixel, picture.at(pixel.x, pixel.y)});
    return query;
}

/// Turns the sign of all errors.
RelaxationQuery opposite_of(RelaxationQuery query) {
    for (auto& [at, colour] : query.pixels)
        colour = reflected(colour, query.reference(at.x, at.y, query.declared));
    return query;
}

RuleRelaxation ask(const RelaxationQuery& q, FilterRule rule, double bits) {
    const FilterPrecision precision = relaxed(q.declared, rule, bits);
    std::vector<double> width(q.pixels.size(), -1);
    tbb::parallel_for(std::size_t{0}, q.pixels.size(), [&](std::size_t i) {
        const auto& [at, colour] = q.pixels[i];
        const PermittedColours permitted = q.reference(at.x, at.y, precision);
        if (slack_of(colour, permitted) <= 1) width[i] = width_of(permitted);
    });
    RuleRelaxation relaxation{.rule = rule, .bits = bits};
    double widths = 0, explained = 0;
    for (const double w : width)
        if (w >= 0) ++explained, widths += w;
    relaxation.explained = explained / double(q.pixels.size());
    relaxation.permissive = explained > 0 ? widths / explained : unbounded;
    return relaxation;
}

/// How far a rule gives way: errors of a texel, of four texels' lengths or levels, of a quarter of a colour.
/// Weights of one bit are any mean of what is read.
int fewest_bits(FilterRule rule) {
    switch (rule) {
        case FilterRule::coordinates:
            return 0;
        case FilterRule::weights:
            return 1;
        case FilterRule::sums:
            return 2;
        default:
            return -2;
    }
}

/// Any mean of what is read keeps to weights of so few bits: also that of wrong texels, or by a wrong factor.
bool promises_nothing(const RuleRelaxation& relaxation) {
    return relaxation.rule == FilterRule::weights && relaxation.bits <= fewest_bits(FilterRule::weights);
}

/// Such a move of places tells nothing: it makes the opposite of every error as well. So it is where the
/// definition bounds what places may do by any error of that size (summed areas), and on a gradient.
bool is_any_error(const RuleRelaxation& relaxation) {
    const FilterRule rule = relaxation.rule;
    return (rule == FilterRule::coordinates || rule == FilterRule::footprint || rule == FilterRule::taps) &&
           relaxation.explained_reflected >= all_of_them;
}

bool explains_all(const RuleRelaxation& relaxation) {
    return relaxation.explained >= all_of_them && relaxation.is_everywhere;
}

/// Held to the pixels that were not asked about as well, to fewer bits where it must be.
RuleRelaxation held_to_all(RuleRelaxation relaxation, const Picture& picture, const RelaxationQuery& q) {
    const auto has_pixels_outside = [&]() -> bool {
        const FilterPrecision precision = relaxed(q.declared, relaxation.rule, relaxation.bits);
        return have_pixels_outside({&picture, 1}, q.reference, precision)[0];
    };
    while (has_pixels_outside()) {
        if (relaxation.bits <= fewest_bits(relaxation.rule)) {
            relaxation.is_everywhere = false;
            break;
        }
        relaxation = ask(q, relaxation.rule, relaxation.bits - 1);
    }
    return relaxation;
}

/// Numbers by which what is permitted has to be multiplied to hold what was found.
struct Factors {
    double least = 0, greatest = unbounded;

    Factors both(const Factors& other) const {
        return {std::max(least, other.least), std::min(greatest, other.greatest)};
    }
    bool is_empty() const { return !(least <= greatest); }
};
using FactorsOfChannels = std::array<Factors, 3>;

/// Those by which the bound is no less than the value.
Factors reaching(double value, double bound) {
    if (bound > 0) return {.least = std::max(value / bound, 0.0)};
    if (bound < 0) return {.greatest = value / bound};
    return value <= 0 ? Factors{} : Factors{.greatest = -unbounded};
}

/// None for what is no number.
Factors factors_of(double value, double low, double high) {
    if (!std::isfinite(value)) return {.greatest = -unbounded};
    return reaching(value, high).both(reaching(-value, -low));
}

FactorsOfChannels both(FactorsOfChannels factors, const LinearRgb& found, const ColourRange& permitted) {
    const std::array<double, 3> value{found.r, found.g, found.b};
    for (std::size_t c = 0; c < 3; ++c)
        factors[c] = factors[c].both(factors_of(value[c], permitted.low[int(c)], permitted.high[int(c)]));
    return factors;
}

bool is_empty(const FactorsOfChannels& factors) { return std::ranges::any_of(factors, &Factors::is_empty); }

bool is_right(const FactorsOfChannels& factors) {
    return std::ranges::all_of(factors, [](const Factors& f) { return f.least <= 1 && f.greatest >= 1; });
}

/// One factor a channel that holds at every pixel: found where one thing is permitted, and held to the
/// others. Nothing where there is none.
std::optional<RuleRelaxation> factor_of(const Picture& picture, const PixelReference& reference,
                                        const FilterPrecision& declared) {
    FactorsOfChannels factors;
    std::vector<std::pair<LinearRgb, PermittedColours>> others;
    for (int y = 0; y < picture.size().height; ++y)
        for (int x = 0; x < picture.size().width && !is_empty(factors); ++x) {
            const PermittedColours permitted = reference(x, y, declared);
            if (permitted.size() > 1)
                others.emplace_back(picture.at(x, y), permitted);
            else
                factors = both(factors, picture.at(x, y), permitted.front());
        }
    const auto holds = [&](const auto& other) {
        return std::ranges::any_of(other.second, [&](const ColourRange& permitted) {
            return !is_empty(both(factors, other.first, permitted));
        });
    };
    if (is_empty(factors) || is_right(factors) || !std::ranges::all_of(others, holds)) return std::nullopt;
    RuleRelaxation relaxation{.rule = FilterRule::factor, .explained = all_of_them};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto [least, greatest] = factors[c];
        if (std::isfinite(greatest))
            relaxation.times[int(c)] = (least + greatest) / 2;
        else if (least > 1)
            return std::nullopt;  // values where none is permitted
    }
    return relaxation;
}

/// The most bits that explain all of the pixels, or the fewest tried.
RuleRelaxation least_relaxation(const RelaxationQuery& q, FilterRule rule) {
    constexpr int most = 24;
    const int fewest = fewest_bits(rule);
    RuleRelaxation best = ask(q, rule, fewest);
    if (best.explained < all_of_them) return best;
    int enough = fewest, too_many = most;
    while (too_many - enough > 1) {
        const int bits = (enough + too_many) / 2;
        const RuleRelaxation relaxation = ask(q, rule, bits);
        (relaxation.explained >= all_of_them ? enough : too_many) = bits;
        if (relaxation.explained >= all_of_them) best = relaxation;
    }
    return best;
}

}  // namespace

std::string name_of(FilterRule rule) {
    switch (rule) {
        case FilterRule::coordinates:
            return "coordinates";
        case FilterRule::footprint:
            return "footprint";
        case FilterRule::lod:
            return "LOD";
        case FilterRule::weights:
            return "weights";
        case FilterRule::taps:
            return "tap placement";
        case FilterRule::factor:
            return "factor";
        case FilterRule::sums:
            return "texels and sums";
        case FilterRule::other:
            break;
    }
    return "another rule";
}

std::vector<RuleRelaxation> rules_at_fault(const Picture& picture, const Conformance& found,
                                           const PixelReference& reference,
                                           const FilterPrecision& precision) {
    const std::vector<FilterPixel> pixels = some_pixels(found, std::nextafter(1.0f, 2.0f));
    if (pixels.empty()) return {};
    const RelaxationQuery query = query_of(picture, pixels, reference, precision),
                          opposite = opposite_of(query);
    std::vector<RuleRelaxation> relaxations;
    if (const auto factor = factor_of(picture, reference, precision)) relaxations.push_back(*factor);
    for (const FilterRule rule : {FilterRule::coordinates, FilterRule::footprint, FilterRule::lod,
                                  FilterRule::weights, FilterRule::taps, FilterRule::sums}) {
        RuleRelaxation relaxation = least_relaxation(query, rule);
        if (relaxation.explained == 0) continue;
        if (explains_all(relaxation)) relaxation = held_to_all(relaxation, picture, query);
        relaxation.explained_reflected = ask(opposite, rule, relaxation.bits).explained;
        relaxations.push_back(relaxation);
    }
    const auto rank = [](const RuleRelaxation& relaxation) {
        if (!explains_all(relaxation)) return 2;
        return relaxation.rule == FilterRule::sums ? 1 : 0;
    };
    std::ranges::stable_sort(relaxations, [&](const RuleRelaxation& a, const RuleRelaxation& b) {
        if (rank(a) != rank(b)) return rank(a) < rank(b);
        return rank(a) < 2 ? a.permissive < b.permissive : a.explained > b.explained;
    });
    return relaxations;
}

std::optional<RuleRelaxation> rule_told(const std::vector<RuleRelaxation>& rules) {
    std::optional<RuleRelaxation> told, any_error;
    for (const RuleRelaxation& rule : rules) {
        if (rule.rule == FilterRule::factor) return rule;
        if (!explains_all(rule)) continue;
        std::optional<RuleRelaxation>& place = rule.rule == FilterRule::sums ? any_error : told;
        if (place) return {};
        place = rule;
    }
    if (told && (promises_nothing(*told) || is_any_error(*told) ||
                 !(told->permissive < (any_error ? any_error->permissive : unbounded))))
        return {};
    return told ? told : any_error;
}

}  // namespace zproof
