/// Ways to make a texture filter wrong: by what it is told of the pixel, and by parts of it written anew.
#pragma once

#include "filters/selftest/filter_fixture.h"
#include "filters/stored/mip_chain.h"
#include "rasterizer/texturing.h"

namespace zproof::selftest {

using texture::Footprint;

/// The method, told another footprint than the pixel's; `size` is the texture's, texels.
using Distortion = std::function<Footprint(Footprint, const glm::dvec2& size)>;
texture::Method distorted(const texture::Method& method, Distortion distortion);

/// A method of that name whose sampler is this function of the footprint.
using Colour = std::function<glm::dvec4(const Footprint&)>;
texture::Method made_of(
    std::function<Colour(const texture::LinearImage&, const texture::FilterOptions&)> prepare);

/// Trilinear by the longer step, each part of which can be exchanged.
struct Trilinear {
    std::function<std::vector<texture::LinearImage>(const texture::LinearImage&)> chain{};
    std::function<double(double)> share = [](double fraction) { return fraction; };  ///< of the coarser level
    std::function<double(double)> level{};  ///< LOD -> level, after bias and clamp
    std::function<double(double, const texture::FilterOptions&)> adjusted{};  ///< bias and clamp
    glm::dvec2 level_shift{0};  ///< added to the place within each level, texels
};
texture::Method trilinear(const Trilinear& parts);

/// Chains with a fault in them.
std::vector<texture::LinearImage> averaged_as_stored(
    const texture::LinearImage& image);  ///< not in linear light
std::vector<texture::LinearImage> sizes_rounded_up(const texture::LinearImage& image);
std::vector<texture::LinearImage> by_one_texel_of_four(const texture::LinearImage& image);

/// pbrt's elliptical weighted average.
struct Ellipse {
    double widening = 1;  ///< texels added to the radii, in square
    double radius = 1;    ///< of the steps
    enum class Weights { normalised, as_they_are } weights = Weights::normalised;
    double steepness = 2;  ///< exp(-steepness r^2)
};
texture::Method elliptical(const Ellipse& parts);

/// The mean over the affine bounding box from a summed-area table.
struct SummedBox {
    int rows_left_out = 0, rows_counted = 0;  ///< at the lower edge; in the divisor
    double scale = 1;
    double least = 1;  ///< texels, of a side
};
texture::Method summed_box(const SummedBox& parts);

/// Cardinality-constrained, four texels, of weights whose sum is free. For levels that halve evenly.
texture::Method constrained_freely();

/// Two bilinear reads, so many times as far beside the place as the table says. For levels that halve evenly.
texture::Method two_reads_displaced(double times);

/// Stochastic bilinear, one sample; column and row are decided by the same number.
texture::Method drawn_by_one_number();

}  // namespace zproof::selftest
