/// The exact mean of a piecewise-constant, wrapped texture over a box (Crow 1984), from whole-number sums of
/// the filter reference's own.
#pragma once

#include "filters/reference/interval_image.h"

namespace zproof::oracle::filter_reference {

/// Texels of level 0.
struct Box {
    Interval left, right, top, bottom;  ///< left < right, top < bottom
};

class BoxMean {
  public:
    BoxMean(const texture::LinearImage& image, const WrapRules& wrap);

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
    std::vector<Sum> sums_;
    glm::dvec3 spread_{0};     ///< greatest less least texel
    glm::dvec3 quantized_{0};  ///< how far a texel may lie from its multiple
};

}  // namespace zproof::oracle::filter_reference
