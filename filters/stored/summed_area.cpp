#include "filters/stored/summed_area.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace zproof::texture {

namespace {

using Units = glm::vec<4, std::uint64_t>;

/// A texel in units, rounded to the nearest; negative ones modulo 2^64.
Units in_units(const glm::dvec4& texel) {
    Units units;
    for (int c = 0; c < 4; ++c) units[c] = std::uint64_t(std::llrint(texel[c] / SummedArea::unit));
    return units;
}

glm::dvec4 from_units(const Units& sum) {
    return glm::dvec4(glm::vec<4, std::int64_t>(sum)) * SummedArea::unit;
}

/// Light brighter than white may add up to more than 64 bits of units.
void refuse_large_sums(const LinearImage& image) {
    glm::dvec4 sum{0};
    for (const glm::vec4& texel : image.texels) sum += glm::abs(glm::dvec4(texel));
    if (std::max({sum.r, sum.g, sum.b, sum.a}) >= 0x1p63 * SummedArea::unit)
        throw std::runtime_error{
            "a summed-area table holds sums below 2^28, and this texture's is larger: scale "
            "its light down, or keep sums as integers (sat=integer)"};
}

/// The image's mean, rounded to units.
glm::dvec4 mean_of(const LinearImage& image) {
    Units total{0};
    for (const glm::vec4& texel : image.texels) total += in_units(glm::dvec4(texel));
    return from_units(in_units(from_units(total) / double(image.texels.size())));
}

}  // namespace

template <class Number>
void SummedArea::keep(const LinearImage& image) {
    auto sums = std::make_unique_for_overwrite<glm::vec<4, Number>[]>(image.texels.size());
    std::vector<Units> above(std::size_t(width_), Units{0});  // sums of the columns so far
    const Units mean = in_units(mean_);
    for (int row = 0; row < height_; ++row) {
        Units running{0};
        for (int column = 0; column < width_; ++column) {
            running += above[std::size_t(column)] += in_units(glm::dvec4(image.at(column, row))) - mean;
            const std::size_t at = std::size_t(row) * std::size_t(width_) + std::size_t(column);
            if constexpr (std::is_same_v<Number, std::uint64_t>)
                sums[at] = running;
            else
                sums[at] = glm::vec<4, Number>(glm::vec<4, std::int64_t>(running));
        }
    }
    sums_ = std::move(sums);
}

SummedArea::SummedArea(const LinearImage& image, SatStorage storage)
    : width_(image.width), height_(image.height) {
    if (storage != SatStorage::integer) refuse_large_sums(image);
    if (storage == SatStorage::float32_less_mean) mean_ = mean_of(image);
    if (storage == SatStorage::integer)
        keep<std::uint64_t>(image);
    else if (storage == SatStorage::float64)
        keep<double>(image);
    else
        keep<float>(image);
}

std::size_t SummedArea::bytes_per_texel() const {
    return std::visit([](const auto& sums) { return sizeof(sums[0]); }, sums_);
}

namespace {

/// The difference of four sums over whole texels; a sum over no texel is 0.
template <class Vector>
Vector difference(const auto& sums, int width, const Run& columns, const Run& rows) {
    const auto up_to = [&](int column, int row) {
        if (column == 0 || row == 0) return Vector{0};
        return Vector(sums[std::size_t(row - 1) * std::size_t(width) + std::size_t(column - 1)]);
    };
    return (up_to(columns.last, rows.last) - up_to(columns.first, rows.last)) -
           (up_to(columns.last, rows.first) - up_to(columns.first, rows.first));
}

}  // namespace

template <class Number>
glm::dvec4 SummedArea::sum_of(const Sums<Number>& sums, const Run& columns, const Run& rows) const {
    if constexpr (std::is_same_v<Number, std::uint64_t>) {
        return from_units(difference<Units>(sums, width_, columns, rows));
    } else {
        const double area = double(columns.last - columns.first) * (rows.last - rows.first);
        return area * mean_ + unit * difference<glm::dvec4>(sums, width_, columns, rows);
    }
}

glm::dvec4 SummedArea::sum(const Run& columns, const Run& rows) const {
    return std::visit([&](const auto& sums) { return sum_of(sums, columns, rows); }, sums_);
}

glm::dvec4 SummedArea::mean(const Parts<Run>& columns, const Parts<Run>& rows) const {
    return std::visit(
        [&](const auto& sums) {
            glm::dvec4 mean{0};
            for (const Run& down : rows.all())
                for (const Run& across : columns.all())
                    mean += across.weight * down.weight * sum_of(sums, across, down);
            return mean;
        },
        sums_);
}

glm::dvec4 SummedArea::stored(int column, int row) const {
    const std::size_t at = std::size_t(row) * std::size_t(width_) + std::size_t(column);
    return std::visit(
        [&](const auto& sums) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(sums[0])>, Units>)
                return from_units(sums[at]);
            else
                return unit * glm::dvec4(sums[at]);
        },
        sums_);
}

}  // namespace zproof::texture
