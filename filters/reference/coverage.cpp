#include "filters/reference/coverage.h"

#include "filters/reference/seen_texture.h"
#include "math/rounding.h"

namespace zproof::oracle::filter_reference {

namespace {

struct InverseDepthRange {
    Interval farthest, nearest;
};

InverseDepthRange inverse_depth_range(const Camera& camera) {
    if (camera.projection == Projection::parallel) return {-camera.far_depth, -camera.near_depth};
    const Interval farthest = std::isinf(camera.far_depth) ? Interval{0} : Interval{1} / camera.far_depth;
    return {farthest, Interval{1} / camera.near_depth};
}

/// -1, 0 where it cannot be told, 1.
int sign_within(const Interval& value, double error) {
    const Interval any = widen(value, error);
    return (any.low() > 0) - (any.high() < 0);
}

Affine<Interval> times(int sign, const Affine<Interval>& f) { return sign < 0 ? -f : f; }

Magnitude larger_end(const Interval& a) { return {magnitude(a).high()}; }

}  // namespace

SampleBox sample_box(int x, int y, double displacement_px) {
    const Interval around{-displacement_px, displacement_px};
    const auto at = [&](double centre) { return displacement_px == 0 ? Interval{centre} : centre + around; };
    return {at(x + 0.5), at(y + 0.5)};
}

CoveringTriangle::CoveringTriangle(const View& view, const std::array<glm::vec3, 3>& corners_world,
                                   const FilterPrecision& precision)
    : rounding_(gamma(coordinate_roundings, std::exp2(-precision.arithmetic_bits))) {
    const auto corners = corners_from_eye<Interval>(view, corners_world);
    const auto sizes = corners_from_eye<Magnitude>(view, corners_world);
    const auto b = barycentric_functionals(view, corners);
    const auto b_size = barycentric_functionals(view, sizes);
    facing_ = facing(view, corners);
    facing_size_ = facing(view, sizes);
    const int side = sign_within(facing_, rounding_ * facing_size_.value);
    is_edge_on_ = side == 0;
    for (std::size_t i = 0; i < edge_count; ++i) {
        bounds_[i] = {times(side, b[i]), b_size[i]};
        const glm::vec3 p = corners_world[(i + 1) % 3], q = corners_world[(i + 2) % 3];
        edges_[i] = side < 0 ? Edge{q, p} : Edge{p, q};
    }
    if (side < 0) facing_ = -facing_;
    inverse_depth_ = {times(side, inverse_depth_functional(view, corners, b)),
                      inverse_depth_functional(view, sizes, b_size)};
    const auto [farthest, nearest] = inverse_depth_range(view.camera);
    const auto plane = [&](const Interval& inverse_depth) {
        return Bound{{Interval{0}, Interval{0}, inverse_depth * facing_},
                     {Magnitude{0}, Magnitude{0}, larger_end(inverse_depth) * facing_size_}};
    };
    bounds_[3] = {inverse_depth_.exact - plane(farthest).exact, inverse_depth_.size + plane(farthest).size};
    bounds_[4] = {plane(nearest).exact - inverse_depth_.exact, plane(nearest).size + inverse_depth_.size};
}

Interval CoveringTriangle::over(const Bound& bound, const SampleBox& box) const {
    const double size = bound.size.at(larger_end(box.x), larger_end(box.y)).value;
    return widen(bound.exact.at(box.x, box.y), rounding_ * size);
}

bool CoveringTriangle::is_undecided(std::size_t bound, const SampleBox& box) const {
    return is_edge_on_ || !(over(bounds_[bound], box).low() > 0);
}

Coverage CoveringTriangle::coverage(const SampleBox& box) const {
    if (is_edge_on_) return Coverage::undecided;
    Coverage found = Coverage::certain;
    for (const Bound& bound : bounds_) {
        const Interval value = over(bound, box);
        if (value.high() < 0) return Coverage::none;
        if (!(value.low() > 0)) found = Coverage::undecided;
    }
    return found;
}

/// Compared without the quotients. The displaced sample is the same for both.
bool CoveringTriangle::is_certainly_nearer_than(const CoveringTriangle& other, const SampleBox& box) const {
    if (is_edge_on_ || other.is_edge_on_) return false;
    const Bound difference{
        other.facing_ * inverse_depth_.exact - facing_ * other.inverse_depth_.exact,
        other.facing_size_ * inverse_depth_.size + facing_size_ * other.inverse_depth_.size};
    const double size = difference.size.at(larger_end(box.x), larger_end(box.y)).value;
    const double error = rounding_ * (2 + rounding_);  // of a product of two rounded factors
    return widen(difference.exact.at(box.x, box.y), error * size).low() > 0;
}

bool CoveringTriangle::continues_at(std::size_t edge, const CoveringTriangle& other,
                                    std::size_t other_edge) const {
    const Edge &own = edges_[edge], &others = other.edges_[other_edge];
    return !is_edge_on_ && !other.is_edge_on_ && own.from == others.to && own.to == others.from;
}

}  // namespace zproof::oracle::filter_reference
