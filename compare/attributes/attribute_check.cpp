#include "compare/attributes/attribute_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "compare/attributes/interpolation_errors.h"
#include "compare/bounds/triangle_depth.h"
#include "math/rational.h"
#include "math/rounding.h"

namespace zproof {

namespace {

bool scene_has(const Scene& scene, Attribute attribute) {
    if (attribute == Attribute::uv) return !scene.vertices.uv.empty();
    return attribute != Attribute::normal || !scene.vertices.normal_world.empty();
}

std::array<double, 3> at_corners(const Scene& scene, const glm::uvec3& t, const AttributeChannel& channel) {
    const auto axis = int(channel.axis);
    const auto of = [&](const auto& values) {
        return std::array<double, 3>{values[t.x][axis], values[t.y][axis], values[t.z][axis]};
    };
    switch (channel.attribute) {
        case Attribute::barycentrics:
            return axis == 0 ? std::array{0.0, 1.0, 0.0} : std::array{0.0, 0.0, 1.0};
        case Attribute::uv:
            return of(scene.vertices.uv.front());
        case Attribute::normal:
            return of(scene.vertices.normal_world);
        case Attribute::position:
            return of(scene.vertices.position_world);
    }
    return {};
}

double attribute_slack(const Surface& s, const InterpolationErrors& errors, const std::array<double, 3>& a,
                       Attribute attribute) {
    constexpr double underflow = 0x1p-126;
    // a normal may be brought to unit length: a common factor, and 3 roundings
    const double of_length = attribute == Attribute::normal ? gamma(3, unit_roundoff_float32) : 0;
    const auto [low, high] = std::ranges::minmax(a);
    const double largest = std::max(std::abs(low), std::abs(high));
    const double of_weights = high > low ? (high - low) * s.spread * compounded(errors.of_weights) : 0;
    return compounded(errors.relative + of_length) * largest * s.spread + of_weights + underflow;
}

/// A position may also be made from the depth: origin + depth direction, in float32 at least.
ValuesBetween by_depth(const DepthBound& depth, double origin, double direction) {
    if (std::isinf(depth.high)) return {-unlimited, unlimited};
    const double a = origin + depth.low * direction, b = origin + depth.high * direction;
    const double largest = std::max(std::abs(depth.low), std::abs(depth.high));
    const double error = gamma(4, unit_roundoff_float32) * (std::abs(origin) + largest * std::abs(direction));
    return {std::min(a, b) - error, std::max(a, b) + error};
}

/// A surface, and how values may have been taken from it.
struct SampledSurface {
    const Surface& surface;
    InterpolationErrors errors;

