#include "filters/reference/seen_texture.h"

#include <algorithm>

#include "math/rounding.h"

namespace zproof::oracle::filter_reference {

namespace {

template <class Number>
Homography<Number> homography(const View& view, const TexturedTriangle& triangle) {
    const auto b = barycentric_functionals(view, corners_from_eye<Number>(view, triangle.corners_world));
    const Affine<Number> zero{Number{0}, Number{0}, Number{0}};
    Homography<Number> map{zero, zero, zero};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto t = texel_coordinates<Number>(triangle, i);
        map.u = map.u + t[0] * b[i];
        map.v = map.v + t[1] * b[i];
        map.w = map.w + b[i];
    }
    return map;
}

}  // namespace

const Material& material_of(const Scene& scene, std::uint32_t triangle) {
    const auto after = std::ranges::upper_bound(scene.parts, triangle, {}, &Part::first_triangle);
    return scene.materials[std::size_t(std::prev(after)->material)];
}

bool is_textured(const Scene& scene, const Material& material) {
    return material.base_color.image != Texture::none &&
           std::size_t(material.base_color.uv_set) < scene.vertices.uv.size();
}

TexturedTriangle textured_triangle(const Scene& scene, std::uint32_t triangle) {
    const Texture& texture = material_of(scene, triangle).base_color;
    const glm::uvec3 corners = scene.triangles[triangle];
    const auto& uv = scene.vertices.uv[std::size_t(texture.uv_set)];
    const Image& image = scene.images[std::size_t(texture.image)];
    TexturedTriangle seen{.corners_world = {},
                          .uv = {},
                          .transform = texture.transform,
                          .texture_size = {image.width, image.height}};
    for (int i = 0; i < 3; ++i) {
        seen.corners_world[std::size_t(i)] = scene.vertices.position_world[corners[i]];
        seen.uv[std::size_t(i)] = uv[corners[i]];
    }
    return seen;
}

SeenTexture::SeenTexture(const View& view, const TexturedTriangle& triangle, const FilterPrecision& precision)
    : view_(view),
      triangle_(triangle),
      rounding_(gamma(coordinate_roundings, std::exp2(-precision.arithmetic_bits))),
      displacement_px_(precision.displacement_px),
      step_error_(std::exp2(-precision.step_bits)),
      coordinate_unit_(std::exp2(-precision.coordinate_bits)) {
    const auto exact = homography<Interval>(view, triangle);
    const auto size = homography<Magnitude>(view, triangle);
    u_ = {exact.u, size.u};
    v_ = {exact.v, size.v};
    w_ = {exact.w, size.w};
}

Interval SeenTexture::value(const Functional& f, double x, double y) const {
    return widen(f.exact.at(x, y), rounding_ * f.size.at(x, y).value);
}

TexelInterval SeenTexture::undisplaced(double x, double y) const {
    const Interval w = value(w_, x, y);
    return {value(u_, x, y) / w, value(v_, x, y) / w};
}

/// Quotient rule; the two terms' own sizes bound what rounding costs.
TexelInterval SeenTexture::step(const TexelInterval& place, const Interval& w,
                                Interval Affine<Interval>::*along,
                                Magnitude Affine<Magnitude>::*along_size) const {
    const auto change = [&](const Functional& f) {
        return widen(f.exact.*along, rounding_ * (f.size.*along_size).value);
    };
    const Interval dw = change(w_);
    return {(change(u_) - place.u * dw) / w, (change(v_) - place.v * dw) / w};
}

