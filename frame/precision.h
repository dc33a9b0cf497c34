/// What a renderer promises about its arithmetic. The judge knows a renderer by this alone (docs/bounds.md).
#pragma once

#include <variant>

namespace zproof {

enum class Arithmetic {
    float32,  ///< IEEE binary32, round to nearest
    float64,  ///< IEEE binary64, round to nearest
};

/// What corners are relative to when they meet the first matrix.
enum class Origin {
    world,  ///< the world's origin
    eye,    ///< the eye is subtracted first, rounded once
};

/// How a vertex reaches its place on the sub-pixel grid.
enum class Snap {
    nearest,   ///< moves by at most half a grid step in x and in y
    truncate,  ///< moves by less than a whole step
    none,      ///< stays where the transform puts it
};

/// How it is decided on which side of an edge a pixel's centre lies.
enum class EdgeFunctions {
    exact,        ///< without error, as integers of the grid are
    from_corner,  ///< (p - p0) x (p1 - p0) in window coordinates, rounded
    homogeneous,  ///< (p0 x p1) . (x, y, 1) of corners before the divide, rounded (Olano and Greer 1997)
    window_coefficients,  ///< a x + b y + c with coefficients of window coordinates, rounded
};

/// How the third of a point's barycentric weights is made, where edge functions are rounded.
enum class ThirdWeight {
    edge_function,  ///< as the other two are
    remainder,      ///< 1 minus the other two
};

/// What clipping in float32 leaves of a triangle that reaches beyond the image.
enum class Clipping {
    guard_band,   ///< only what the near plane or +-32768 px cut gets new corners
    view_volume,  ///< every side of the image, near and far make new corners
};

/// What the depth buffer holds, and so what decides which of two triangles is in front.
enum class DepthBuffer {
    camera_depth,  ///< 1/depth (perspective) or depth (parallel) as float, turned into depth without loss
    reversed_z,    ///< z in [0, 1] with 1 at near
    standard_z,    ///< z in [0, 1] with 0 at near: its error in depth grows as depth^2 / near
};

/// How z is stored.
enum class DepthFormat { float32, float64, unorm16, unorm24, unorm32 };

/// How z becomes a step of a unorm format.
enum class DepthRounding {
    either,    ///< one of the two steps beside it (OpenGL 4.6, 2.3.5)
    nearest,   ///< the nearest step
    truncate,  ///< the step below
};

/// What near and far become by the projection matrix, before the viewport maps z to [0, 1].
enum class ClipRange { zero_to_one, minus_one_to_one };

/// The far plane that the projection matrix of reversed_z and standard_z holds.
enum class MatrixFar {
    infinite,  ///< z is near / depth, or 1 minus that; far cuts by other means
    finite,    ///< z ends at the view's far plane
};

/// How depth is interpolated.
enum class DepthInterpolation {
    barycentrics,  ///< weighted mean of the snapped corners: never beyond their depths
    plane,         ///< plane equation in float32 through the corners, snapped or not: may leave their range
};

/// Which depth the frame shows.
enum class ShownDepth {
    buffer,   ///< the depth buffer's
    varying,  ///< camera depth, interpolated in float32 beside the depth buffer
};

/// A z-buffer rasterizer: matrices, division by w, viewport, snap, edge functions, and an interpolated depth.
struct RasterPrecision {
    Arithmetic transform = Arithmetic::float32;  ///< of matrices, division and viewport
    Origin origin = Origin::world;               ///< what the matrices are applied to
    int matrices = 1;                            ///< applied one after the other, 1 to 3
    int subpixel_bits = 8;                       ///< grid step is 2^-subpixel_bits px
    Snap snap = Snap::nearest;                   ///< onto that grid
    EdgeFunctions edge_functions = EdgeFunctions::exact;
    Arithmetic edge_arithmetic = Arithmetic::float32;       ///< of edge functions that are rounded
    ThirdWeight third_weight = ThirdWeight::edge_function;  ///< of edge functions that are rounded
    double barycentric_tolerance = 0;                       ///< a point counts as inside down to minus this
    double least_area_px2 = 0;                              ///< triangles below it need not be drawn
    double area_epsilon_px2 = 0;  ///< is added to the area that barycentrics are divided by
    bool watertight = true;       ///< do triangles that share an edge move it alike, and leave no gap?
    bool nothing_behind_the_eye = false;  ///< is nothing drawn at a negative depth, whatever near says?
    Clipping clipping = Clipping::guard_band;
    DepthBuffer depth_buffer = DepthBuffer::camera_depth;
    DepthFormat depth_format = DepthFormat::float32;       ///< of reversed_z and standard_z
    DepthRounding depth_rounding = DepthRounding::either;  ///< of its unorm formats
    ClipRange clip_range = ClipRange::zero_to_one;         ///< of reversed_z and standard_z
    MatrixFar matrix_far = MatrixFar::infinite;  ///< the same; parallel projections have a finite one
    DepthInterpolation depth_interpolation = DepthInterpolation::barycentrics;
    Arithmetic interpolation = Arithmetic::float32;  ///< of barycentrics' weighted mean
    Arithmetic linearization = Arithmetic::float64;  ///< from z back to camera depth
    int depth_roundings = 2;                         ///< float32 roundings from interpolant to reported depth
    ShownDepth shown_depth = ShownDepth::buffer;
    double depth_step = 0;  ///< reported depths are its whole multiples, the nearest; 0: any; scene units

