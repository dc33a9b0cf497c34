#include "tests/precision/emulated_vertices.h"

#include <cmath>

namespace zproof {

namespace {

bool is_perspective(const Camera& c) { return c.projection == Projection::perspective; }

/// From camera space, with z = -depth, to x, y, w; z is left out.
std::array<glm::dvec4, 5> projection_rows(const Camera& c, const RasterPrecision& precision) {
    // of a homogeneous rasterizer the window stays in the units of the image plane
    const bool is_homogeneous = precision.edge_functions == EdgeFunctions::homogeneous;
    const Window w = is_homogeneous ? Window{} : c.window;
    const double of_x = 2 / (w.right - w.left), of_y = 2 / (w.top - w.bottom);
    const double middle_x = (w.right + w.left) / 2, middle_y = (w.top + w.bottom) / 2;
    if (is_perspective(c))
        return {glm::dvec4{of_x, 0, of_x * middle_x, 0},
                {0, of_y, of_y * middle_y, 0},
                {},
                {0, 0, -1, 0},
                {0, 0, -1, 0}};
    return {glm::dvec4{of_x, 0, of_x * c.shear.x, -of_x * middle_x},
            {0, of_y, of_y * c.shear.y, -of_y * middle_y},
            {},
            {0, 0, 0, 1},
            {0, 0, -1, 0}};
}

glm::dvec4 row_of_z(const Camera& c, const RasterPrecision& precision) {
    const EmulatedDepthCode code = depth_code(c, precision);
    const bool is_wide = precision.clip_range == ClipRange::minus_one_to_one;
    const double offset = is_wide ? 2 * code.offset - 1 : code.offset,
                 slope = is_wide ? 2 * code.slope : code.slope;
    // z / w is to be offset + slope / w; parallel: offset + slope depth
    return is_perspective(c) ? glm::dvec4{0, 0, -offset, slope} : glm::dvec4{0, 0, -slope, offset};
}

glm::dmat4 moved_by(const glm::dvec3& by) {  // rows are columns here, as in all of this file
    return {glm::dvec4{1, 0, 0, by.x}, {0, 1, 0, by.y}, {0, 0, 1, by.z}, {0, 0, 0, 1}};
}

glm::dmat4 turned(const Camera& c) {
    return {glm::dvec4{c.right, 0}, glm::dvec4{c.up, 0}, glm::dvec4{c.back, 0}, {0, 0, 0, 1}};
}

glm::dvec4 times(const glm::dvec4& row, const glm::dmat4& rows) {
    return row.x * rows[0] + row.y * rows[1] + row.z * rows[2] + row.w * rows[3];
}

template <class T>
T product(const glm::dvec4& row, const glm::vec<4, T>& p) {
    return ((T(row.x) * p.x + T(row.y) * p.y) + T(row.z) * p.z) + T(row.w) * p.w;
}

/// Keeps the side where distance(corner) >= 0, computed in T.
template <class T, class Distance>
EmulatedPolygon clipped(const EmulatedPolygon& polygon, const Distance& distance) {
    EmulatedPolygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const EmulatedCorner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const T at_p = distance(p), at_q = distance(q);
        if (at_p >= 0) kept.push_back(p);
        if ((at_p >= 0) == (at_q >= 0)) continue;
        const bool leaves = at_p >= 0;
        const EmulatedCorner &in = leaves ? p : q, &out = leaves ? q : p;
        const T of_in = leaves ? at_p : at_q, of_out = leaves ? at_q : at_p;
        const T t = of_out / (of_out - of_in);
        const auto between = [&](double a, double b) { return double(T(a) + t * (T(b) - T(a))); };
        kept.push_back({between(out.x, in.x), between(out.y, in.y), between(out.z, in.z),
                        between(out.w, in.w), between(out.depth, in.depth)});
    }
    return kept;
}

template <class T>
EmulatedPolygon clipped_in_depth(const Camera& c, const RasterPrecision& precision, EmulatedPolygon polygon) {
    using enum DepthBuffer;
    const bool ends_at_zero = precision.clip_range == ClipRange::zero_to_one;
    const auto from_low = [&](const EmulatedCorner& p) { return ends_at_zero ? T(p.z) : T(p.z) + T(p.w); };
    const auto from_high = [](const EmulatedCorner& p) { return T(p.w) - T(p.z); };
    const auto from_near = [&](const EmulatedCorner& p) { return T(p.depth) - T(c.near_depth); };
    const auto from_far = [&](const EmulatedCorner& p) { return T(c.far_depth) - T(p.depth); };
    switch (precision.depth_buffer) {
        case camera_depth:
            polygon = clipped<T>(polygon, from_near);
            break;
        case standard_z:
            polygon = clipped<T>(polygon, from_low);
            break;
        case reversed_z:
            polygon = clipped<T>(polygon, from_high);
            break;
    }
    if (!std::isfinite(c.far_depth)) return polygon;
    const bool holds_far = precision.matrix_far == MatrixFar::finite || !is_perspective(c);
    if (precision.depth_buffer == camera_depth || !holds_far) return clipped<T>(polygon, from_far);
    return precision.depth_buffer == standard_z ? clipped<T>(polygon, from_high)
                                                : clipped<T>(polygon, from_low);
}

template <class T>
EmulatedPolygon clipped_all_round(const View& view, const RasterPrecision& precision,
                                  EmulatedPolygon polygon) {
    polygon = clipped_in_depth<T>(view.camera, precision, polygon);
    const bool at_sides = precision.clipping == Clipping::view_volume;
    const T x = T(at_sides ? 1 : 2 * emulated_guard_band_px / view.width - 1);
    const T y = T(at_sides ? 1 : 2 * emulated_guard_band_px / view.height - 1);
    polygon = clipped<T>(polygon, [&](const EmulatedCorner& p) { return x * T(p.w) + T(p.x); });
    polygon = clipped<T>(polygon, [&](const EmulatedCorner& p) { return x * T(p.w) - T(p.x); });
    polygon = clipped<T>(polygon, [&](const EmulatedCorner& p) { return y * T(p.w) + T(p.y); });
    return clipped<T>(polygon, [&](const EmulatedCorner& p) { return y * T(p.w) - T(p.y); });
}

}  // namespace

