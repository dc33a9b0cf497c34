/// Prefiltered copies of a texture, each half the size of the one before (Williams 1983), and what they are
/// made of.
#pragma once

#include <stdexcept>

#include "texture/method.h"

namespace zproof::texture {

/// What one column (or row) of a smaller image is made of: columns of the larger one with their weights,
/// which sum to 1.
struct AxisShare {
    int index = 0;
    double weight = 0;
};
using AxisWeights = std::vector<std::vector<AxisShare>>;

/// The weights that take `size` to max(1, floor(size / 2)), by the kernel; size 1 stays as it is.
///   box        halves of 2i and 2i + 1; the last of an odd size has no part in it
///   polyphase  of n = 2m + 1: m - i, m and i + 1, over n, at 2i, 2i + 1 and 2i + 2 (Guthe and Heckbert 2005:
///              the mean of the piecewise constant over [i n / m, (i + 1) n / m]); box where n is even
///   lanczos3   sinc(x) sinc(x / 3), |x| < 3, at x = (j + 1/2) m / n - (i + 1/2) over all j of the wrapped
///              line, divided by their sum
///   kaiser3    the same of sinc(x) I0(4 sqrt(1 - (x / 3)^2)), I0 the modified Bessel function
AxisWeights halving(int size, MipKernel kernel, Wrap wrap);

/// The weights of both steps in one: what `coarse` is made of at the size that `fine` starts from.
AxisWeights composed(const AxisWeights& coarse, const AxisWeights& fine);

/// The weights that leave a line as it is.
AxisWeights identity(int size);

/// Columns and rows weighted by product, summed in double, rounded once to float32.
LinearImage resampled(const LinearImage& image, const AxisWeights& columns, const AxisWeights& rows);

/// Level 0 is the image; level k + 1 is made of level k and has max(1, floor(size / 2)) texels on either
/// side, down to 1 x 1. Averages are of linear light. The addressing is what lies beyond the edge for kernels
/// that reach over it.
std::vector<LinearImage> mip_chain(const LinearImage& image, MipKernel kernel,
                                   const Addressing& addressing = {});

/// A level that is given has not the size of its place in the chain.
struct MipChainError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The chain that the options ask for: level 0 is the image, the others are made of it or given. A given one
/// has max(1, floor(size / 2)) texels of the one before it on either side, else this throws MipChainError. It
/// may end early.
std::vector<LinearImage> mip_chain(const LinearImage& image, const FilterOptions& options);

/// The levels of that chain as a sampler's stored images, made of level 0 by the exact weights of the chain
/// (the rounding of each level to float32 apart). What levels that are given are made of is not known: of
/// these, too, it is told as if the kernel had made them.
std::vector<StoredImage> stored_mip_chain(const LinearImage& image, MipKernel kernel,
                                          const Addressing& addressing = {});

/// A float32 image whose columns and rows are made of level 0 by these weights.
StoredImage stored_image(const AxisWeights& columns, const AxisWeights& rows);

}  // namespace zproof::texture
