/// Tables of repeated sums (Heckbert 1986): a window that is an n-fold box, from few stored sums and without
/// rounding.
#pragma once

#include "filters/stored/repeated_axis.h"
#include "filters/stored/summed_area.h"
#include "texture/method.h"

namespace zproof::texture {

/// Texels, summed up `order` times along either axis: four channels of 128 bits in multiples of
/// SummedArea::unit, modulo 2^128. A window's sum is exact wherever it is below 2^92 itself, which is so for
/// texels below 2^16 and runs of at most RepeatedAxis::longest_run.
class RepeatedSums {
  public:
    RepeatedSums(const LinearImage& image, const Addressing& addressing, int order);

    int order() const { return order_; }
    const RepeatedAxis& columns() const { return columns_; }
    const RepeatedAxis& rows() const { return rows_; }

    /// The sum over stored sums, each as often as its column's and its row's term say.
    glm::dvec4 sum(const std::vector<SumTerm>& columns, const std::vector<SumTerm>& rows) const;

    /// Every texel before it has a part in a stored sum, so that of larger tables nobody is told them.
    static constexpr std::size_t most_told = 1 << 14;

    /// The table, and what a stored sum is made of where it has at most most_told sums.
    StoredImage stored_image(const LinearImage& image, const Addressing& addressing) const;

  private:
    __extension__ using Wide = unsigned __int128;
    struct Units {
        Wide channels[4];
    };

    std::size_t index(int column, int row) const {
        return std::size_t(row) * std::size_t(columns_.stored()) + std::size_t(column);
    }
    void sum_up(std::size_t first, std::size_t stride, int count);

    int order_;
    RepeatedAxis columns_, rows_;
    std::vector<Units> sums_;
};

}  // namespace zproof::texture
