#include "compare/conformance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace zproof {

namespace {

/// The share of the wrong pixels that an explanation must reach.
constexpr double all_of_them = 1;
constexpr double inf = std::numeric_limits<double>::infinity();

double slack_in(const LinearRgb& colour, const ColourRange& range) {
    const std::array<double, 3> value{colour.r, colour.g, colour.b};
    double slack = 0;
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(value[std::size_t(c)])) return inf;
        if (range.low[c] == -inf) continue;
        const double half = (range.high[c] - range.low[c]) / 2, middle = range.low[c] + half;
        const double off = std::abs(value[std::size_t(c)] - middle);
        // Inside is inside, whatever the quotient rounds to.
        const bool is_inside =
            value[std::size_t(c)] >= range.low[c] && value[std::size_t(c)] <= range.high[c];
        const double needed = off == 0 ? 0 : half == 0 ? inf : off / half;
        slack =
            std::max(slack, is_inside ? std::min(needed, 1.0) : std::max(needed, std::nextafter(1.0, 2.0)));
    }
    return slack;
}

double width_of(const PermittedColours& permitted) {
    double sum = 0;
    for (const ColourRange& range : permitted) {
        const glm::dvec3 width = range.high - range.low;
        sum += (width.x + width.y + width.z) / 3;
    }
    return sum;
}

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
        case FilterRule::other:
            break;
    }
    return p;
}

/// Some of the pixels outside, taken evenly in raster order.
std::vector<FilterPixel> some_outside(const Conformance& found) {
    constexpr std::size_t most = 400;
    std::vector<FilterPixel> all;
    for (int y = 0; y < found.slack.size().height; ++y)
        for (int x = 0; x < found.slack.size().width; ++x)
            if (found.slack.at(x, y) > 1) all.push_back({x, y});
    if (all.size() <= most) return all;
    std::vector<FilterPixel> some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
    return some;
}

struct RelaxationQuery {
    const Picture& picture;
    const PixelReference& reference;
    const FilterPrecision& declared;
    std::vector<FilterPixel> pixels;
};

RuleRelaxation ask(const RelaxationQuery& q, FilterRule rule, double bits) {
    const FilterPrecision precision = relaxed(q.declared, rule, bits);
    std::vector<double> width(q.pixels.size(), -1);
    tbb::parallel_for(std::size_t{0}, q.pixels.size(), [&](std::size_t i) {
        const auto [x, y] = q.pixels[i];
        const PermittedColours permitted = q.reference(x, y, precision);
        if (slack_of(q.picture.at(x, y), permitted) <= 1) width[i] = width_of(permitted);
    });
    RuleRelaxation relaxation{.rule = rule, .bits = bits};
    double widths = 0, explained = 0;
    for (const double w : width)
        if (w >= 0) ++explained, widths += w;
    relaxation.explained = explained / double(q.pixels.size());
    relaxation.permissive = explained > 0 ? widths / explained : inf;
    return relaxation;
}

/// How far a rule gives way: errors of four texels or levels. Weights of one bit are any mean of what is
/// read.
int fewest_bits(FilterRule rule) { return rule == FilterRule::weights ? 1 : -2; }

/// Any mean of what is read keeps to weights of so few bits: also that of wrong texels, or by a wrong factor.
bool promises_nothing(const RuleRelaxation& relaxation) {
    return relaxation.rule == FilterRule::weights && relaxation.bits <= fewest_bits(FilterRule::weights);
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
        case FilterRule::sums:
            return "texels and sums";
        case FilterRule::other:
            break;
    }
    return "another rule";
}

const ColourRange& nearest_range(const LinearRgb& colour, const PermittedColours& permitted) {
    const ColourRange* nearest = &permitted.front();
    double least = inf;
    for (const ColourRange& range : permitted)
        if (const double slack = slack_in(colour, range); slack < least) least = slack, nearest = &range;
    return *nearest;
}

double slack_of(const LinearRgb& colour, const PermittedColours& permitted) {
    return slack_in(colour, nearest_range(colour, permitted));
}

Conformance conformance(const Picture& picture, const PixelReference& reference,
                        const FilterPrecision& precision) {
    const Resolution size = picture.size();
    Conformance found{.judged = size.pixel_count(), .worst = {}, .where = {}, .slack = Plane<float>{size}};
    Plane<double> width{size};
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const PermittedColours permitted = reference(x, y, precision);
            const double slack = slack_of(picture.at(x, y), permitted);
            found.slack.at(x, y) = slack > 1 ? std::nextafter(float(slack), float(inf)) : float(slack);
            width.at(x, y) = width_of(permitted);
        }
    });
    double widths = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double slack = double{found.slack.at(x, y)};
            if (std::isinf(width.at(x, y)))
                ++found.anything;
            else
                widths += width.at(x, y);
            if (slack > found.worst_slack) found.worst_slack = slack, found.worst = {x, y};
            if (!(slack > 1)) continue;
            ++found.outside;
            if (!found.where) found.where = ExtentOutside{{x, y}, {x, y}};
            found.where->first.x = std::min(found.where->first.x, x);
            found.where->last.x = std::max(found.where->last.x, x);
            found.where->last.y = y;
        }
    }
    found.mean_width = widths / double(std::max<std::uint64_t>(found.judged - found.anything, 1));
    return found;
}

std::vector<RuleRelaxation> rules_at_fault(const Picture& picture, const Conformance& found,
                                           const PixelReference& reference,
                                           const FilterPrecision& precision) {
    const RelaxationQuery query{picture, reference, precision, some_outside(found)};
    if (query.pixels.empty()) return {};
    std::vector<RuleRelaxation> relaxations;
    for (const FilterRule rule : {FilterRule::coordinates, FilterRule::footprint, FilterRule::lod,
                                  FilterRule::weights, FilterRule::taps, FilterRule::sums}) {
        const RuleRelaxation relaxation = least_relaxation(query, rule);
        if (relaxation.explained > 0) relaxations.push_back(relaxation);
    }
    const auto rank = [](const RuleRelaxation& relaxation) {
        if (relaxation.explained < all_of_them) return 2;
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
        if (rule.explained < all_of_them) continue;
        std::optional<RuleRelaxation>& place = rule.rule == FilterRule::sums ? any_error : told;
        if (place) return {};
        place = rule;
    }
    if (told && promises_nothing(*told)) return {};
    return told ? told : any_error;
}

}  // namespace zproof
