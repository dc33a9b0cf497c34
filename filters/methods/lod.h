/// LOD rules: how large a footprint is, as a level of detail. LOD 0 is one texel of level 0 per pixel; each
/// level more halves the texels. A footprint of no size has LOD -infinity.
///
/// s1 >= s2 are the singular values of the Jacobian J = [per_x per_y] (texture/footprint.h).
#pragma once

#include "texture/method.h"

namespace zproof::texture {

using LodRule = double (*)(const Footprint&);

/// log2 max(|per_x|, |per_y|). OpenGL 4.6 core, 8.14.1, with equality; Vulkan and Direct3D, isotropic.
double lod_gl_maximum(const Footprint& footprint);

/// log2 s1. Direct3D 11.3 functional specification, 7.18.11: the axes made orthogonal first.
double lod_ellipse_major(const Footprint& footprint);

/// log2 sqrt((|per_x|^2 + |per_y|^2) / 2) = log2 sqrt((s1^2 + s2^2) / 2).
double lod_root_mean_square(const Footprint& footprint);

/// log2 sqrt(|det J|) = log2 sqrt(s1 s2): the side of the square of the footprint's area.
double lod_area(const Footprint& footprint);

/// log2 of the largest absolute entry of J: the Chebyshev length of the longer step.
double lod_chebyshev(const Footprint& footprint);

/// One more than Chebyshev: pbrt takes twice the largest entry (pbrt-v4, MIPMap::Filter).
double lod_pbrt(const Footprint& footprint);

/// log2(w sqrt(t_a / p_a) / |n . d|): Akenine-Moller et al. 2021. The cone is w wide where it meets the
/// surface, t_a / p_a are the texels on a unit of the surface's area, |n . d| is the cone's cosine. The
/// ellipse's axes span (t_a / p_a) (w / 2)^2 / |n . d|. -infinity of a footprint without a cone.
double lod_ray_cone(const Footprint& footprint);

/// The user's bias is added first, then the user's clamp, then that of the chain: a value within [0, levels -
/// 1]. What is no number (a footprint that is not finite) is the last level.
double lod_in_chain(double lod, const FilterOptions& options, std::size_t levels);

/// The level of an LOD within the chain when one level is read: ceil(lod + 1/2) - 1, so that a tie goes to
/// the finer level (OpenGL 4.6 core, 8.14.3; Vulkan prefers the same).
int nearest_level(double lod_in_chain);

}  // namespace zproof::texture
