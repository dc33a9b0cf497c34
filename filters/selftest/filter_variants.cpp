#include "filters/selftest/filter_variants.h"

#include <cmath>
#include <utility>

#include "filters/methods/tap_rule.h"
#include "filters/stored/cardinality_table.h"
#include "filters/stored/summed_area.h"
#include "filters/stored/two_reads_table.h"
#include "math/mixed.h"

namespace zproof::selftest {

namespace {

using texture::FilterOptions;
using texture::LinearImage;

glm::dvec4 bilinear(const LinearImage& image, const texture::Addressing& wrap, const glm::dvec2& place) {
    glm::dvec4 sum{0};
    texture::read_bilinear(
        image, wrap, place, {.image = 0, .column = 0, .row = 0, .weight = 1},
        [&](const texture::Tap& tap) { sum += tap.weight * glm::dvec4{image.at(tap.column, tap.row)}; });
    return sum;
}

glm::dvec2 size_of(const LinearImage& image) { return {image.width, image.height}; }

double longer_step(const Footprint& f) { return std::max(glm::length(f.per_x), glm::length(f.per_y)); }

double clamped_lod(double lod, const FilterOptions& o) {
    return std::clamp(lod + o.lod_bias, o.lod_min, o.lod_max);
}

/// The integral of the product of two boxes' filters.
struct BoxFilter {
    glm::dvec2 low, high;

    double area() const { return (high.x - low.x) * (high.y - low.y); }
    double times(const BoxFilter& other) const {
        const glm::dvec2 shared = glm::max(glm::min(high, other.high) - glm::max(low, other.low), 0.0);
        return shared.x * shared.y / (area() * other.area());
    }
};

/// Weights of at most four texels, by least squares without a condition on the sum; in the finest level's
/// texels.
glm::dvec4 free_weights(std::span<const texture::TableTap> taps, const glm::dvec2& place, double half) {
    std::vector<BoxFilter> boxes;
    for (const texture::TableTap& tap : taps) {
        const double size = 1 << tap.level;
        const glm::dvec2 low = size * (glm::floor(place / size) + glm::dvec2{tap.column, tap.row});
        boxes.push_back({low, low + size});
    }
    glm::dmat4 products{1};
    glm::dvec4 with_target{0};
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        with_target[int(i)] = boxes[i].times({place - half, place + half});
        for (std::size_t j = 0; j < boxes.size(); ++j) products[int(i)][int(j)] = boxes[i].times(boxes[j]);
    }
    return glm::inverse(products) * with_target;
}

/// Each texel of the smaller image from the 2 x 2 (or fewer) that it covers.
LinearImage halved(const LinearImage& finer, glm::ivec2 size,
                   const std::function<glm::vec4(const std::array<glm::vec4, 4>&)>& mix) {
    LinearImage image{size.x, size.y, {}};
    for (int row = 0; row < size.y; ++row)
        for (int column = 0; column < size.x; ++column) {
            const auto texel = [&](int right, int down) {
                return finer.at(std::min(2 * column + right, finer.width - 1),
                                std::min(2 * row + down, finer.height - 1));
            };
            image.texels.push_back(mix({texel(0, 0), texel(1, 0), texel(0, 1), texel(1, 1)}));
        }
    return image;
}

template <class Mix>
std::vector<LinearImage> chain_by(const LinearImage& image, int rounding, Mix mix) {
    std::vector<LinearImage> levels{image};
    const auto half = [&](int size) { return std::max(1, (size + rounding) / 2); };
    while (levels.back().width > 1 || levels.back().height > 1)
        levels.push_back(halved(levels.back(), {half(levels.back().width), half(levels.back().height)}, mix));
    return levels;
}

glm::vec4 mean(const std::array<glm::vec4, 4>& t) { return (t[0] + t[1] + t[2] + t[3]) / 4.0f; }

/// IEC 61966-2-1, both ways.
float encoded(float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f; }
float decoded(float x) { return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); }

glm::vec4 each(const glm::vec4& t, float (*f)(float)) { return {f(t.r), f(t.g), f(t.b), t.a}; }

}  // namespace

texture::Method made_of(std::function<Colour(const LinearImage&, const FilterOptions&)> prepare) {
    return {
        .name = "faulty",
        .card = {},
        .prepare = [prepare = std::move(prepare)](const LinearImage& image, const FilterOptions& options) {
            return texture::Sampler{.colour = prepare(image, options), .taps = {}, .stored = {}};
        }};
}

texture::Method distorted(const texture::Method& method, Distortion distortion) {
    return made_of(
        [method, distortion = std::move(distortion)](const LinearImage& image, const FilterOptions& options) {
            return Colour{[sampler = method.prepare(image, options), distortion, size = size_of(image)](
                              const Footprint& f) { return sampler.colour(distortion(f, size)); }};
        });
}

