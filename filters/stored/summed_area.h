/// Summed-area tables (Crow 1984): the mean over any box of a texture from a few stored sums.
#pragma once

#include <cstdint>
#include <memory>
#include <variant>

#include "texture/coverage.h"
#include "texture/method.h"

namespace zproof::texture {

/// Sums of texels over [0, i] x [0, j] for every (i, j), four channels. All sums are of whole numbers, in
/// multiples of `unit`: exact for what is decoded from 8 bits of sRGB, else each texel is rounded to the
/// nearest multiple. The storage rounds a sum once:
///
///   integer            64 bits, modulo 2^64. A difference is exact wherever the box's own sum is below 2^28,
///                      which is so for 2^28 texels of at most 1
///   float64            53 bits
///   float32            24 bits: docs/summed-area.md tells what is lost
///   float32_less_mean  24 bits, of texels less the image's mean, which is added again to a box
class SummedArea {
  public:
    static constexpr double unit = 0x1p-35;

    /// Throws std::runtime_error where the absolute texels of a channel sum to 2^28 or more, and are not kept
    /// as integers.
    SummedArea(const LinearImage& image, SatStorage storage);

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t bytes_per_texel() const;

    /// The sum over the texels of two runs, from four stored sums; their weights are not applied.
    glm::dvec4 sum(const Run& columns, const Run& rows) const;

    /// The mean over a box of the wrapped texture: the exact integral of the piecewise-constant texture, but
    /// for the storage and for rounding in double.
    glm::dvec4 mean(const Parts<Run>& columns, const Parts<Run>& rows) const;

    /// A stored sum as a number; modulo 2^64 units where the storage is integer.
    glm::dvec4 stored(int column, int row) const;

  private:
    template <class Number>
    using Sums = std::unique_ptr<glm::vec<4, Number>[]>;

    template <class Number>
    void keep(const LinearImage& image);
    template <class Number>
    glm::dvec4 sum_of(const Sums<Number>& sums, const Run& columns, const Run& rows) const;

    int width_ = 0, height_ = 0;
    glm::dvec4 mean_{0};  ///< multiples of unit; 0 but for float32_less_mean
    std::variant<Sums<std::uint64_t>, Sums<double>, Sums<float>> sums_;
};

}  // namespace zproof::texture
