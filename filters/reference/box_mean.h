/// The exact mean of a piecewise-constant, wrapped texture over a box (Crow 1984), from whole-number sums of
/// the filter reference's own.
#pragma once

#include <limits>

#include "filters/reference/interval_image.h"

namespace zproof::oracle::filter_reference {

/// Texels of level 0.
struct Box {
    Interval left, right, top, bottom;  ///< left < right, top < bottom
};

class BoxMean {
  public:
    /// `more_texels`: a hypothesis, by how many a box ends beyond what its area says, in u and v.
    BoxMean(const texture::LinearImage& image, const WrapRules& wrap, const glm::ivec2& more_texels);

    /// All means that the box may have, and what sums stored at the unit 2^-sum_bits may cost.
    ColourRange over(const Box& stated, const FilterPrecision& precision) const;

  private:
    using Sum = glm::vec<3, std::int64_t>;
    /// Sum over texels [0, column) x [0, row), multiples of 2^-35: what decoded 8-bit sRGB is made of.
    const Sum& sum(int column, int row) const {
        return sums_[std::size_t(row) * std::size_t(width_ + 1) + std::size_t(column)];
    }

    int width_, height_;
    WrapRules wrap_;
    glm::dvec2 more_texels_;
    std::vector<Sum> sums_;
    glm::dvec3 least_{std::numeric_limits<double>::infinity()}, most_{-least_};  ///< texel
    glm::dvec3 quantized_{0};  ///< how far a texel may lie from its multiple
};

}  // namespace zproof::oracle::filter_reference
