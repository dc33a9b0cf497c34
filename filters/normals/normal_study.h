/// How far highlights of filtered normal maps are from the exact mean of the highlights of their texels.
#pragma once

#include <string>

#include "filters/normals/normal_map.h"
#include "rasterizer/texturing.h"
#include "scenes/view.h"

namespace zproof::normals {

/// A distant light and a distant eye: one half vector for the whole picture.
struct Light {
    glm::dvec3 half{0, 0, 1};  ///< unit, tangent space
    double shininess = 64;     ///< Blinn and Phong's exponent
};

/// A way to a highlight, and how far it is off: root mean square over the pixels that one surface fills.
struct HighlightScore {
    std::string model;
    double rmse = 0;
};

/// The truth is the mean of (n . h)^s over the pixel's square, every texel's normal constant. Models: "mean
/// normal", "toksvig", "lean", each of what the filter makes of the map, and "filtered highlights": the
/// filter of the texels' own. The scene shows one image, at factor 1. Runs on the threads of the surrounding
/// tbb::task_arena.
std::vector<HighlightScore> highlight_scores(const Scene& scene, const View& view, const NormalMap& map,
                                             const Light& light, const rasterizer::Texturing& filter);

}  // namespace zproof::normals
