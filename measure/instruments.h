/// One function per thing that is measured. Each throws Unmeasurable where the pictures make no sense.
#pragma once

#include <array>
#include <vector>

#include "measure/measurement.h"
#include "measure/renderer.h"

namespace zproof::measure {

/// Where pixels are sampled, by Axis: from the upper left corner of the pixel, px. Needs an image 4096 px
/// long; the bracket is 1/2047 px wide, for samples between -1 and 1.
std::array<Bracket, 2> pixel_centre(const Renderer& renderer);

/// A sample position that is taken to be exact, px from the pixel's upper left corner.
struct Sample {
    double x = 0.5, y = 0.5;
};

/// How vertices move along one axis.
Displacement displacement(const Renderer& renderer, const Sample& sample, Axis axis);

/// Ownership of centres on edges in 16 directions, every octant and its borders.
FillSides fill_sides(const Renderer& renderer, const Sample& sample);

/// The steps at depths 1.5, 24 and 384 between near 1 and far 512, in both projections.
std::vector<DepthStep> depth_steps(const Renderer& renderer);

/// The limits at near 0.75 and far 96, in both projections.
std::vector<DepthLimit> depth_limits(const Renderer& renderer);

/// Meshes of shared edges over 128 x 128 px, with many pixel centres on edges.
Watertightness watertightness(const Renderer& renderer, const Sample& sample);

}  // namespace zproof::measure