EmulatedDepthCode depth_code(const Camera& c, const RasterPrecision& precision) {
    const double n = c.near_depth, f = c.far_depth;
    const bool is_standard = precision.depth_buffer == DepthBuffer::standard_z;
    if (precision.depth_buffer == DepthBuffer::camera_depth) return {};
    if (!is_perspective(c))
        return is_standard ? EmulatedDepthCode{-n / (f - n), 1 / (f - n)}
                           : EmulatedDepthCode{f / (f - n), -1 / (f - n)};
    const bool is_finite = precision.matrix_far == MatrixFar::finite && std::isfinite(f);
    const double share = is_finite ? f / (f - n) : 1;
    return is_standard ? EmulatedDepthCode{share, -n * share} : EmulatedDepthCode{1 - share, n * share};
}

EmulatedTransform::EmulatedTransform(const View& view, const RasterPrecision& precision)
    : arithmetic_(precision.transform), subtracted_(0), last_(projection_rows(view.camera, precision)) {
    const Camera& c = view.camera;
    last_[2] = row_of_z(c, precision);
    glm::dmat4 camera_from_world = turned(c), moved = moved_by(-glm::dvec3(c.eye_world));
    if (precision.origin == Origin::eye) {
        subtracted_ = c.eye_world;
        moved = moved_by(glm::dvec3(0));
    }
    glm::dmat4 whole;
    for (int i = 0; i < 4; ++i) whole[i] = times(camera_from_world[i], moved);
    if (precision.matrices == 3) first_ = {moved, camera_from_world};
    if (precision.matrices == 2) first_ = {whole};
    if (precision.matrices > 1) return;
    for (glm::dvec4& row : last_) row = times(row, whole);
}

EmulatedCorner EmulatedTransform::operator()(const glm::vec3& p_world) const {
    return arithmetic_ == Arithmetic::float32 ? apply<float>(p_world) : apply<double>(p_world);
}

template <class T>
EmulatedCorner EmulatedTransform::apply(const glm::vec3& p_world) const {
    glm::vec<4, T> p{T(p_world.x) - T(subtracted_.x), T(p_world.y) - T(subtracted_.y),
                     T(p_world.z) - T(subtracted_.z), T(1)};
    for (const glm::dmat4& m : first_)
        p = {product(m[0], p), product(m[1], p), product(m[2], p), product(m[3], p)};
    return {product(last_[0], p), product(last_[1], p), product(last_[2], p), product(last_[3], p),
            product(last_[4], p)};
}

EmulatedPolygon emulated_clip(const View& view, const RasterPrecision& precision, EmulatedPolygon polygon) {
    return precision.transform == Arithmetic::float32
               ? clipped_all_round<float>(view, precision, std::move(polygon))
               : clipped_all_round<double>(view, precision, std::move(polygon));
}

}  // namespace zproof
