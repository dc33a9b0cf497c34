#include "tests/filters/limited_sampler.h"

#include <cmath>

#include "filters/stored/mip_chain.h"

namespace zproof {

namespace {

using texture::FilterOptions;
using texture::Footprint;
using texture::LinearImage;

glm::dvec2 size_of(const LinearImage& image) { return {image.width, image.height}; }

std::vector<LinearImage> chain(const LinearImage& image, const FilterOptions& o) {
    return texture::mip_chain(image, o.mip_kernel, o.addressing);
}

using Colour = std::function<glm::dvec4(const Footprint&)>;

texture::Method made_of(const std::function<Colour(const LinearImage&, const FilterOptions&)>& colour_of) {
    return {.name = "limited",
            .card = {},
            .prepare = [colour_of](const LinearImage& image, const FilterOptions& options) {
                return texture::Sampler{.colour = colour_of(image, options), .taps = {}, .stored = {}};
            }};
}

/// 11 significant bits; of texels that are no denormals.
void keep_as_float16(LinearImage& level) {
    for (glm::vec4& texel : level.texels)
        for (int c = 0; c < 4; ++c) {
            int exponent = 0;
            const double fraction = std::frexp(double(texel[c]), &exponent);
            texel[c] = float(std::ldexp(std::nearbyint(std::ldexp(fraction, 11)), exponent - 11));
        }
}

std::vector<LinearImage> chain_with_halves(const LinearImage& image, const FilterOptions& o, int from) {
    std::vector<LinearImage> levels{image};
    for (int number = 0;; ++number) {
        if (number >= from) keep_as_float16(levels.back());
        const std::vector<LinearImage> below = chain(levels.back(), o);
        if (below.size() == 1) return levels;
        levels.push_back(below[1]);
    }
}

/// One axis alone: g++ 12.2 vectorises a pair of double -> float -> double into nothing at all.
double as_float32(double texels, double size) { return double{float(texels / size)} * size; }

glm::dvec4 texel_of(const LinearImage& image, const texture::Addressing& wrap, double column, double row) {
    return glm::dvec4{image.at(texture::wrapped(wrap.u, std::int64_t(column), image.width),
                               texture::wrapped(wrap.v, std::int64_t(row), image.height))};
}

/// A level's part in a blend: share times what is read.
glm::dvec4 part_of(const LinearImage& image, const texture::Addressing& wrap, const glm::dvec2& place,
                   double share, const LimitedTrilinear& parts) {
    const double left = std::floor(place.x - 0.5), top = std::floor(place.y - 0.5);
    const double x = std::clamp(parts.weights(place.x - 0.5 - left), 0.0, 1.0),
                 y = std::clamp(parts.weights(place.y - 0.5 - top), 0.0, 1.0);
    const auto split = [&](double whole, double at) {
        return std::clamp(parts.splits(whole * at), 0.0, whole);
    };
    const double right = split(share, x), lower_right = split(right, y),
                 upper_left = split(share - right, 1 - y);
    return upper_left * texel_of(image, wrap, left, top) +
           (right - lower_right) * texel_of(image, wrap, left + 1, top) +
           (share - right - upper_left) * texel_of(image, wrap, left, top + 1) +
           lower_right * texel_of(image, wrap, left + 1, top + 1);
}

}  // namespace

double Lattice::operator()(double x) const {
    if (std::isinf(bits)) return x + offset;
    const double steps = std::exp2(bits), scaled = x * steps;
    return (rounding == Rounding::nearest ? std::floor(scaled + 0.5) : std::floor(scaled)) / steps + offset;
}

texture::Method limited_trilinear(const LimitedTrilinear& parts) {
    return made_of([parts](const LinearImage& image, const FilterOptions& o) -> Colour {
        return [levels = chain_with_halves(image, o, parts.half_levels_from), parts, o](const Footprint& f) {
            const glm::dvec2 size = size_of(levels[0]);
            glm::dvec2 place = f.centre + parts.place_error;
            if (parts.is_float32) {
                place.x = as_float32(place.x, size.x);
                place.y = as_float32(place.y, size.y);
            }
            const double longer = std::max(glm::length(f.per_x), glm::length(f.per_y));
            const double biased = parts.lod(std::log2(longer) + o.lod_bias);
            const double last = double(levels.size()) - 1;
            const double lod = std::clamp(std::clamp(biased, o.lod_min, o.lod_max), 0.0, last);
            const auto part = [&](double level, double share) {
                const LinearImage& at = levels[std::size_t(std::min(level, last))];
                return part_of(at, o.addressing, place * size_of(at) / size, share, parts);
            };
            const double finer = std::floor(lod), share = std::clamp(parts.blend(lod - finer), 0.0, 1.0);
            return parts.gain * (part(finer, 1 - share) + part(finer + 1, share));
        };
    });
}

namespace {

/// A weight of the ellipse at r^2: exp(-2 r^2) - exp(-2), by a table or not.
double ellipse_weight(const LimitedEllipse& parts, double r2) {
    const int n = parts.table_entries;
    const double at = n == 0 ? r2 : std::min(std::floor(n * r2), n - 1.0) / (n - 1);
    return parts.weights(std::exp(-2 * at) - std::exp(-2.0));
}

glm::dvec4 read_ellipse(const LinearImage& level, const FilterOptions& o, const LimitedEllipse& parts,
                        const std::array<glm::dvec2, 3>& axes_and_centre) {
    const auto& [p, q, place] = axes_and_centre;
    const glm::dvec2 centre = place - 0.5;
    const double a = p.y * p.y + q.y * q.y + 1, c = p.x * p.x + q.x * q.x + 1,
                 b = -2 * (p.x * p.y + q.x * q.y);
    const double whole = a * c - b * b / 4;
    const glm::dvec2 reach{std::sqrt(c), std::sqrt(a)};
    glm::dvec4 sum{0};
    double weights = 0;
    for (double row = std::ceil(centre.y - reach.y); row <= centre.y + reach.y; ++row)
        for (double column = std::ceil(centre.x - reach.x); column <= centre.x + reach.x; ++column) {
            const double du = column - centre.x, dv = row - centre.y,
                         r2 = (a * du * du + b * du * dv + c * dv * dv) / whole;
            if (r2 >= 1) continue;
            const double weight = ellipse_weight(parts, r2);
            weights += weight;
            sum += weight * texel_of(level, o.addressing, column, row);
        }
    return sum / weights;
}

}  // namespace

texture::Method limited_ellipse(const LimitedEllipse& parts) {
    return made_of([parts](const LinearImage& image, const FilterOptions& o) -> Colour {
        return [levels = chain(image, o), parts, o](const Footprint& f) {
            glm::dvec2 longer = f.per_x, shorter = f.per_y;
            if (glm::length(longer) < glm::length(shorter)) std::swap(longer, shorter);
            const double ratio = glm::length(longer) / (glm::length(shorter) * o.max_anisotropy);
            if (ratio > 1 && parts.is_clamped) shorter *= ratio;
            const double last = double(levels.size()) - 1;
            const double lod = std::clamp(std::log2(glm::length(shorter)) + o.lod_bias, 0.0, last);
            const auto read = [&](double at) {
                const LinearImage& level = levels[std::size_t(std::min(at, last))];
                const glm::dvec2 scale = size_of(level) / size_of(levels[0]);
                return read_ellipse(level, o, parts, {longer * scale, shorter * scale, f.centre * scale});
            };
            return glm::mix(read(std::floor(lod)), read(std::floor(lod) + 1), lod - std::floor(lod));
        };
    });
}

}  // namespace zproof
