// The cone about a pixel's ray from the scene's floats and the camera's facts: SeenTexture::cone().
//
// With corners v_i, N = (v1 - v0) x (v2 - v0) and the view ray d from the eye: the distance is |d| (N . v0) /
// (N . d), the cosine |N . d| / (|N| |d|), and twice the triangle's area |N|.
#include "filters/reference/seen_texture.h"

namespace zproof::oracle::filter_reference {

namespace {

using IntervalVector = Vector3<Interval>;

Interval norm(const IntervalVector& a) { return square_root(square(a.x) + square(a.y) + square(a.z)); }

IntervalVector divided(const IntervalVector& a, const Interval& by) { return {a.x / by, a.y / by, a.z / by}; }

double largest(const Interval& a) { return magnitude(a).high(); }

/// Vector arithmetic that charges an implementation's rounding, relative to the terms' size.
struct Charged {
    double rounding;

    Interval difference(const Interval& a, const Interval& b) const {
        return widen(a - b, rounding * (largest(a) + largest(b)));
    }
    IntervalVector difference(const IntervalVector& a, const IntervalVector& b) const {
        return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
    }
    Interval dot(const IntervalVector& a, const IntervalVector& b) const {
        const double size =
            largest(a.x) * largest(b.x) + largest(a.y) * largest(b.y) + largest(a.z) * largest(b.z);
        return widen(zproof::dot(a, b), rounding * size);
    }
    Interval determinant(const Interval& a, const Interval& b, const Interval& c, const Interval& d) const {
        return difference(a * d, b * c);
    }
    IntervalVector cross(const IntervalVector& a, const IntervalVector& b) const {
        return {determinant(a.y, a.z, b.y, b.z), determinant(a.z, a.x, b.z, b.x),
                determinant(a.x, a.y, b.x, b.y)};
    }
};

/// The view ray through any place of the box, a step of depth 1.
IntervalVector ray_through(const View& view, const Interval& x, const Interval& y, double rounding) {
    const Camera& camera = view.camera;
    const auto window = detail::on_window<Interval>(view);
    const bool is_perspective = camera.projection == Projection::perspective;
    const IntervalVector ray = is_perspective
                                   ? x * window.x + y * window.y + window.c - exactly<Interval>(camera.back)
                                   : detail::sheared_axis<Interval>(camera);
    const double error = rounding * norm(ray).high();
    return {widen(ray.x, error), widen(ray.y, error), widen(ray.z, error)};
}

/// The radius of the cone at distance 1 in perspective: tan(alpha / 2) = p / (1 + sqrt(1 + p^2)) with
/// tan(alpha) = p, a pixel's height at depth 1. Half a pixel's height of a parallel projection.
Interval radius_of(const View& view) {
    const Camera& camera = view.camera;
    const Interval one{1},
        p = (Interval{camera.window.top} - Interval{camera.window.bottom}) / Interval{double(view.height)};
    return camera.projection == Projection::perspective ? p / (one + square_root(one + square(p)))
                                                        : Interval{0.5} * p;
}

/// A unit vector; anything where the vector may be 0.
IntervalVector direction_of(const IntervalVector& a) {
    const Interval length_of = norm(a), any{-1, 1};
    if (!(length_of.low() > 0)) return {any, any, any};
    return {clamped(a.x / length_of, -1, 1), clamped(a.y / length_of, -1, 1),
            clamped(a.z / length_of, -1, 1)};
}

}  // namespace

ConeFootprint SeenTexture::cone(int x, int y) const {
    const Charged charged{rounding_};
    const Interval around{-displacement_px_, displacement_px_};
    const auto corners = corners_from_eye<Interval>(view_, triangle_.corners_world);
    const IntervalVector ab = charged.difference(corners[1], corners[0]),
                         ac = charged.difference(corners[2], corners[0]), area = charged.cross(ab, ac);
    const IntervalVector ray =
        ray_through(view_, Interval{x + 0.5} + around, Interval{y + 0.5} + around, rounding_);
    const Interval twice_the_area = norm(area), step = norm(ray), towards = charged.dot(area, ray);
    if (!(magnitude(towards).low() > 0 && twice_the_area.low() > 0)) throw UndecidedSign{};
    const Interval cosine = magnitude(towards) / (twice_the_area * step);
    const Interval distance = magnitude(charged.dot(area, corners[0])) / magnitude(towards) * step;
    const Interval radius =
        view_.camera.projection == Projection::perspective ? radius_of(view_) * distance : radius_of(view_);

    const auto texel = [&](std::size_t corner, std::size_t axis) {
        return charged.difference(texel_coordinates<Interval>(triangle_, corner)[axis],
                                  texel_coordinates<Interval>(triangle_, 0)[axis]);
    };
    const TexelInterval to_b{texel(1, 0), texel(1, 1)}, to_c{texel(2, 0), texel(2, 1)};
    const Interval twice_the_texels = magnitude(charged.determinant(to_b.u, to_b.v, to_c.u, to_c.v));

    const IntervalVector normal = divided(area, twice_the_area), unit_ray = divided(ray, step);
    const Interval turned = towards / (twice_the_area * step);
    const IntervalVector along = direction_of(charged.difference(unit_ray, turned * normal)),
                         across = charged.cross(normal, along);
    const IntervalVector share_of_b = divided(charged.cross(ac, normal), twice_the_area),
                         share_of_c = divided(charged.cross(normal, ab), twice_the_area);
    const auto on_texture = [&](const IntervalVector& in_plane, const Interval& length_of) {
        const Interval b = charged.dot(share_of_b, in_plane), c = charged.dot(share_of_c, in_plane);
        return TexelInterval{length_of * (b * to_b.u + c * to_c.u), length_of * (b * to_b.v + c * to_c.v)};
    };
    ConeFootprint found{Interval{2} * radius * square_root(twice_the_texels / twice_the_area) / cosine,
                        on_texture(along, radius / cosine), on_texture(across, radius)};
    double longest = 0;
    for (const Interval* a : {&found.along.u, &found.along.v, &found.across.u, &found.across.v})
        longest = std::max(longest, largest(*a));
    for (Interval* a : {&found.along.u, &found.along.v, &found.across.u, &found.across.v})
        *a = widen(*a, (step_error_ + rounding_) * longest);
    found.width = widen(found.width, (step_error_ + rounding_) * largest(found.width));
    return found;
}

}  // namespace zproof::oracle::filter_reference
