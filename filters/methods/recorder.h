/// The weight recorder: what a method's result is made of, texel by texel of level 0, at any footprint. Every
/// method is linear in the texels, so this kernel tells all about it but for rounding.
#pragma once

#include "texture/method.h"

namespace zproof::texture {

/// Level 0 as the method reads it.
struct BaseLevel {
    int width = 0, height = 0;  ///< texels
    Addressing addressing{};
};

/// Weights of the texels in a rectangle of level 0 that holds all which count. On a repeated axis the texels
/// are those nearest to the footprint's centre, so columns and rows may be negative or beyond the size; a
/// kernel wider than the texture is folded onto one period of it.
struct Kernel {
    int first_column = 0, first_row = 0;
    int width = 0, height = 0;
    std::vector<double> weights;  ///< row by row

    double at(int column, int row) const {
        return weights[std::size_t(row - first_row) * std::size_t(width) +
                       std::size_t(column - first_column)];
    }
};

/// The kernel from the taps and what the stored values that they read are made of. Weights below 2^-40 of the
/// largest are 0: sums of a summed-area table cancel up to some 2^-50 of it.
Kernel record(const Sampler& sampler, const Footprint& footprint, const BaseLevel& base_level);

/// The kernel of these shares of level 0, whose rectangles lie within it, as record() places it round a
/// footprint's centre.
Kernel kernel_of(std::span<const Share> shares, const BaseLevel& base_level, const glm::dvec2& centre);

/// A kernel as a distribution of weight over texels' centres.
struct KernelShape {
    double sum = 0;             ///< 1 for a method that keeps constants
    glm::dvec2 centroid{0};     ///< texels; not finite where the sum is 0, nor is the covariance
    glm::dmat2 covariance{0};   ///< texels^2, about the centroid
    double negative_share = 0;  ///< negative weight over all weight, signs dropped: 0 to 1
};
KernelShape shape_of(const Kernel& kernel);

}  // namespace zproof::texture
