/// A triangle as the image sees it: half-planes, inverse depth and texture coordinates, all affine in the
/// raster position or quotients of such. Derived here from the camera's facts and the baked scene alone.
///
/// The view ray through raster (x, y) is d(x, y) from the eye (perspective), or d from o(x, y)
/// (parallel); camera depth advances by 1 along d. Where b solves [v0 v1 v2] b = d, the triangle is met iff
/// all b >= 0, and b0 + b1 + b2 = 1 / depth (Olano and Greer 1997).
#pragma once

#include <array>
#include <optional>

#include "math/affine.h"
#include "math/rational.h"
#include "math/sign.h"
#include "math/vector3.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle::area {

/// Affine functionals of the raster position: the components of a vector that depends on it.
template <class Number>
struct AffineVector {
    Vector3<Number> per_x, per_y, at_origin;

    Affine<Number> along(const Vector3<Number>& n) const {
        return {dot(per_x, n), dot(per_y, n), dot(at_origin, n)};
    }
};

template <class Number>
struct RasterRays {
    Projection projection;
    Vector3<Number> eye;
    AffineVector<Number> window;  ///< u right + v up
    Vector3<Number> axis;         ///< what all view rays have in common: a step of depth 1

    explicit RasterRays(const View& view) : projection(view.camera.projection) {
        const Camera& c = view.camera;
        const auto right = exactly<Number>(c.right), up = exactly<Number>(c.up),
                   back = exactly<Number>(c.back);
        const Number left(c.window.left), top(c.window.top);
        eye = exactly<Number>(glm::dvec3(c.eye_world));
        window = {((Number(c.window.right) - left) / Number(view.width)) * right,
                  ((Number(c.window.bottom) - top) / Number(view.height)) * up, left * right + top * up};
        axis = Number(c.shear.x) * right + Number(c.shear.y) * up - back;
    }
};

template <class Number>
struct SeenTriangle {
    std::array<Affine<Number>, 3> edge;  ///< the b's: >= 0 inside; edge i is opposite corner i
    Affine<Number> inverse_depth;        ///< greater is nearer: 1 / depth, or -depth for parallel projections
    Homography<Number> texels;           ///< the texture's texels; w = 1 / depth, or 1
};

template <class Number>
using Triple = std::array<Vector3<Number>, 3>;

namespace detail {

template <class Number>
SeenTriangle<Number> seen_in_perspective(const RasterRays<Number>& rays, const Triple<Number>& v,
                                         const Number& volume) {
    const AffineVector<Number> d{rays.window.per_x, rays.window.per_y, rays.window.at_origin + rays.axis};
    const Number scale = Number(1) / volume;
    SeenTriangle<Number> seen;
    for (std::size_t i = 0; i < 3; ++i) seen.edge[i] = scale * d.along(cross(v[(i + 1) % 3], v[(i + 2) % 3]));
    seen.inverse_depth = scale * d.along(cross(v[1] - v[0], v[2] - v[0]));
    seen.texels.w = seen.inverse_depth;
    return seen;
}

/// With e the origin of the view ray, b_i = ((v_j - e) x (v_k - e)) . d / (n . d), and
/// depth = n . (v0 - e) / (n . d).
template <class Number>
SeenTriangle<Number> seen_in_parallel(const RasterRays<Number>& rays, const Triple<Number>& v,
                                      const Number& facing) {
    const Number scale = Number(1) / facing;
    const auto normal = cross(v[1] - v[0], v[2] - v[0]);
    SeenTriangle<Number> seen;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &p = v[(i + 1) % 3], &q = v[(i + 2) % 3];
        seen.edge[i] = scale * (Affine<Number>{0, 0, dot(cross(p, q), rays.axis)} -
                                rays.window.along(cross(q - p, rays.axis)));
    }
    seen.inverse_depth = scale * (rays.window.along(normal) - Affine<Number>{0, 0, dot(normal, v[0])});
    seen.texels.w = {0, 0, 1};
    return seen;
}

}  // namespace detail

/// Texel coordinates at the corners.
template <class Number>
using CornerTexels = std::array<std::array<Number, 2>, 3>;

/// The triangle as seen; nothing where it is seen exactly edge-on, since it covers no area then.
template <class Number>
std::optional<SeenTriangle<Number>> seen(const RasterRays<Number>& rays, const Triple<Number>& p_world,
                                         const CornerTexels<Number>& texel) {
    const Triple<Number> v{p_world[0] - rays.eye, p_world[1] - rays.eye, p_world[2] - rays.eye};
    const auto normal = cross(v[1] - v[0], v[2] - v[0]);
    const bool perspective = rays.projection == Projection::perspective;
    const Number volume = dot(normal, perspective ? v[0] : rays.axis);
    if (is_certainly_zero(volume)) return std::nullopt;
    auto result = perspective ? detail::seen_in_perspective(rays, v, volume)
                              : detail::seen_in_parallel(rays, v, volume);
    const auto interpolated = [&](std::size_t axis) {
        const auto rise = [&](std::size_t i) { return texel[i][axis] - texel[0][axis]; };
        return texel[0][axis] * result.texels.w + rise(1) * result.edge[1] + rise(2) * result.edge[2];
    };
    result.texels.u = interpolated(0);
    result.texels.v = interpolated(1);
    return result;
}

/// The functional of the offset from a raster position.
template <class Number>
Affine<Number> from(const Affine<Number>& f, const Number& x, const Number& y) {
    return {f.a, f.b, f.at(x, y)};
}

template <class Number>
SeenTriangle<Number> from(const SeenTriangle<Number>& t, const Number& x, const Number& y) {
    return {{from(t.edge[0], x, y), from(t.edge[1], x, y), from(t.edge[2], x, y)},
            from(t.inverse_depth, x, y),
            {from(t.texels.u, x, y), from(t.texels.v, x, y), from(t.texels.w, x, y)}};
}

}  // namespace zproof::oracle::area
