#include "tests/precision/emulated_edges.h"

#include <algorithm>
#include <cmath>

namespace zproof {

namespace {

template <class T>
WindowPoint unsnapped(const View& view, const EmulatedCorner& p) {
    const T half_width = T(view.width) / 2, half_height = T(view.height) / 2;
    const T x = T(p.x) / T(p.w) * half_width + half_width;
    const T y = half_height - T(p.y) / T(p.w) * half_height;
    return {x, y, x, y};
}

}  // namespace

WindowPoint window_point(const View& view, const RasterPrecision& precision, const EmulatedCorner& corner) {
    WindowPoint p = precision.transform == Arithmetic::float32 ? unsnapped<float>(view, corner)
                                                               : unsnapped<double>(view, corner);
    const double grid = std::exp2(precision.subpixel_bits);
    const auto snapped = [&](double px) {
        switch (precision.snap) {
            case Snap::nearest:
                return std::nearbyint(px * grid) / grid;
            case Snap::truncate:
                return std::floor(px * grid) / grid;
            case Snap::none:
                return px;
        }
        return px;
    };
    p.x_snapped = snapped(p.x);
    p.y_snapped = snapped(p.y);
    return p;
}

EmulatedEdges::EmulatedEdges(const RasterPrecision& precision, const WindowPiece& piece)
    : precision_(precision), piece_(piece) {
    const WindowPoint& last = piece_[2];
    const bool in_float =
        precision.edge_functions != EdgeFunctions::exact && precision.edge_arithmetic == Arithmetic::float32;
    area_ = in_float ? edge<float>(piece_[0], piece_[1], last.x_snapped, last.y_snapped)
                     : edge<double>(piece_[0], piece_[1], last.x_snapped, last.y_snapped);
    is_drawn_ = area_ != 0 && std::abs(area_) / 2 >= precision_.least_area_px2;
}

template <class T>
T EmulatedEdges::edge(const WindowPoint& from, const WindowPoint& to, double x, double y) const {
    if (precision_.edge_functions == EdgeFunctions::window_coefficients) {
        const T x0 = T(from.x_snapped), y0 = T(from.y_snapped), x1 = T(to.x_snapped), y1 = T(to.y_snapped);
        const T a = y0 - y1, b = x1 - x0, c = x0 * y1 - x1 * y0;
        return -((a * T(x) + b * T(y)) + c);
    }
    const T along_x = T(to.x_snapped) - T(from.x_snapped), along_y = T(to.y_snapped) - T(from.y_snapped);
    return (T(x) - T(from.x_snapped)) * along_y - (T(y) - T(from.y_snapped)) * along_x;
}

std::optional<Weights> EmulatedEdges::weights_at(const glm::dvec2& p_raster) const {
    if (precision_.edge_functions == EdgeFunctions::exact) return exact_at(p_raster);
    return precision_.edge_arithmetic == Arithmetic::float32 ? rounded_at<float>(p_raster)
                                                             : rounded_at<double>(p_raster);
}

/// Coordinates have at most 25 bits on the grid, so doubles hold differences and products without error.
std::optional<Weights> EmulatedEdges::exact_at(const glm::dvec2& p_raster) const {
    const double sign = area_ > 0 ? 1 : -1;
    Weights weights;
    for (std::size_t i = 0; i < 3; ++i) {
        const WindowPoint &from = piece_[(i + 1) % 3], &to = piece_[(i + 2) % 3];
        const double value = sign * edge<double>(from, to, p_raster.x, p_raster.y);
        const double rises = sign * (from.y_snapped - to.y_snapped),
                     runs = sign * (to.x_snapped - from.x_snapped);
        const bool owns_its_line = rises > 0 || (rises == 0 && runs > 0);
        if (value < 0 || (value == 0 && !owns_its_line)) return std::nullopt;
        weights[i] = value / (sign * area_);
    }
    return weights;
}

template <class T>
std::optional<Weights> EmulatedEdges::rounded_at(const glm::dvec2& p_raster) const {
    const T epsilon = T(std::copysign(2 * precision_.area_epsilon_px2, area_));
    const bool is_remainder = precision_.third_weight == ThirdWeight::remainder;
    Weights weights;
    for (std::size_t i = 0; i < 3; ++i) {
        const WindowPoint &from = piece_[(i + 1) % 3], &to = piece_[(i + 2) % 3], &opposite = piece_[i];
        // two weights may have areas of their own, each the edge function at the corner opposite
        const T area = is_remainder ? edge<T>(from, to, opposite.x_snapped, opposite.y_snapped) : T(area_);
        const T weight = is_remainder && i == 2
                             ? (T(1) - T(weights[0])) - T(weights[1])
                             : edge<T>(from, to, p_raster.x, p_raster.y) / (area + epsilon);
        if (weight < T(-precision_.barycentric_tolerance)) return std::nullopt;
        weights[i] = weight;
    }
    return weights;
}

HomogeneousEdges::HomogeneousEdges(const RasterPrecision& precision, const View& view,
                                   const std::array<EmulatedCorner, 3>& corners)
    : arithmetic_(precision.edge_arithmetic), view_(view), corners_(corners) {
    arithmetic_ == Arithmetic::float32 ? set_up<float>() : set_up<double>();
}

template <class T>
void HomogeneousEdges::set_up() {
    using Vector = glm::vec<3, T>;
    const auto corner = [&](std::size_t i) {
        const EmulatedCorner& p = corners_[i % 3];
        return Vector{T(p.x), T(p.y), T(p.w)};
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector a = corner(i + 1), b = corner(i + 2);
        normals_[i] = glm::dvec3(Vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x});
    }
    const Vector n(normals_[0]), p = corner(0);
    determinant_ = (n.x * p.x + n.y * p.y) + n.z * p.z;
}

std::optional<float> HomogeneousEdges::depth_at(const glm::dvec2& p_raster) const {
    return arithmetic_ == Arithmetic::float32 ? rounded_depth_at<float>(p_raster)
                                              : rounded_depth_at<double>(p_raster);
}

template <class T>
std::optional<float> HomogeneousEdges::rounded_depth_at(const glm::dvec2& p_raster) const {
    const Camera& c = view_.camera;
    const Window& w = c.window;
    const T u = T(w.left + (w.right - w.left) * p_raster.x / view_.width);
    const T v = T(w.top - (w.top - w.bottom) * p_raster.y / view_.height);
    const bool is_perspective = c.projection == Projection::perspective;
    T sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec<3, T> n(normals_[i]);
        const T weight = ((n.x * u + n.y * v) + n.z) / T(determinant_);
        if (weight < 0) return std::nullopt;
        sum += is_perspective ? weight : weight * T(corners_[i].depth);
    }
    const T depth = is_perspective ? 1 / sum : sum;
    if (!(depth >= T(c.near_depth) && depth <= T(c.far_depth))) return std::nullopt;
    return float(depth);
}

std::optional<HomogeneousEdges::Box> HomogeneousEdges::box_px() const {
    const Window& w = view_.camera.window;
    Box box{glm::dvec2(HUGE_VAL), glm::dvec2(-HUGE_VAL)};
    for (const EmulatedCorner& p : corners_) {
        if (!(p.w > 0)) return std::nullopt;
        const glm::dvec2 px{(p.x / p.w - w.left) / (w.right - w.left) * view_.width,
                            (w.top - p.y / p.w) / (w.top - w.bottom) * view_.height};
        box = {glm::min(box.low, px), glm::max(box.high, px)};
    }
    return box;
}

}  // namespace zproof
