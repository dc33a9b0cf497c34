/// How a pixel gets its depth from a triangle's corners: four ways, in float32.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "lessons/depth/format.h"

namespace zproof::study::depth {

enum class Interpolation {
    reciprocal,  ///< 1/d by barycentrics, then the coding, pixel by pixel
    ndc,         ///< the corners' coded values by barycentrics: right for z, which is affine in the image
    forward,     ///< the same by steps: one addition per pixel and one per row
    affine,      ///< d itself by barycentrics, as if the image were not in perspective: wrong
};

inline constexpr std::array all_interpolations{Interpolation::reciprocal, Interpolation::ndc,
                                               Interpolation::forward, Interpolation::affine};

const char* name_of(Interpolation interpolation);
const char* definition_of(Interpolation interpolation);

/// Does it interpolate something that is affine in the image, so that rounding is its only error?
bool is_right_for(Interpolation interpolation, Coding coding);

/// A triangle in the image, before near: every corner's depth is positive.
struct Drawn {
    std::array<glm::dvec2, 3> p_raster;  ///< px
    std::array<float, 3> depth;          ///< camera depth, rounded once

    double doubled_area() const;  ///< px^2, signed
};

struct Pixel {
    int x = 0, y = 0;
};

/// Barycentrics of a raster position, in double. The area must not be 0.
std::array<double, 3> weights_at(const Drawn& triangle, const glm::dvec2& p_raster);

/// The pixels' coded values s before they are stored. `pixels` lie in the triangle, in raster order.
///
/// Barycentrics are computed in double from the corners' places and rounded once each; so are the start and
/// the two steps of `forward`, which begins at start_of(). All else
/// is float32.
std::vector<float> interpolated(const Drawn& triangle, std::span<const Pixel> pixels, const Coder& coder,
                                Interpolation interpolation);

/// The pixel where `forward` begins: the first row and the first column of the pixels, of which there is one
/// at least.
Pixel start_of(std::span<const Pixel> pixels);

/// The plane s = start + per_x x + per_y y through the corners' values, in double, at pixel `at`'s centre.
struct Plane3 {
    double start = 0, per_x = 0, per_y = 0;
};
Plane3 plane_through(const Drawn& triangle, const std::array<float, 3>& s, Pixel at);

}  // namespace zproof::study::depth
