/// The few texels of two levels of a mip chain that best make the mean over a square, by least squares (after
/// Manson and Schaefer 2013). What is chosen is decided in whole numbers.
#pragma once

#include <span>
#include <vector>

namespace zproof::texture {

/// A texel of the finer level or of the next coarser one, counted from the one there that holds the place.
struct ConstrainedTexel {
    enum class Level { finer, coarser } level = Level::finer;
    int column = 0, row = 0;
    double weight = 0;
};

/// The sum of an entry's weights: held at 1, or whatever least squares make of it.
enum class WeightTotal { one, free };

/// An entry for each square: its side is 9 to 16 eighths of a finer texel, its centre that of one of 16 x 16
/// cells of a coarser texel.
class ConstrainedTexels {
  public:
    ConstrainedTexels(int most, WeightTotal total);

    /// At most `most` texels; fewer where they make the whole mean. Cells count from 0.
    std::span<const ConstrainedTexel> at(int side_eighths, int column_cell, int row_cell) const;

  private:
    std::vector<std::vector<ConstrainedTexel>> entries_;
};

}  // namespace zproof::texture
