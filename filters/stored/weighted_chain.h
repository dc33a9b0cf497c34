/// A mip chain whose texels do not count alike: Manson and Schaefer 2012, Parameterization-Aware MIP-Mapping,
/// the part that weighs texels by area.
#pragma once

#include "texture/method.h"

namespace zproof::texture {

/// Made of level 0's weights, row by row. A texel of the next level is the mean of those that the kernel
/// makes it of, each by the kernel's weight times its own; the kernel's mean of their weights is its own.
/// Where these weigh alike, nothing too, it is the kernel's mean, to the last bit.
class WeightedChain {
  public:
    WeightedChain(const LinearImage& image, std::vector<double> weights, MipKernel kernel);

    /// From level 1 on.
    const std::vector<LinearImage>& smaller() const { return smaller_; }
    /// All levels, made of level 0 by the exact weights.
    std::vector<StoredImage> stored() const;

  private:
    int width_, height_;
    MipKernel kernel_;
    std::vector<double> weights_;
    std::vector<LinearImage> smaller_;
};

}  // namespace zproof::texture
