#include "compare/attributes/interpolated_value.h"

#include <algorithm>
#include <cmath>

#include "compare/attributes/position_range.h"
#include "compare/bounds/triangle_depth.h"
#include "frame/attributes.h"
#include "math/rational.h"
#include "math/rounding.h"

namespace zproof {

namespace {

using Values = std::vector<InterpolatedValue>;

Attribute attribute_of(const InterpolatedValue& v) { return attribute_channels[v.channel].attribute; }

/// Where values may have been taken.
template <class Number>
struct Places {
    std::optional<Weights<Number>> centre;  ///< where the triangle's plane is known there
    std::vector<Weights<Number>>
        in_square;  ///< the extreme ones; none where only means of the corners are known
};

/// Is every value that is taken in the square between those at some places?
bool has_square(const SampledSurface& s) {
    return s.surface.has_plane() && std::isfinite(s.half_side()) &&
           (s.errors.sampled == SampledPlaces::on_triangle || s.surface.least_sum > 0);
}

template <class Number>
Places<Number> places_of(const SampledSurface& s) {
    const Surface& surface = s.surface;
    Places<Number> places;
    if (!surface.has_plane()) return places;
    const ViewRay<Number> ray(surface.facts.view, surface.pixel.x, surface.pixel.y);
    const auto image = image_of(ray, corners<Number>(surface.p_world()));
    if (!image) return places;
    if (surface.has_centre()) places.centre = weights_at(*image, Number(0), Number(0));
    if (has_square(s)) places.in_square = extreme_places(*image, s.half_side(), s.errors.sampled);
    return places;
}

/// decide(Number) in intervals, then in rationals.
template <class Decide>
bool decided(const Decide& decide) {
    try {
        return decide(Interval());
    } catch (const UndecidedSign&) {
        return decide(Rational());
    }
}

template <class Number>
ValueRange<Number> at_centre(const Weights<Number>& centre, const InterpolatedValue& v) {
    const Number value = centre.blend(v.at_corners), slack(v.slack_at_centre);
    return {value - slack, value + slack};
}

/// Values in the square that are means of the corners' as well.
template <class Number>
ValueRange<Number> in_square(const Places<Number>& places, const InterpolatedValue& v) {
    const ValueRange<Number> means{Number(v.means.low), Number(v.means.high)};
    if (places.in_square.empty() || !std::isfinite(v.slack)) return means;
    const ValueRange<Number> range = range_of(places.in_square, v.at_corners);
    return {detail::greatest(means.low, Number(range.low - Number(v.slack))),
            detail::least(means.high, Number(range.high + Number(v.slack)))};
}

template <class Number>
bool holds(const ValueRange<Number>& range, const InterpolatedValue& v) {
    const Number value{double(v.value)};
    return sign(range.high - value) >= 0 && sign(value - range.low) >= 0;
}

bool is_admissible(const SampledSurface& s, const InterpolatedValue& v) {
    return decided([&]<class Number>(Number) {
        const Places<Number> places = places_of<Number>(s);
        return (places.centre && holds(at_centre(*places.centre, v), v)) || holds(in_square(places, v), v);
    });
}

/// Has the direction of these values a multiple that lies in the box of these ranges?
template <class Number>
bool meets_box(const Values& values, const std::array<ValueRange<Number>, 3>& box) {
    struct Side {
        Number length;  ///< of the direction along an axis, at least 0
        ValueRange<Number> range;
    };
    std::vector<Side> sides;
    for (std::size_t axis = 0; axis < box.size(); ++axis) {
        const ValueRange<Number>& range = box[axis];
        const float value = values[axis].value;
        if (value == 0 && (sign(range.low) > 0 || sign(range.high) < 0)) return false;
        if (value > 0) sides.push_back({Number(double(value)), range});
        if (value < 0) sides.push_back({Number(-double(value)), {-range.high, -range.low}});
    }
    for (const Side& a : sides) {
        if (sign(a.range.high) <= 0) return false;
        for (const Side& b : sides)
            if (sign(a.range.high * b.length - b.range.low * a.length) < 0) return false;
    }
    return true;
}

bool is_admissible_direction(const SampledSurface& s, const Values& v) {
    return decided([&]<class Number>(Number) {
        const Places<Number> places = places_of<Number>(s);
        const auto box_of = [&](const auto& range_of) {
            return std::array{range_of(v[0]), range_of(v[1]), range_of(v[2])};
        };
        const auto square = [&](const InterpolatedValue& axis) { return in_square(places, axis); };
        const auto centre = [&](const InterpolatedValue& axis) { return at_centre(*places.centre, axis); };
        return (places.centre && meets_box<Number>(v, box_of(centre))) ||
               meets_box<Number>(v, box_of(square));
    });
}

/// The depths of a position: it may be made from the depth that the frame shows, or be interpolated beside
/// it.
DepthBound depth_of(const SampledSurface& s) {
    const auto by = [&](const ViewBounds& bounds) {
        const TriangleInView in_view(s.surface.facts.view, bounds, s.surface.p_world());
        return TriangleDepth(in_view, bounds).at(s.surface.pixel.x, s.surface.pixel.y);
    };
    const DepthBound shown = by(*s.depth_bounds[0]), varying = by(*s.depth_bounds[1]);
    return {std::min(shown.low, varying.low), shown.truth, std::max(shown.high, varying.high)};
}

template <class Number>
Vector3<Number> blend(const Weights<Number>& weights, const Values& values) {
    return {weights.blend(values[0].at_corners), weights.blend(values[1].at_corners),
            weights.blend(values[2].at_corners)};
}

/// What float32 at least does to origin + depth direction.
Vector3<double> slack_of_depth(const ViewRay<double>& ray, double depth) {
    const auto of = [&](double origin, double direction) {
        return gamma(4, unit_roundoff_float32) * (std::abs(origin) + depth * std::abs(direction));
    };
    const Vector3<double>&o = ray.origin, &d = ray.direction;
    return {of(o.x, d.x), of(o.y, d.y), of(o.z, d.z)};
}

/// Where a position may lie that is made from an admissible depth.
template <class Number>
PositionLimits<Number> made_from_depth(const SampledSurface& s, const DepthBound& bound) {
    PositionLimits<Number> limits{std::isfinite(s.half_side()) ? s.half_side() : 0,
                                  slack_of_depth(s.surface.ray, std::abs(s.depth)),
                                  {},
                                  {}};
    if (std::isfinite(bound.low)) limits.least = Number(bound.low);
    if (std::isfinite(bound.high)) limits.greatest = Number(bound.high);
    return limits;
}

/// Where one may lie that is interpolated in the square, of which there must be places.
template <class Number>
PositionLimits<Number> interpolated(const SampledSurface& s, const ViewRay<Number>& ray,
                                    const Places<Number>& places, const Values& values) {
    PositionLimits<Number> limits{s.half_side(), {values[0].slack, values[1].slack, values[2].slack}, {}, {}};
    for (const Weights<Number>& place : places.in_square) {
        const Number depth = camera_depth<Number>(ray, blend(place, values) - ray.origin);
        limits.least = limits.least ? detail::least(*limits.least, depth) : depth;
        limits.greatest = limits.greatest ? detail::greatest(*limits.greatest, depth) : depth;
    }
    return limits;
}

bool may_be_interpolated_in_square(const auto& places, const Values& values) {
    return !places.in_square.empty() && std::isfinite(values[0].slack + values[1].slack + values[2].slack);
}

/// Seen in the square at an admissible depth; where the triangle is not known to meet the square, also a mean
/// of its corners at such a depth.
bool is_admissible_position(const SampledSurface& s, const Values& values) {
    const DepthBound bound = depth_of(s);
    return decided([&]<class Number>(Number) {
        const ViewRay<Number> ray(s.surface.facts.view, s.surface.pixel.x, s.surface.pixel.y);
        const Vector3<Number> from_origin =
            exactly<Number>({values[0].value, values[1].value, values[2].value}) - ray.origin;
        const auto hold_it = [&](const std::vector<HalfSpace<Number>>& spaces) {
            return std::ranges::all_of(spaces,
                                       [&](const auto& space) { return sign(space.at(from_origin)) >= 0; });
        };
        const auto holds_it = [&](const PositionLimits<Number>& limits) {
            const PositionRange<Number> range = position_range(ray, limits);
            return hold_it(range.along) && hold_it(range.across);
        };
        PositionLimits<Number> limits = made_from_depth<Number>(s, bound);
        if (holds_it(limits)) return true;
        const Places<Number> places = places_of<Number>(s);
        const auto all_hold = [&](const auto& range_of) {
            return std::ranges::all_of(values, [&](const auto& v) { return holds<Number>(range_of(v), v); });
        };
        if (places.centre && all_hold([&](const auto& v) { return at_centre(*places.centre, v); }))
            return true;
        if (may_be_interpolated_in_square(places, values))
            return holds_it(interpolated(s, ray, places, values));
        const auto beyond = [](const InterpolatedValue& v) {
            return v.means.high - std::ranges::max(v.at_corners);
        };
        limits.slack = {beyond(values[0]), beyond(values[1]), beyond(values[2])};
        if (bound.is_open()) limits.least.reset();
        return hold_it(position_range(ray, limits).along) &&
               all_hold([&](const auto& v) { return in_square(places, v); });
    });
}

/// The value at the pixel's centre, and how far double may be off.
struct AtCentre {
    double value, own_error;
};

/// The middle of what is admissible where the centre is not known, and then no error is known.
AtCentre at_centre(const Surface& s, const InterpolatedValue& v) {
    const auto [low, high] = std::ranges::minmax(v.at_corners);
    if (!s.has_centre()) return {(low + high) / 2, unlimited};
    const Weights<double> w = weights_at<double>(*s.seen.image, 0, 0);
    const double of_weights = 3 * s.seen.edge_error / s.sum_at_centre * (high - low);
    const double largest = std::max(std::abs(low), std::abs(high));
    return {w.blend(v.at_corners), s.spread_at_centre * (2 * of_weights + 0x1p-48 * largest)};
}

double squared_length(const std::array<double, 3>& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// What the frame's values are to be multiplied by to be held against their ranges one by one: 1 but for a
/// direction.
double scale_of(const Surface& s, const Values& values) {
    if (attribute_of(values.front()) != Attribute::normal) return 1;
    std::array<double, 3> given{}, truth{};
    for (std::size_t i = 0; i < 3; ++i) {
        given[i] = values[i].value;
        truth[i] = at_centre(s, values[i]).value;
    }
    const double scale = std::sqrt(squared_length(truth) / squared_length(given));
    return std::isfinite(scale) && scale > 0 ? scale : 1;
}

/// Is the centre for certain one of the places whose values are admissible?
bool is_sampled(const SampledSurface& s) {
    if (s.errors.sampled == SampledPlaces::anywhere) return has_square(s);
    return std::ranges::all_of(
        s.surface.seen.edges, [&](const Affine<double>& edge) { return edge.c > s.surface.seen.edge_error; });
}

/// Double is sure of most values: they are what the centre has, but for arithmetic.
bool are_those_of_centre(const SampledSurface& s, const Values& values) {
    if (!s.surface.has_centre()) return false;
    const double scale = scale_of(s.surface, values);
    const bool may_use_slack = is_sampled(s);
    return std::ranges::all_of(values, [&](const InterpolatedValue& v) {
        const AtCentre centre = at_centre(s.surface, v);
        const double value = scale * v.value, error = centre.own_error + 0x1p-48 * std::abs(centre.value);
        const bool is_mean = may_use_slack && value - error >= v.means.low && value + error <= v.means.high;
        return std::abs(value - centre.value) + error <=
               (is_mean && std::isfinite(v.slack) ? v.slack : v.slack_at_centre);
    });
}

/// A value in double, for people. The truth is told as the admissible value nearest to it.
WrongAttribute told(const InterpolatedValue& v, const ValuesBetween& admissible, double truth, double scale) {
    const auto [low, high] = admissible;
    WrongAttribute wrong{.channel = v.channel,
                         .value = v.value,
                         .low = low / scale,
                         .truth = std::max(low, std::min(truth, high)) / scale,
                         .high = high / scale};
    wrong.error_over_bound = error_over_bound({wrong.low, wrong.truth, wrong.high}, wrong.value);
    return wrong;
}

/// The number of an attribute that is farthest beyond its range.
template <class Told>
WrongAttribute worst_of(const Values& values, const Told& told_of) {
    WrongAttribute worst = told_of(values.front());
    for (const InterpolatedValue& v : values)
        if (const WrongAttribute here = told_of(v); !(here.error_over_bound <= worst.error_over_bound))
            worst = here;
    return worst;
}

WrongAttribute told_by_range(const SampledSurface& s, const Places<double>& places,
                             const InterpolatedValue& v, double scale) {
    const ValueRange<double> range = in_square(places, v);
    return told(v, {range.low, range.high}, at_centre(s.surface, v).value, scale);
}

/// The values that a coordinate may have beside the others of this point; none: `low` is above `high`.
ValuesBetween on_line(const PositionRange<double>& admissible, Vector3<double> from_origin,
                      double Vector3<double>::*axis) {
    from_origin.*axis = 0;
    ValuesBetween range{-unlimited, unlimited};
    for (const auto* spaces : {&admissible.across, &admissible.along})
        for (const HalfSpace<double>& space : *spaces) {
            const double slope = space.normal.*axis, room = space.at(from_origin);
            if (slope > 0) range.low = std::max(range.low, -room / slope);
            if (slope < 0) range.high = std::min(range.high, -room / slope);
            if (slope == 0 && room < 0) return {unlimited, -unlimited};
        }
    return range;
}

/// A coordinate is held against what it may be beside the other two of the frame; where none may be anything
/// there, beside those of the centre. Told is the one that needs the least change.
WrongAttribute wrong_position(const SampledSurface& s, const Values& values) {
    const ViewRay<double>& ray = s.surface.ray;
    const DepthBound bound = depth_of(s);
    const Places<double> places = places_of<double>(s);
    std::vector<PositionRange<double>> ranges{position_range(ray, made_from_depth<double>(s, bound))};
    if (may_be_interpolated_in_square(places, values))
        ranges.push_back(position_range(ray, interpolated(s, ray, places, values)));
    const Vector3<double> given = exactly<double>({values[0].value, values[1].value, values[2].value}),
                          right = ray.origin + bound.truth * ray.direction;
    for (const Vector3<double>& beside : {given, right}) {
        const auto told_beside = [&](const InterpolatedValue& v) {
            constexpr double Vector3<double>::*axes[] = {&Vector3<double>::x, &Vector3<double>::y,
                                                         &Vector3<double>::z};
            const auto axis = axes[attribute_channels[v.channel].axis];
            ValuesBetween admissible{unlimited, -unlimited};
            for (const PositionRange<double>& range : ranges)
                if (const auto [low, high] = on_line(range, beside - ray.origin, axis); low <= high)
                    admissible = {std::min(admissible.low, ray.origin.*axis + low),
                                  std::max(admissible.high, ray.origin.*axis + high)};
            if (admissible.low > admissible.high) return WrongAttribute{.channel = v.channel};
            return told(v, admissible, right.*axis, 1);
        };
        std::array told{told_beside(values[0]), told_beside(values[1]), told_beside(values[2])};
        const auto change = [](const WrongAttribute& wrong) {
            return wrong.error_over_bound > 1 ? std::max(wrong.low - wrong.value, wrong.value - wrong.high)
                                              : unlimited;
        };
        const WrongAttribute& least = *std::ranges::min_element(told, {}, change);
        if (least.error_over_bound > 1) return least;
    }
    return worst_of(values, [&](const InterpolatedValue& v) { return told_by_range(s, places, v, 1); });
}

}  // namespace

InterpolatedValue interpolated_value(const Surface& surface, const InterpolationErrors& errors,
                                     std::size_t channel, const std::array<double, 3>& at_corners,
                                     float value) {
    // a normal may be brought to unit length: a common factor, and 3 roundings
    const double of_length =
        attribute_channels[channel].attribute == Attribute::normal ? gamma(3, unit_roundoff_float32) : 0;
    const auto [low, high] = std::ranges::minmax(at_corners);
    const double largest = std::max(std::abs(low), std::abs(high)), range = high - low;
    const auto share = [](double size, double error) {
        return size > 0 ? size * error : 0;
    };  // may be unlimited
    const double weights = compounded(errors.of_weights);
    const double negative = errors.negative + (std::isfinite(weights) ? weights : 0);
    const double spread = 1 + 2 * negative;
    const double relative = share(largest, compounded(errors.relative + of_length));
    const double products = share(largest, compounded(errors.of_products + of_length));
    constexpr double any_float = 0x1p200;
    const double beyond = std::min(any_float, products * spread + negative * range + errors.underflow);
    const double corners = share(range, compounded(errors.of_corners));
    const double at_centre = share(relative + corners, surface.spread_at_centre) + errors.underflow;
    const bool may_shrink = errors.of_shares == InterpolationErrors::Sum::at_most_one;
    return {.channel = channel,
            .value = value,
            .at_corners = at_corners,
            .slack = (relative + corners) * spread + share(range, spread * weights) + errors.underflow,
            .slack_at_centre = std::isfinite(at_centre) ? at_centre : -1,
            .means = {(may_shrink ? std::min(low, 0.0) : low) - beyond,
                      (may_shrink ? std::max(high, 0.0) : high) + beyond}};
}

std::optional<WrongAttribute> first_wrong(const SampledSurface& s, const Values& values) {
    if (s.errors.may_be_anything) return std::nullopt;
    const auto tell = [&](const InterpolatedValue& v) {
        return told_by_range(s, places_of<double>(s), v, scale_of(s.surface, values));
    };
    const auto is_nothing = [](const InterpolatedValue& v) { return !std::isfinite(v.value); };
    if (const auto nothing = std::ranges::find_if(values, is_nothing); nothing != values.end())
        return tell(*nothing);
    if (are_those_of_centre(s, values)) return std::nullopt;
    switch (attribute_of(values.front())) {
        case Attribute::normal:
            return is_admissible_direction(s, values) ? std::nullopt : std::optional(worst_of(values, tell));
        case Attribute::position:
            return is_admissible_position(s, values) ? std::nullopt
                                                     : std::optional(wrong_position(s, values));
        case Attribute::barycentrics:
        case Attribute::uv:
            break;
    }
    const auto wrong =
        std::ranges::find_if(values, [&](const InterpolatedValue& v) { return !is_admissible(s, v); });
    return wrong == values.end() ? std::nullopt : std::optional(tell(*wrong));
}

}  // namespace zproof