/// Displaced by at most e in x and y, the place moves by at most e (|d/dx| + |d/dy|), the steps taken over
/// the whole square: mean value theorem.
TexelInterval SeenTexture::at(double x, double y) const {
    const TexelInterval still = undisplaced(x, y);
    if (displacement_px_ == 0) return still;
    const Interval around{-displacement_px_, displacement_px_};
    const Interval over_x = Interval{x} + around, over_y = Interval{y} + around;
    const Interval w = widen(w_.exact.at(over_x, over_y), rounding_ * w_.size.at(x, y).value);
    const TexelInterval anywhere{u_.exact.at(over_x, over_y) / w, v_.exact.at(over_x, over_y) / w};
    const TexelInterval across = step(anywhere, w, &Affine<Interval>::a, &Affine<Magnitude>::a);
    const TexelInterval down = step(anywhere, w, &Affine<Interval>::b, &Affine<Magnitude>::b);
    return {still.u + (across.u + down.u) * around, still.v + (across.v + down.v) * around};
}

/// U / W is monotone along a line on which W keeps its sign: the ends hold the extremes.
TexelInterval SeenTexture::between(const glm::dvec2& from, const glm::dvec2& to) const {
    const TexelInterval first = at(from.x, from.y);
    if (from == to) return first;
    if (!((value(w_, from.x, from.y) * value(w_, to.x, to.y)).low() > 0)) throw UndecidedSign{};
    const TexelInterval last = at(to.x, to.y);
    return {hull(first.u, last.u), hull(first.v, last.v)};
}

Interval SeenTexture::before_horizon(int x, int y) const {
    const Interval w = magnitude(value(w_, x + 0.5, y + 0.5)), half{0.5};
    return w - half * (magnitude(w_.exact.a) + magnitude(w_.exact.b));
}

TexelInterval SeenTexture::wrapped(const TexelInterval& place) const {
    const auto within = [](const Interval& a, double size) {
        const double periods = std::floor(a.low() / size);
        if (std::floor(a.high() / size) != periods) throw UndecidedSign{};
        return a - Interval{periods * size};
    };
    return {within(place.u, triangle_.texture_size.x), within(place.v, triangle_.texture_size.y)};
}

/// From where to where: the aligned pair of pixels, this one and the next, or half a pixel to either side.
PixelFootprint SeenTexture::differences(int x, int y, StepRule rule) const {
    using enum StepRule;
    const bool is_wrapped = rule >= wrapped_quad_differences;
    const double cx = x + 0.5, cy = y + 0.5;
    glm::dvec2 from{(x & ~1) + 0.5, (y & ~1) + 0.5};
    if (rule == forward_differences || rule == wrapped_forward_differences) from = {cx, cy};
    if (rule == centred_differences || rule == wrapped_centred_differences) from = {cx - 0.5, cy - 0.5};
    const auto place = [&](double at_x, double at_y) {
        return is_wrapped ? wrapped(at(at_x, at_y)) : at(at_x, at_y);
    };
    const TexelInterval l = place(from.x, cy), r = place(from.x + 1, cy), t = place(cx, from.y),
                        b = place(cx, from.y + 1);
    return {at(cx, cy), {r.u - l.u, r.v - l.v}, {b.u - t.u, b.v - t.v}};
}

PixelFootprint SeenTexture::footprint(int x, int y, StepRule rule) const {
    const double cx = x + 0.5, cy = y + 0.5;
    PixelFootprint f{at(cx, cy), {}, {}};
    if (rule != StepRule::analytic) {
        f = differences(x, y, rule);
    } else {
        const Interval around{-displacement_px_, displacement_px_};
        const Interval w = hull(value(w_, cx, cy), w_.exact.at(Interval{cx} + around, Interval{cy} + around));
        f.per_x = step(f.centre, w, &Affine<Interval>::a, &Affine<Magnitude>::a);
        f.per_y = step(f.centre, w, &Affine<Interval>::b, &Affine<Magnitude>::b);
    }
    double longest = 0;
    for (const Interval* a : {&f.per_x.u, &f.per_x.v, &f.per_y.u, &f.per_y.v})
        longest = std::max(longest, magnitude(*a).high());
    for (Interval* a : {&f.per_x.u, &f.per_x.v, &f.per_y.u, &f.per_y.v})
        *a = widen(*a, step_error_ * longest + coordinate_unit_ * magnitude(*a).high());
    return f;
}

}  // namespace zproof::oracle::filter_reference
