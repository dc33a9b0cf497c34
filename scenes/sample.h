/// Where within its pixels a view is sampled (docs/samples.md).
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace zproof {

/// The centre, unless told otherwise.
struct Sample {
    int index = 0, count = 1;    ///< in its pattern, from 0
    glm::dvec2 offset_px{0, 0};  ///< from the pixel's centre, x right, y down; see is_sample_offset()
};

/// Is it a multiple of 1/256 px in [-1/2, 1/2)? Then the sample lies in the pixel, and its raster position is
/// exact in float32 for images of up to 32768 px.
bool is_sample_offset(const glm::dvec2& offset_px);

/// "-0.125": all digits.
std::string px_text(double offset_px);

/// "standard:4:2", "-0.125,0.375"; empty for the centre.
std::string sample_word(const Sample& sample);

}  // namespace zproof