    bool operator==(const RasterPrecision&) const = default;
};

/// How a ray caster tests one triangle.
enum class RayTest {
    pluecker,          ///< signs of Pluecker products, robust down to -2 u (Embree's robust mode)
    moeller_trumbore,  ///< barycentrics by Cramer's rule (Moeller and Trumbore 1997): each triangle by itself
    woop,              ///< corners sheared into ray space (Woop, Benthin and Wald 2013)
};

/// Where the hit's depth comes from.
enum class HitPoint {
    distance,      ///< the distance along the ray
    barycentrics,  ///< a point rebuilt from the triangle's corners, then transformed
};

/// A ray caster: one ray per pixel centre against the world-space triangle. Origins, directions and vertices
/// are rounded to this arithmetic.
struct RayPrecision {
    Arithmetic arithmetic = Arithmetic::float32;
    RayTest test = RayTest::pluecker;
    bool watertight = true;            ///< no gap between triangles that share an edge
    double aim_offset_px = 0;          ///< rays may pass this far beside the pixel's centre, in x and in y
    int direction_roundings = 1;       ///< of each coordinate of a direction
    double barycentric_tolerance = 0;  ///< a point counts as inside down to minus this
    double least_determinant = 0;      ///< triangles with a smaller |normal . direction| need not be hit
    HitPoint hit_point = HitPoint::distance;
    double world_absolute = 0;  ///< a further error of corners in each axis, scene units
    double depth_of_range = 0;  ///< a further error of depth, as a share of far - near; needs a finite far
    int depth_roundings = 1;    ///< float32 roundings from the hit to the reported depth
    double depth_step = 0;      ///< reported depths are its whole multiples, the nearest; 0: any; scene units

    bool operator==(const RayPrecision&) const = default;
};

/// A ray caster in float64: it meets a triangle's plane, whose unit normal and offset were computed once, and
/// then asks whether the point lies inside, in the two axes that are farthest from the normal. Corners are
/// rounded once when the eye is subtracted.
struct PlaneRayPrecision {
    double aim_offset_px = 0;  ///< rays may pass this far beside the pixel's centre, in x and in y
    double least_corner_sine =
        0x1p-26;  ///< triangles with a smaller sine at their second corner are not drawn
    double least_grazing_sine = 1e-10;  ///< a ray does not meet a plane at a smaller sine
    double depth_relative = 0x1p-24;    ///< error of the reported depth beside that of the hit itself
    double depth_of_range = 0;          ///< parallel: a further one, as a share of far - near
    double clip_relative = 0;           ///< error of near and far, as a share of themselves
    double clip_of_reach = 0;           ///< parallel: a further one, as a share of the coordinates' size
    double depth_step = 0;  ///< reported depths are its whole multiples, the nearest; 0: any; scene units

    bool operator==(const PlaneRayPrecision&) const = default;
};

/// A renderer of whose arithmetic nothing is known but how far it errs.
struct BoundedPrecision {
    double eps_px = 0;          ///< triangles may be displaced this far, in x and in y
    double depth_relative = 0;  ///< error of a depth, as a share of itself
    double depth_absolute = 0;  ///< a further one, scene units
    double depth_of_range = 0;  ///< a further one, as a share of far - near; needs a finite far
    bool watertight = true;     ///< do triangles that share an edge move it alike, and leave no gap?
    double depth_step = 0;      ///< reported depths are its whole multiples, the nearest; 0: any; scene units

    bool operator==(const BoundedPrecision&) const = default;
};

/// The projections that a renderer has at all.
struct Projections {
    bool perspective = true, orthographic = true, oblique = true;

    bool operator==(const Projections&) const = default;
};

using Precision = std::variant<RasterPrecision, RayPrecision, PlaneRayPrecision, BoundedPrecision>;

}  // namespace zproof