texture::Method trilinear(const Trilinear& parts) {
    return made_of([parts](const LinearImage& image, const FilterOptions& o) -> Colour {
        auto levels =
            parts.chain ? parts.chain(image) : texture::mip_chain(image, o.mip_kernel, o.addressing);
        return [levels = std::move(levels), parts, o](const Footprint& f) {
            const double raw = std::log2(longer_step(f)),
                         biased = parts.adjusted ? parts.adjusted(raw, o) : clamped_lod(raw, o);
            const double within = std::clamp(biased, 0.0, double(levels.size()) - 1),
                         lod = parts.level ? parts.level(within) : within;
            const auto read = [&](double level) {
                const LinearImage& at = levels[std::size_t(std::min(level, double(levels.size()) - 1))];
                return bilinear(at, o.addressing,
                                f.centre * size_of(at) / size_of(levels[0]) + parts.level_shift);
            };
            return glm::mix(read(std::floor(lod)), read(std::floor(lod) + 1),
                            parts.share(lod - std::floor(lod)));
        };
    });
}

std::vector<LinearImage> averaged_as_stored(const LinearImage& image) {
    return chain_by(image, 0, [](const std::array<glm::vec4, 4>& t) {
        return each(
            mean({each(t[0], encoded), each(t[1], encoded), each(t[2], encoded), each(t[3], encoded)}),
            decoded);
    });
}

std::vector<LinearImage> sizes_rounded_up(const LinearImage& image) { return chain_by(image, 1, mean); }

std::vector<LinearImage> by_one_texel_of_four(const LinearImage& image) {
    return chain_by(image, 0, [](const std::array<glm::vec4, 4>& t) { return t[0]; });
}

texture::Method elliptical(const Ellipse& parts) {
    return made_of([parts](const LinearImage& image, const FilterOptions& o) -> Colour {
        return
            [levels = texture::mip_chain(image, o.mip_kernel, o.addressing), parts, o](const Footprint& f) {
                glm::dvec2 longer = f.per_x * parts.radius, shorter = f.per_y * parts.radius;
                if (glm::length(longer) < glm::length(shorter)) std::swap(longer, shorter);
                const double ratio = glm::length(longer) / (glm::length(shorter) * o.max_anisotropy);
                if (ratio > 1) shorter *= ratio;
                const double coarsest = double(levels.size()) - 1;
                const double lod = std::clamp(std::log2(glm::length(shorter)), 0.0, coarsest);
                const auto read = [&](double at) {
                    const LinearImage& level = levels[std::size_t(std::min(at, coarsest))];
                    const glm::dvec2 scale = size_of(level) / size_of(levels[0]), p = longer * scale,
                                     q = shorter * scale;
                    const glm::dvec2 centre = f.centre * scale - 0.5;
                    const double a = p.y * p.y + q.y * q.y + parts.widening,
                                 c = p.x * p.x + q.x * q.x + parts.widening, b = -2 * (p.x * p.y + q.x * q.y),
                                 whole = a * c - b * b / 4;
                    const glm::dvec2 reach{std::sqrt(c), std::sqrt(a)};
                    glm::dvec4 sum{0};
                    double weights = 0;
                    for (double row = std::ceil(centre.y - reach.y); row <= centre.y + reach.y; ++row)
                        for (double column = std::ceil(centre.x - reach.x); column <= centre.x + reach.x;
                             ++column) {
                            const double du = column - centre.x, dv = row - centre.y,
                                         r2 = (a * du * du + b * du * dv + c * dv * dv) / whole;
                            if (r2 >= 1) continue;
                            const double k = std::floor(128 * r2) / 127;
                            const double weight = std::exp(-parts.steepness * k) - std::exp(-parts.steepness);
                            weights += weight;
                            sum += weight *
                                   glm::dvec4{level.at(
                                       texture::wrapped(o.addressing.u, std::int64_t(column), level.width),
                                       texture::wrapped(o.addressing.v, std::int64_t(row), level.height))};
                        }
                    // The mean of the weight over a unit circle is what a whole ellipse of area pi
                    // sqrt(whole) holds.
                    const double expected =
                        std::sqrt(whole) * 3.141592653589793 * ((1 - std::exp(-2.0)) / 2 - std::exp(-2.0));
                    return sum / (parts.weights == Ellipse::Weights::normalised ? weights : expected);
                };
                return glm::mix(read(std::floor(lod)), read(std::floor(lod) + 1), lod - std::floor(lod));
            };
    });
}