    double half_side() const { return surface.seen.bounds.depth_eps_px; }
    template <class Number>
    std::optional<std::vector<Weights<Number>>> places() const {
        const ViewRay<Number> ray(surface.facts.view, surface.pixel.x, surface.pixel.y);
        const auto image = image_of(ray, corners<Number>(surface.p_world()));
        if (!image) return std::nullopt;
        return extreme_places(*image, half_side(), errors.sampled);
    }
};

/// decide(places) in intervals, then in rationals; true where the triangle has no image.
template <class Decide>
bool decided(const SampledSurface& s, const Decide& decide) {
    const auto by = [&]<class Number>(Number) {
        const auto places = s.places<Number>();
        return !places || decide(*places);
    };
    try {
        return by(Interval());
    } catch (const UndecidedSign&) {
        return by(Rational());
    }
}

/// The range of a value, widened by its slack.
template <class Number>
ValueRange<Number> widened(const std::vector<Weights<Number>>& places, const InterpolatedValue& v) {
    const ValueRange<Number> range = range_of(places, v.at_corners);
    return {range.low - Number(v.slack), range.high + Number(v.slack)};
}

bool is_admissible(const SampledSurface& s, const InterpolatedValue& v) {
    return v.by_depth.holds(v.value) ||
           decided(s, [&]<class Number>(const std::vector<Weights<Number>>& places) {
               const ValueRange<Number> range = widened(places, v);
               const Number value{double(v.value)};
               return sign(range.high - value) >= 0 && sign(value - range.low) >= 0;
           });
}

/// Has the direction of these values a multiple that lies in the box of their ranges?
template <class Number>
bool meets_box(const std::vector<Weights<Number>>& places, const std::vector<InterpolatedValue>& values) {
    struct Side {
        Number length;  ///< of the direction along an axis, at least 0
        ValueRange<Number> range;
    };
    std::vector<Side> sides;
    for (const InterpolatedValue& v : values) {
        const ValueRange<Number> range = widened(places, v);
        if (v.value == 0 && (sign(range.low) > 0 || sign(range.high) < 0)) return false;
        if (v.value > 0) sides.push_back({Number(double(v.value)), range});
        if (v.value < 0) sides.push_back({Number(-double(v.value)), {-range.high, -range.low}});
    }
    for (const Side& a : sides) {
        if (sign(a.range.high) <= 0) return false;
        for (const Side& b : sides)
            if (sign(a.range.high * b.length - b.range.low * a.length) < 0) return false;
    }
    return true;
}

bool is_direction(Attribute attribute) { return attribute == Attribute::normal; }

/// The value at the pixel's centre, and how far double may be off.
struct AtCentre {
    double value, own_error;
};

AtCentre at_centre(const Surface& s, const InterpolatedValue& v) {
    const Weights<double> w = weights_at<double>(*s.seen.image, 0, 0);
    const auto [low, high] = std::ranges::minmax(v.at_corners);
    const double of_weights = 3 * s.seen.edge_error / s.least_sum * (high - low);
    const double largest = std::max(std::abs(low), std::abs(high));
    return {w.blend(v.at_corners), s.spread * (2 * of_weights + 0x1p-48 * largest)};
}

double squared_length(const std::array<double, 3>& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// What the frame's values are to be multiplied by to be held against their ranges one by one: 1 but for a
/// direction.
double scale_of(const Surface& s, const std::vector<InterpolatedValue>& values) {
    if (!is_direction(attribute_channels[values.front().channel].attribute)) return 1;
    std::array<double, 3> given{}, truth{};
    for (std::size_t i = 0; i < 3; ++i) {
        given[i] = values[i].value;
        truth[i] = at_centre(s, values[i]).value;
    }
    const double scale = std::sqrt(squared_length(truth) / squared_length(given));
    return std::isfinite(scale) && scale > 0 ? scale : 1;
}

/// Double is sure of most values: they are what the centre has, but for arithmetic.
bool are_those_of_centre(const Surface& s, const std::vector<InterpolatedValue>& values) {
    const double scale = scale_of(s, values);
    return std::ranges::all_of(values, [&](const InterpolatedValue& v) {
        const AtCentre centre = at_centre(s, v);
        return std::abs(scale * v.value - centre.value) + centre.own_error +
                   0x1p-48 * std::abs(centre.value) <=
               v.slack;
    });
}

/// A value in double, for people.
WrongAttribute told(const SampledSurface& s, const InterpolatedValue& v, double scale) {
    WrongAttribute wrong{.channel = v.channel,
                         .value = v.value,
                         .low = -unlimited,
                         .truth = at_centre(s.surface, v).value / scale,
                         .high = unlimited};
    if (std::isfinite(v.slack)) {
        const auto range = widened(extreme_places(*s.surface.seen.image, s.half_side(), s.errors.sampled), v);
        wrong.low = std::min(range.low, v.by_depth.low) / scale;
        wrong.high = std::max(range.high, v.by_depth.high) / scale;
    }
    wrong.error_over_bound = error_over_bound({wrong.low, wrong.truth, wrong.high}, wrong.value);
    return wrong;
}

WrongAttribute worst_of(const SampledSurface& s, const std::vector<InterpolatedValue>& values) {
    const double scale = scale_of(s.surface, values);
    WrongAttribute worst = told(s, values.front(), scale);
    for (const InterpolatedValue& v : values) {
        const WrongAttribute here = told(s, v, scale);
        if (!(here.error_over_bound <= worst.error_over_bound)) worst = here;
    }
    return worst;
}

std::optional<WrongAttribute> first_wrong(const SampledSurface& s,
                                          const std::vector<InterpolatedValue>& values) {
    const auto is_nothing = [](const InterpolatedValue& v) { return !std::isfinite(v.value); };
    if (const auto nothing = std::ranges::find_if(values, is_nothing); nothing != values.end())
        return told(s, *nothing, 1);
    const auto is_unlimited = [](const InterpolatedValue& v) { return !std::isfinite(v.slack); };
    if (are_those_of_centre(s.surface, values) || std::ranges::any_of(values, is_unlimited))
        return std::nullopt;
    if (is_direction(attribute_channels[values.front().channel].attribute)) {
        const auto decide = [&](const auto& places) { return meets_box(places, values); };
        return decided(s, decide) ? std::nullopt : std::optional(worst_of(s, values));
    }
    const auto wrong =
        std::ranges::find_if(values, [&](const InterpolatedValue& v) { return !is_admissible(s, v); });
    return wrong == values.end() ? std::nullopt : std::optional(told(s, *wrong, 1));
}

/// A value that is no number, where nothing else can be asked.
std::optional<WrongAttribute> first_infinite(const Attributes& given, const std::vector<Attribute>& judged,
                                             const PixelCoord& pixel) {
    for (std::size_t c = 0; c < attribute_channels.size(); ++c) {
        if (std::ranges::count(judged, attribute_channels[c].attribute) == 0) continue;
        const float value = given.planes[c].at(pixel.x, pixel.y);
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        if (!std::isfinite(value)) return WrongAttribute{c, value, -unlimited, nan, unlimited, nan};
    }
    return std::nullopt;
}

std::vector<Attribute> given_attributes(const Attributes& given) {
    std::vector<Attribute> attributes;
    for (const Attribute attribute :
         {Attribute::barycentrics, Attribute::uv, Attribute::normal, Attribute::position})
        if (given.has(attribute)) attributes.push_back(attribute);
    return attributes;
}

std::vector<Attribute> judged_attributes(const Scene& scene, const View& view, const Attributes& given,
                                         const Precision& precision) {
    std::vector<Attribute> judged;
    if (promises_attributes(precision, view.camera.projection)) judged = given_attributes(given);
    std::erase_if(judged, [&](Attribute attribute) { return !scene_has(scene, attribute); });
    return judged;
}

}  // namespace

AttributeCheck::AttributeCheck(const Scene& scene, const View& view, const Frame& frame,
                               const Precision& precision)
    : scene_(scene),
      facts_(view),
      frame_(frame),
      precision_(precision),
      varying_bounds_(view, varying_precision(precision)),
      shown_bounds_(view, shown_precision(precision)),
      judged_(judged_attributes(scene, view, frame.attributes, precision)) {}

std::vector<InterpolatedValue> AttributeCheck::values_of(Attribute attribute, const Surface& surface,
                                                         const InterpolationErrors& errors,
                                                         const glm::uvec3& triangle) const {
    const PixelCoord& pixel = surface.pixel;
    std::vector<InterpolatedValue> values;
    for (std::size_t c = 0; c < attribute_channels.size(); ++c) {
        const AttributeChannel& channel = attribute_channels[c];
        if (channel.attribute != attribute) continue;
        const auto corners = at_corners(scene_, triangle, channel);
        values.push_back({.channel = c,
                          .value = frame_.attributes.planes[c].at(pixel.x, pixel.y),
                          .at_corners = corners,
                          .slack = attribute_slack(surface, errors, corners, attribute),
                          .by_depth = {}});
    }
    if (attribute != Attribute::position) return values;
    const TriangleInView in_view(facts_.view, shown_bounds_, surface.p_world());
    const DepthBound depth = TriangleDepth(in_view, shown_bounds_).at(pixel.x, pixel.y);
    const Vector3<double>&o = surface.ray.origin, &d = surface.ray.direction;
    values[0].by_depth = by_depth(depth, o.x, d.x);
    values[1].by_depth = by_depth(depth, o.y, d.y);
    values[2].by_depth = by_depth(depth, o.z, d.z);
    return values;
}

std::optional<WrongAttribute> AttributeCheck::first_wrong(const PixelCoord& pixel) const {
    const auto id = std::uint32_t(frame_.primitive.at(pixel.x, pixel.y));
    if (judged_.empty() || id >= scene_.triangles.size()) return std::nullopt;
    const auto surface = surface_at(facts_, varying_bounds_, corners_of(scene_, id), pixel);
    if (!surface) return first_infinite(frame_.attributes, judged_, pixel);
    const SampledSurface s{*surface, interpolation_errors(precision_, *surface)};
    for (const Attribute attribute : judged_) {
        const std::vector<InterpolatedValue> values =
            values_of(attribute, *surface, s.errors, scene_.triangles[id]);
        if (auto wrong = zproof::first_wrong(s, values)) return wrong;
    }
    return std::nullopt;
}

std::vector<std::string> unjudged_attributes(const Scene& scene, const View& view, const Attributes& given,
                                             const Precision& precision) {
    std::vector<std::string> reasons;
    for (const Attribute attribute : given_attributes(given)) {
        const std::string name{name_of(attribute)};
        if (!promises_attributes(precision, view.camera.projection))
            reasons.push_back(
                name + ": not judged, since the declared precision says nothing of interpolation here");
        else if (!scene_has(scene, attribute))
            reasons.push_back(name + ": not judged, since the scene has none");
    }
    return reasons;
}

}  // namespace zproof
