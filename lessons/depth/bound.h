/// How far a stored depth may be off, and how close two layers may come before their order is not certain:
/// derived from the roundings of lessons/depth/interpolation.h, term by term, in docs/depth.md. Nothing
/// fitted.
#pragma once

#include "lessons/depth/interpolation.h"

namespace zproof::study::depth {

/// A pixel where a depth is worked out.
struct DepthSample {
    double depth = 1;                  ///< exact, at the pixel
    double nearest = 1, farthest = 1;  ///< of the triangle's corners
    double weight_error = 0;           ///< of a barycentric beside its rounding to float32 (weight_error_of)
    // Facts for `forward`: additions across and down, their steps, and the largest |s| that is met on the
    // way.
    int across = 0, down = 0;
    double per_x = 0, per_y = 0, largest = 0;
};

/// What double precision does to a barycentric: corners are moved by at most 2^-48 of `reach_px`, the largest
/// coordinate that enters them, and a weight is a quotient of two areas.
double weight_error_of(const Drawn& triangle, double reach_px);

/// Bounds of the difference between the computed s and the ideal one, before it is stored.
struct ErrorOfS {
    double common = 0;      ///< by rounding the coding's constants: the same at every pixel, upsets no order
    double own = 0;         ///< by every other rounding but the last
    double last = 0;        ///< by the last rounding to float32
    double systematic = 0;  ///< by interpolating what is not affine in the image
};
ErrorOfS error_of_s(const Coder& coder, Interpolation interpolation, const DepthSample& place);

/// The largest |depth_of(stored) - depth| that the arithmetic may leave, scene units; +inf where even s = 0
/// or s = 1 cannot be told.
double depth_bound(const Coder& coder, Interpolation interpolation, const DepthSample& place);

/// The least distance behind (in front of) a layer at this depth from which on another one is ordered right
/// for certain, both seen through the same pixel and drawn alike: corners within depth / spread and depth *
/// spread. +inf where that reaches beyond far (before near). Only for what is_right_for() holds.
double smallest_gap_behind(const Coder& coder, Interpolation interpolation, double depth, double spread = 1);
double smallest_gap_before(const Coder& coder, Interpolation interpolation, double depth, double spread = 1);

/// The smallest gap that is ordered right everywhere between the planes: the largest smallest_gap_before() at
/// 257 depths from near to far, spaced by equal ratios; f - n where no gap at all is.
double worst_gap(const Format& format, const Planes& planes);

}  // namespace zproof::study::depth
