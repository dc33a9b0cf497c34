#include "filters/conformance/permitted_interval.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace zproof {

namespace {

constexpr float endless = std::numeric_limits<float>::infinity();

float least_float_of(double low) {
    const float nearest = float(low);
    return double(nearest) < low ? std::nextafter(nearest, endless) : nearest;
}

float greatest_float_of(double high) {
    const float nearest = float(high);
    return double(nearest) > high ? std::nextafter(nearest, -endless) : nearest;
}

}  // namespace

PermittedFloats permitted_floats(const LinearRgb& colour, const PermittedColours& permitted) {
    const auto& [low, high] = nearest_range(colour, permitted);
    return {{least_float_of(low.r), least_float_of(low.g), least_float_of(low.b)},
            {greatest_float_of(high.r), greatest_float_of(high.g), greatest_float_of(high.b)}};
}

PermittedInterval permitted_interval(const Picture& picture, const PixelReference& reference,
                                     const FilterPrecision& precision) {
    const Resolution size = picture.size();
    PermittedInterval interval{Picture{size}, Picture{size}};
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const auto& [least, greatest] = permitted_floats(picture.at(x, y), reference(x, y, precision));
            interval.least.at(x, y) = least, interval.greatest.at(x, y) = greatest;
        }
    });
    return interval;
}

double distance_outside(float value, float least, float greatest) {
    if (!std::isfinite(value) || least > greatest) return double{endless};
    return std::max({0.0, double(least) - double(value), double(value) - double(greatest)});
}

double distance_outside(const LinearRgb& colour, const LinearRgb& least, const LinearRgb& greatest) {
    return std::max({distance_outside(colour.r, least.r, greatest.r),
                     distance_outside(colour.g, least.g, greatest.g),
                     distance_outside(colour.b, least.b, greatest.b)});
}

std::uint64_t pixels_outside(const Picture& picture, const PermittedInterval& permitted) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        count += distance_outside(picture.pixels()[i], permitted.least.pixels()[i],
                                  permitted.greatest.pixels()[i]) > 0;
    return count;
}

}  // namespace zproof
