#include "reports/pages/error_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace zproof {
namespace {

/// Five colours of viridis (van der Walt and Smith 2015, CC0): lightness grows evenly.
constexpr std::array<std::array<double, 3>, 5> anchors{
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
constexpr Rgb8 unknown{128, 128, 128};

std::uint8_t mixed(std::size_t anchor, std::size_t channel, double share) {
    const double value = (1 - share) * anchors[anchor][channel] + share * anchors[anchor + 1][channel];
    return std::uint8_t(std::lround(value));
}

Rgb8 colour_of(double place) {
    const double along = std::clamp(place, 0.0, 1.0) * double(anchors.size() - 1);
    const auto anchor = std::min(std::size_t(along), anchors.size() - 2);
    const double share = along - double(anchor);
    return {mixed(anchor, 0, share), mixed(anchor, 1, share), mixed(anchor, 2, share)};
}

}  // namespace

Plane<Rgb8> error_colours(const Plane<float>& errors, const ErrorScale& scale) {
    Plane<Rgb8> picture(errors.size(), unknown);
    const double decades = std::log10(scale.high / scale.low);
    for (std::size_t i = 0; i < errors.pixels().size(); ++i) {
        const double error = double(errors.pixels()[i]);
        if (std::isnan(error)) continue;
        const double place = error > 0 ? std::log10(error / scale.low) / decades : 0;
        picture.pixels()[i] = colour_of(place);
    }
    return picture;
}

}  // namespace zproof
