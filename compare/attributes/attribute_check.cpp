#include "compare/attributes/attribute_check.h"

#include <algorithm>
#include <cmath>
#include <span>

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

std::vector<Attribute> given_attributes(const Attributes& given) {
    std::vector<Attribute> attributes;
    for (const Attribute attribute :
         {Attribute::barycentrics, Attribute::uv, Attribute::normal, Attribute::position})
        if (given.has(attribute)) attributes.push_back(attribute);
    return attributes;
}

/// The first wrong one of an attribute's values.
std::optional<WrongAttribute> first_wrong_of(const SampledSurface& sampled, std::span<const ReadValue> read) {
    std::vector<InterpolatedValue> values;
    values.reserve(read.size());
    for (const ReadValue& v : read) {
        InterpolatedValue value =
            interpolated_value(sampled.surface, sampled.errors, v.channel, v.at_corners, v.value);
        value.slack += v.further_slack;
        if (value.slack_at_centre >= 0) value.slack_at_centre += v.further_slack;
        value.means.low -= v.further_slack;
        value.means.high += v.further_slack;
        values.push_back(value);
    }
    return first_wrong(sampled, values);
}

}  // namespace

std::vector<Attribute> judged_attributes(const Scene& scene, const View& view, const Attributes& given,
                                         const Precision& precision) {
    std::vector<Attribute> judged;
    if (promises_attributes(precision, view.camera.projection)) judged = given_attributes(given);
    std::erase_if(judged, [&](Attribute attribute) { return !scene_has(scene, attribute); });
    return judged;
}

AttributeCheck::AttributeCheck(const Scene& scene, const View& view, const Frame& frame,
                               const Precision& precision)
    : scene_(scene),
      facts_(view),
      frame_(frame),
      precision_(precision),
      varying_bounds_(view, varying_precision(precision)),
      shown_bounds_(ViewBounds::of_shown(view, precision)),
      judged_(judged_attributes(scene, view, frame.attributes, precision)) {}

CheckedAttributes AttributeCheck::at(const PixelCoord& pixel) const {
    const auto id = std::uint32_t(frame_.primitive.at(pixel.x, pixel.y));
    if (judged_.empty() || id >= scene_.triangles.size()) return {};
    const Surface surface = surface_at(facts_, varying_bounds_, corners_of(scene_, id), pixel);
    const SampledSurface sampled = sampled_from(surface);
    for (const Attribute attribute : judged_)
        if (auto wrong = first_wrong_of(sampled, values_at(pixel, attribute).values)) return {.wrong = wrong};
    return {.is_open = sampled.errors.may_be_anything};
}

SampledSurface AttributeCheck::sampled_from(const Surface& surface) const {
    const auto [x, y] = surface.pixel;
    const double given = frame_.camera_depth.at(x, y), depth = std::isfinite(given) ? given : 0;
    return {
        surface, interpolation_errors(precision_, surface, depth), depth, {&shown_bounds_, &varying_bounds_}};
}

AttributeValues AttributeCheck::values_at(const PixelCoord& pixel, Attribute attribute) const {
    const auto id = std::uint32_t(frame_.primitive.at(pixel.x, pixel.y));
    AttributeValues all{.p_world = corners_of(scene_, id), .values = {}};
    all.values.reserve(3);
    for (std::size_t c = 0; c < attribute_channels.size(); ++c)
        if (attribute_channels[c].attribute == attribute)
            all.values.push_back({c, at_corners(scene_, scene_.triangles[id], attribute_channels[c]),
                                  frame_.attributes.planes[c].at(pixel.x, pixel.y)});
    return all;
}

bool AttributeCheck::are_admissible(const PixelCoord& pixel, const AttributeValues& values) const {
    const Surface surface = surface_at(facts_, varying_bounds_, values.p_world, pixel);
    const SampledSurface sampled = sampled_from(surface);
    if (values.alternatives.empty()) return !first_wrong_of(sampled, values.values);
    return std::ranges::all_of(values.alternatives, [&](const std::vector<ReadValue>& of_axis) {
        return std::ranges::any_of(of_axis, [&](const ReadValue& value) {
            return !first_wrong_of(sampled, {&value, 1});
        });
    });
}

std::vector<std::string> unjudged_attributes(const Scene& scene, const View& view, const Attributes& given,
                                             const Precision& precision) {
    std::vector<std::string> reasons;
    for (const Attribute attribute : given_attributes(given)) {
        const std::string name{name_of(attribute)};
        if (!promises_attributes(precision, view.camera.projection))
            reasons.push_back(name +
                              " not judged: the declared precision says nothing of interpolation here");
        else if (!scene_has(scene, attribute))
            reasons.push_back(name + " not judged: the scene has none");
    }
    return reasons;
}

}  // namespace zproof
