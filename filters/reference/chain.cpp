#include "filters/reference/chain.h"

#include <algorithm>
#include <numbers>

namespace zproof::oracle::filter_reference {

namespace {

/// The exact overlap of texel [c, c + 1) of n with the fine texels, each n / fine_size wide: integers until
/// the last quotient.
Sources polyphase(int coarse, int coarse_size, int fine_size) {
    Sources sources;
    const std::int64_t n = coarse_size, begin = std::int64_t{coarse} * fine_size,
                       end = (std::int64_t{coarse} + 1) * fine_size;
    for (std::int64_t i = begin / n; i * n < end; ++i) {
        const std::int64_t overlap = std::min((i + 1) * n, end) - std::max(i * n, begin);
        sources.push_back({int(i), double(overlap) / double(fine_size)});
    }
    return sources;
}

double lanczos(double x) {
    if (x == 0) return 1;
    if (std::abs(x) >= 3) return 0;
    const double angle = std::numbers::pi * x;
    return 3 * std::sin(angle) * std::sin(angle / 3) / (angle * angle);
}

/// I0 by its power series, sum (x / 2)^2k / k!^2, until a term adds nothing.
double bessel_i0(double x) {
    double sum = 1, term = 1;
    for (int k = 1; sum + term != sum; ++k) sum += term *= (x / 2 / k) * (x / 2 / k);
    return sum;
}

/// Kaiser's window of width 3 and alpha 4, as NVIDIA Texture Tools has it.
double kaiser(double x) {
    if (std::abs(x) >= 3) return 0;
    const double angle = std::numbers::pi * x, window = bessel_i0(4 * std::sqrt((1 - x / 3) * (1 + x / 3)));
    return (x == 0 ? 1 : std::sin(angle) / angle) * window / bessel_i0(4);
}

/// The window is three coarse texels wide to either side; what lies beyond the edge is wrapped; weights sum
/// to 1.
Sources windowed(double (*window)(double), int coarse, const Axis& axis) {
    const double step = double(axis.fine) / axis.coarse, centre = (coarse + 0.5) * step;
    Sources sources;
    double sum = 0;
    const auto first = std::int64_t(std::floor(centre - 3 * step)) - 1;
    for (std::int64_t i = first; double(i) < centre + 3 * step + 1; ++i) {
        const double weight = window((double(i) + 0.5 - centre) / step);
        sources.push_back({wrapped_index(axis.wrap, i, axis.fine), weight});
        sum += weight;
    }
    for (Source& source : sources) source.weight /= sum;
    return sources;
}

Sources sources_of(ChainKernel kernel, int coarse, const Axis& axis) {
    if (axis.coarse == axis.fine) return {{coarse, 1}};
    if (kernel == ChainKernel::box) return {{2 * coarse, 0.5}, {2 * coarse + 1, 0.5}};
    if (kernel == ChainKernel::polyphase) return polyphase(coarse, axis.coarse, axis.fine);
    return windowed(kernel == ChainKernel::lanczos3 ? lanczos : kaiser, coarse, axis);
}

/// The nearest float16, to even (IEEE 754 binary16): 11 significant bits, multiples of 2^-24.
double as_float16(double value) {
    const double step = std::ldexp(1.0, std::max(std::ilogb(value), -14) - 10);
    return std::nearbyint(value / step) * step;
}

IntervalImage as_float16(IntervalImage image) {
    for (IntervalImage::Texel& texel : image.texels)
        for (int c = 0; c < 3; ++c) texel.value[c] = texel.value[c] == 0 ? 0 : as_float16(texel.value[c]);
    return with_range(std::move(image));
}

}  // namespace

StoredUnit stored_unit(double texel_bits) {
    return {std::exp2(-texel_bits), texel_bits < FilterPrecision{}.texel_bits ? 0x1p-25 : 0x1p-149};
}

IntervalImage::Texel made_of(const IntervalImage& finer, const Sources& columns, const Sources& rows,
                             const StoredUnit& unit) {
    IntervalImage::Texel sum;
    glm::dvec3 size{0};
    for (const Source& row : rows) {
        for (const Source& column : columns) {
            const double w = row.weight * column.weight;
            const auto& texel = finer.at(column.index, row.index);
            sum.value += w * texel.value;
            sum.radius += std::abs(w) * texel.radius;
            size += std::abs(w) * (glm::abs(texel.value) + texel.radius);
        }
    }
    // The stored format; weights and sums of an implementation and of ours, of at most 17 x 17 terms with
    // weights good to 16 roundings.
    sum.radius += (unit.relative + 2 * (17 * 17 + 32) * 0x1p-53) * size + unit.least;
    return sum;
}

std::vector<Sources> all_sources(ChainKernel kernel, const Axis& axis) {
    std::vector<Sources> all;
    for (int i = 0; i < axis.coarse; ++i) all.push_back(sources_of(kernel, i, axis));
    return all;
}

IntervalImage shrunk(const IntervalImage& finer, int width, int height, const Settings& settings) {
    const StoredUnit unit = stored_unit(settings.texel_bits);
    const auto columns = all_sources(settings.kernel, {finer.width, width, settings.wrap.u}),
               rows = all_sources(settings.kernel, {finer.height, height, settings.wrap.v});
    IntervalImage coarser{width, height, {}, {}};
    coarser.texels.reserve(std::size_t(width) * std::size_t(height));
    for (const Sources& row : rows)
        for (const Sources& column : columns) coarser.texels.push_back(made_of(finer, column, row, unit));
    coarser = with_range(std::move(coarser));
    return settings.format == LevelFormat::float32 ? coarser : as_float16(std::move(coarser));
}

std::vector<IntervalImage> chain(const texture::LinearImage& image, const Settings& settings) {
    const IntervalImage finest = exact_image(image);
    std::vector<IntervalImage> levels{settings.format == LevelFormat::float16_throughout ? as_float16(finest)
                                                                                         : finest};
    if (settings.given_levels) {
        for (const texture::LinearImage& level : *settings.given_levels) levels.push_back(exact_image(level));
        return levels;
    }
    while (levels.back().width > 1 || levels.back().height > 1) {
        const IntervalImage& finer = levels.back();
        levels.push_back(shrunk(finer, half_of(finer.width), half_of(finer.height), settings));
    }
    return levels;
}

}  // namespace zproof::oracle::filter_reference
