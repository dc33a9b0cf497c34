/// The truth about a filtered texture: its mean over each pixel, in screen space, perspective included, by
/// clipping convex pieces (docs/area-integral.md).
///
/// What is averaged is the visible surfaces' albedo, base_color_factor times texture, in linear light;
/// background is black, alpha and vertex colours are ignored. Nothing here knows a texture filter.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "frame/plane.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// What is averaged, and with which weight over the pixel.
enum class Reconstruction {
    nearest,   ///< GT-N: piecewise constant texels, the pixel's square
    bilinear,  ///< GT-B: texels interpolated bilinearly, the pixel's square
    gaussian,  ///< GT-G: bilinear; exp(-2 r^2) - exp(-2) for r < 1 px round the pixel's centre, normalized
    gaussian_of_nearest,  ///< GT-GN: piecewise constant texels under the weight of GT-G
    mitchell,  ///< GT-M: bilinear; the cubics of Mitchell and Netravali in x and in y, up to 2 px; signed
    blackman_harris,  ///< GT-BH: bilinear; the Blackman-Harris window in x and in y, up to 1.5 px
};

struct NamedReconstruction {
    std::string_view letters;  ///< GT-N is "N"
    Reconstruction reconstruction;
};
inline constexpr std::array reconstructions{
    NamedReconstruction{"N", Reconstruction::nearest},
    NamedReconstruction{"B", Reconstruction::bilinear},
    NamedReconstruction{"G", Reconstruction::gaussian},
    NamedReconstruction{"GN", Reconstruction::gaussian_of_nearest},
    NamedReconstruction{"M", Reconstruction::mitchell},
    NamedReconstruction{"BH", Reconstruction::blackman_harris},
};

/// "N" to "BH".
std::string letters_of(Reconstruction reconstruction);
std::optional<Reconstruction> reconstruction_of(std::string_view letters);

/// Are texels squares of one colour?
constexpr bool is_of_nearest(Reconstruction reconstruction) {
    return reconstruction == Reconstruction::nearest || reconstruction == Reconstruction::gaussian_of_nearest;
}

/// What a square round the pixel's centre sees: the least that holds all that is weighed.
enum class TruthKind : std::uint8_t {
    background,  ///< no surface
    interior,    ///< one continuous surface of one material, all over it
    silhouette,  ///< surfaces with a gap, a step in depth or a change of material, cut exactly
    sampled,     ///< too many texels or pieces: an estimate from samples
};

struct AreaTruth {
    Plane<glm::dvec3> mean;  ///< linear RGB; outside 0 to 1 where a signed weight makes it so
    Plane<TruthKind> kind;   ///< one continuous surface: see `interior`
    /// Half the 95 % confidence interval of the worst channel of an estimate, else the integral's bound.
    Plane<double> half_width;
};

/// The truth at every pixel of the view, on the threads of the surrounding tbb::task_arena; the same bits for
/// any number of them. Throws OracleError where Embree is needed and refuses the scene.
AreaTruth area_truth(const Scene& scene, const View& view, Reconstruction reconstruction);

/// What every pixel sees within 2 px of its centre in x and in y, which is all that any reconstruction
/// weighs: the same for each of them, and never `sampled`. Where too many triangles lie there, it is a
/// silhouette.
Plane<TruthKind> surfaces_around(const Scene& scene, const View& view);

/// The truth from samples alone, at every pixel: a check of the exact integral that shares no clipping with
/// it.
AreaTruth sampled_area_truth(const Scene& scene, const View& view, Reconstruction reconstruction);

/// May a difference between two filters' errors be claimed? Only if the truth is known to a fifth of it.
constexpr bool is_resolved(double difference, double half_width) {
    return half_width <= (difference < 0 ? -difference : difference) / 5;
}

}  // namespace zproof::oracle
