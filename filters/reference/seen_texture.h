/// The filter reference's own way from a pixel to a place on a texture: derived from the scene's floats and
/// the camera's facts in intervals, for perspective and parallel projections. Nothing is shared with the
/// rasterizer.
///
/// Texel coordinates are sum b_i t_i / sum b_i, with b_i the homogeneous barycentrics.
#pragma once

#include <array>

#include "filters/conformance/filter_precision.h"
#include "filters/reference/barycentrics.h"
#include "math/affine.h"
#include "math/interval_functions.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle::filter_reference {

/// Roundings from the scene to a functional, a place or a step: docs/filter-conformance.md, "Coordinates",
/// counts them.
inline constexpr int coordinate_roundings = 54;

/// Texels of level 0; texel i covers [i, i + 1).
struct TexelInterval {
    Interval u, v;
};

/// What the pixel's centre sees and the change per pixel of raster x and y.
struct PixelFootprint {
    TexelInterval centre, per_x, per_y;
};

/// Where the cone about the pixel's ray meets the surface (Akenine-Moller et al. 2021, with their erratum).
struct ConeFootprint {
    Interval width;               ///< w sqrt(t_a / p_a) / |n . d|, texels: its log2 is the LOD
    TexelInterval along, across;  ///< semi-axes of the ellipse, along the ray's projection and across it
};

/// A triangle and its texture, as the scene has them.
struct TexturedTriangle {
    std::array<glm::vec3, 3> corners_world;
    std::array<glm::vec2, 3> uv;
    UvTransform transform;
    glm::ivec2 texture_size;
};

/// Texel coordinates of a corner: size (translation + linear uv).
template <class Number>
std::array<Number, 2> texel_coordinates(const TexturedTriangle& triangle, std::size_t corner) {
    const glm::dvec2 uv{triangle.uv[corner]};
    std::array<Number, 2> t;
    for (int axis = 0; axis < 2; ++axis)
        t[std::size_t(axis)] =
            Number(triangle.texture_size[axis]) * (Number(triangle.transform.translation[axis]) +
                                                   Number(triangle.transform.linear[0][axis]) * Number(uv.x) +
                                                   Number(triangle.transform.linear[1][axis]) * Number(uv.y));
    return t;
}

/// The material of a triangle, and the triangle with its texture; the material must have one.
const Material& material_of(const Scene& scene, std::uint32_t triangle);
TexturedTriangle textured_triangle(const Scene& scene, std::uint32_t triangle);
/// Does the material have a texture, and do the scene's vertices have coordinates for it?
bool is_textured(const Scene& scene, const Material& material);

class SeenTexture {
  public:
    SeenTexture(const View& view, const TexturedTriangle& triangle, const FilterPrecision& precision);

    /// Throws UndecidedSign where the plane's horizon comes too close to tell.
    TexelInterval at(double x_raster, double y_raster) const;
    /// All that is seen from one place of the raster to another. Throws UndecidedSign where the plane's
    /// horizon may lie between them.
    TexelInterval between(const glm::dvec2& from_raster, const glm::dvec2& to_raster) const;
    PixelFootprint footprint(int x, int y, StepRule rule) const;
    /// Throws UndecidedSign where the ray may run along the plane.
    ConeFootprint cone(int x, int y) const;
    /// How far 1 / depth at the pixel's centre exceeds its fall to the farthest corner, in units of its own:
    /// positive where the whole pixel lies before the plane's horizon.
    Interval before_horizon(int x, int y) const;

  private:
    /// A functional's three terms, with what arithmetic may cost them.
    struct Functional {
        Affine<Interval> exact;
        Affine<Magnitude> size;
    };
    Interval value(const Functional& f, double x, double y) const;
    /// Change of the place per pixel in x or in y, where the place and W are known.
    TexelInterval step(const TexelInterval& place, const Interval& w, Interval Affine<Interval>::*along,
                       Magnitude Affine<Magnitude>::*along_size) const;
    /// Throws UndecidedSign where a place may lie on either side of a seam.
    TexelInterval wrapped(const TexelInterval& place) const;
    PixelFootprint differences(int x, int y, StepRule rule) const;
    TexelInterval undisplaced(double x, double y) const;

    const View& view_;  ///< must outlive this
    TexturedTriangle triangle_;
    Functional u_, v_, w_;
    double rounding_;  ///< relative to the terms' size
    double displacement_px_;
    double step_error_;  ///< in lengths of the steps' longest coordinate
    double coordinate_unit_;
};

}  // namespace zproof::oracle::filter_reference
