#include "filters/reference/lod.h"

namespace zproof::oracle::filter_reference {

Interval area(const PixelFootprint& f) { return magnitude(f.per_x.u * f.per_y.v - f.per_y.u * f.per_x.v); }

/// Eigenvalues of J J^T are mean +- radius; the product of the axes is the area.
Axes axes(const PixelFootprint& f) {
    const Interval a = square(f.per_x.u) + square(f.per_y.u), c = square(f.per_x.v) + square(f.per_y.v);
    const Interval h = f.per_x.u * f.per_x.v + f.per_y.u * f.per_y.v, half{0.5};
    const Interval major = square_root((a + c) * half + length((a - c) * half, h));
    return {major, area(f) / major};
}

Interval chord_log2(const Interval& a) {
    const auto chord = [](double x) {
        if (!(x > 0)) return -std::numeric_limits<double>::infinity();
        int exponent = 0;
        const double mantissa = 2 * std::frexp(x, &exponent);
        return exponent - 1 + (mantissa - 1);
    };
    return widen({chord(a.low()), chord(a.high())}, 0x1p-45);
}

Interval lod(LodRule rule, const PixelFootprint& f) {
    const Interval across = length(f.per_x.u, f.per_x.v), down = length(f.per_y.u, f.per_y.v), half{0.5};
    const Interval largest = larger(larger(magnitude(f.per_x.u), magnitude(f.per_x.v)),
                                    larger(magnitude(f.per_y.u), magnitude(f.per_y.v)));
    switch (rule) {
        case LodRule::gl_maximum:
            return log2(larger(across, down));
        case LodRule::mesa_longer_step:
            return half * chord_log2(larger(square(across), square(down)));
        case LodRule::ellipse_major:
            return log2(axes(f).major);
        case LodRule::root_mean_square:
            return half * log2((square(across) + square(down)) * half);
        case LodRule::root_of_area:
            return half * log2(area(f));
        case LodRule::largest_coordinate:
            return log2(largest);
        case LodRule::pbrt:
            return log2(largest) + Interval{1};
    }
    return {};
}

/// Sixteen roundings of an implementation's way to the number whose logarithm is taken cost 16 u / ln 2
/// levels (d log2 x = dx / (x ln 2)); the logarithm, bias and sum of levels four more of themselves.
Interval level_of(const Interval& lod, const Settings& settings, std::size_t level_count,
                  const FilterPrecision& precision) {
    const double unit = std::exp2(-precision.coordinate_bits);
    const double size =
        std::max(std::abs(std::max(lod.low(), -64.0)), std::abs(lod.high())) + std::abs(settings.lod_bias);
    const double rounding = unit * (16 / std::log(2.0) + 4 * size);
    const Interval permitted = lod + Interval{-precision.lod_below, precision.lod_above};
    const Interval biased =
        widen(permitted + Interval{settings.lod_bias}, std::exp2(-precision.lod_bits) + rounding);
    return clamped(clamped(biased, settings.lod_min, settings.lod_max), 0, double(level_count) - 1);
}

}  // namespace zproof::oracle::filter_reference