texture::Method summed_box(const SummedBox& parts) {
    return made_of([parts](const LinearImage& image, const FilterOptions& o) -> Colour {
        const auto table = std::make_shared<const texture::SummedArea>(image, o.sat_storage);
        return [table, parts, o](const Footprint& f) {
            const glm::dvec2 side =
                glm::max((glm::abs(f.per_x) + glm::abs(f.per_y)) * parts.scale, parts.least);
            const glm::dvec2 low = f.centre - side / 2.0, high = f.centre + side / 2.0;
            const double kept = std::max(side.y - parts.rows_left_out, 0x1p-10);
            const glm::dvec4 mean =
                table->mean(texture::covered({low.x, high.x}, o.addressing.u, table->width()),
                            texture::covered({low.y, low.y + kept}, o.addressing.v, table->height()));
            return mean * (kept / (side.y + parts.rows_counted));
        };
    });
}

texture::Method constrained_freely() {
    return made_of([](const LinearImage& image, const FilterOptions& o) -> Colour {
        return [levels = texture::mip_chain(image, o.mip_kernel, o.addressing), o,
                table = texture::CardinalityTable{4}](const Footprint& f) {
            const int coarsest = int(levels.size()) - 1;
            const double level = std::clamp(clamped_lod(std::log2(longer_step(f)), o), 0.0, double(coarsest));
            const int lod = int(std::floor(8 * level + 0.5)),
                      finest = std::clamp(lod / 8 - 1, 0, coarsest - 2);
            const glm::dvec2 point =
                glm::floor(8.0 * f.centre * size_of(levels[std::size_t(finest)]) / size_of(levels[0]) + 0.5);
            if (lod == 8 * coarsest) return glm::dvec4{levels.back().at(0, 0)};
            const glm::dvec2 within = point - 32.0 * glm::floor(point / 32.0);
            const auto taps = table.at(int(within.x), int(within.y), lod - 8 * finest);
            const glm::dvec4 weights =
                free_weights(taps, within / 8.0, std::exp2((lod - 8 * finest) / 8.0) / 2);
            glm::dvec4 sum{0};
            for (std::size_t i = 0; i < taps.size(); ++i) {
                const LinearImage& from = levels[std::size_t(finest + taps[i].level)];
                const glm::dvec2 holder = glm::floor(point / double(8 << taps[i].level));
                sum += weights[int(i)] *
                       glm::dvec4{from.at(
                           texture::wrapped(o.addressing.u, int(holder.x) + taps[i].column, from.width),
                           texture::wrapped(o.addressing.v, int(holder.y) + taps[i].row, from.height))};
            }
            return sum;
        };
    });
}

texture::Method two_reads_displaced(double times) {
    return made_of([times](const LinearImage& image, const FilterOptions& o) -> Colour {
        return [times, levels = texture::mip_chain(image, o.mip_kernel, o.addressing), o,
                table = texture::TwoReadsTable{}](const Footprint& f) {
            const int coarsest = int(levels.size()) - 1;
            const double lod = std::clamp(clamped_lod(std::log2(longer_step(f)), o), 0.0, double(coarsest));
            if (lod >= coarsest)
                return bilinear(levels.back(), o.addressing, f.centre / size_of(levels.front()));
            const int finer = std::max(int(lod) - 1, 0);
            const LinearImage &fine = levels[std::size_t(finer)], &coarse = levels[std::size_t(finer + 1)];
            const glm::dvec2 place = f.centre * size_of(coarse) / size_of(levels.front()),
                             cell = glm::floor(8.0 * (place - glm::floor(place)));
            const texture::TwoReads reads =
                table.at(int(8 * std::exp2(lod - finer) + 0.5), {int(cell.x), int(cell.y)});
            const double share = reads.share / 64.0;
            return share * bilinear(fine, o.addressing, 2.0 * place + times / 8 * glm::dvec2{reads.finer}) +
                   (1 - share) *
                       bilinear(coarse, o.addressing, place + times / 8 * glm::dvec2{reads.coarser});
        };
    });
}

texture::Method drawn_by_one_number() {
    return made_of([](const LinearImage& image, const FilterOptions& o) -> Colour {
        return [image, wrap = o.addressing](const Footprint& f) {
            const auto pixel = std::uint64_t(f.centre_raster.x) << 32 | std::uint64_t(f.centre_raster.y);
            const double number = double(mixed(pixel) >> 11) * 0x1p-53;
            const glm::dvec2 low = glm::floor(f.centre - 0.5), share = f.centre - 0.5 - low;
            const auto index = [&](double before, double part) {
                return std::int64_t(before) + (number < part ? 1 : 0);
            };
            return glm::dvec4{image.at(texture::wrapped(wrap.u, index(low.x, share.x), image.width),
                                       texture::wrapped(wrap.v, index(low.y, share.y), image.height))};
        };
    });
}

}  // namespace zproof::selftest
