/// The part of a texture that a pixel and a method have to do with, small enough to be drawn.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "filters/methods/recorder.h"
#include "texture/linear_image.h"

namespace zproof::study {

/// Cells of block x block texels, row by row; the first begins at texel (column, row) of the endless line,
/// where kernels have their places.
struct TextureWindow {
    int column = 0, row = 0;
    int width = 0, height = 0;  ///< cells
    int block = 1;
    std::vector<glm::vec3> colour;    ///< mean of a cell, linear
    std::vector<double> read, exact;  ///< sums of weights; empty where there is no such kernel
};

/// What a window must hold.
struct WindowContent {
    const texture::Footprint& footprint;
    const texture::Kernel* read = nullptr;   ///< null: none
    const texture::Kernel* exact = nullptr;  ///< null: none
};

/// The footprint's parallelogram and both kernels, with the least whole block that keeps to so many cells
/// along either side.
TextureWindow texture_window(const WindowContent& content, const texture::LinearImage& image,
                             const texture::Addressing& addressing, int most_cells);

/// The corners of the pixel's square on the texture by its Jacobian, texels, round the pixel from its upper
/// left one.
std::array<glm::dvec2, 4> parallelogram(const texture::Footprint& footprint);

}  // namespace zproof::study
