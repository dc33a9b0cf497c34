/// What a renderer interpolated over the triangle that each pixel shows.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "frame/plane.h"

namespace zproof {

enum class Attribute {
    barycentrics,  ///< weights of the triangle's second and third corner
    uv,            ///< of the first uv set
    normal,        ///< of shading, world space; its direction counts, not its length
    position,      ///< world space, scene units
};

/// In the names of channels.
constexpr std::string_view name_of(Attribute attribute) {
    constexpr std::array<std::string_view, 4> names{"bary", "uv", "normal", "position"};
    return names[std::size_t(attribute)];
}

/// One number of an attribute, and how files call it.
struct AttributeChannel {
    std::string_view name;
    Attribute attribute;
    std::size_t axis;
};

inline constexpr std::array<AttributeChannel, 10> attribute_channels{{
    {"bary.u", Attribute::barycentrics, 0},
    {"bary.v", Attribute::barycentrics, 1},
    {"uv.u", Attribute::uv, 0},
    {"uv.v", Attribute::uv, 1},
    {"normal.X", Attribute::normal, 0},
    {"normal.Y", Attribute::normal, 1},
    {"normal.Z", Attribute::normal, 2},
    {"position.X", Attribute::position, 0},
    {"position.Y", Attribute::position, 1},
    {"position.Z", Attribute::position, 2},
}};

/// Values at the pixels' centres; what stands at a pixel of background means nothing. A renderer gives an
/// attribute with all of its channels, or not at all.
struct Attributes {
    /// In the order of attribute_channels; 0 x 0 where the renderer does not give it.
    std::array<Plane<float>, attribute_channels.size()> planes;

    bool has(std::size_t channel) const { return planes[channel].size().width > 0; }
    bool has(Attribute attribute) const {
        const auto of = std::ranges::find(attribute_channels, attribute, &AttributeChannel::attribute);
        return has(std::size_t(of - attribute_channels.begin()));
    }
    bool are_given() const {
        return std::ranges::any_of(planes, [](const auto& plane) { return plane.size().width > 0; });
    }
};

}  // namespace zproof
