#include "compare/attributes/attribute_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/admissible/neighbourhood.h"
#include "compare/attributes/interpolation_range.h"
#include "compare/bounds/triangle_depth.h"
#include "math/rational.h"
#include "math/rounding.h"

namespace zproof {

namespace {

/// What arithmetic costs beside the displacement, by the names of docs/bounds.md.
struct InterpolationErrors {
    double relative = 0;  ///< of every weight, and of the value at the end
    double edge = 0;      ///< sum of the three edge tests' absolute errors
};

/// A triangle around a pixel.
struct Surface {
    const View& view;
    const PixelCoord& pixel;
    CornersWorld p_world;
    ViewRay<double> ray;
    Neighbour seen;
    TriangleBounds bounds;

    double least_sum = 0;  ///< of the weights, anywhere in the square
    double spread = 1;     ///< largest sum of |weights| at the centre over that
};

double sum_abs_of_edges(const Surface& s) {
    const Corners<double> p = corners<double>(s.p_world);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3<double> a = p[i] - s.ray.origin, b = p[(i + 1) % 3] - s.ray.origin;
        sum += dot(absolute_cross(b - a, b + a), absolute(s.ray.direction));
    }
    return sum;
}

std::optional<InterpolationErrors> errors_of(const RasterPrecision& precision, const Surface& s) {
    if (precision.depth_buffer != DepthBuffer::camera_depth) return std::nullopt;
    const bool is_perspective = s.view.camera.projection == Projection::perspective;
    const double of_corner = is_perspective ? s.bounds.depth_absolute / s.bounds.nearest : 0;
    return InterpolationErrors{
        .relative = compounded(2 * (s.bounds.depth_factor + of_corner) + unit_roundoff_float32)};
}

std::optional<InterpolationErrors> errors_of(const RayPrecision& precision, const Surface& s) {
    const double unit =
        precision.arithmetic == Arithmetic::float32 ? unit_roundoff_float32 : unit_roundoff_float64;
    return InterpolationErrors{.relative = compounded(gamma(8, unit) + unit_roundoff_float32),
                               .edge = gamma(7, unit) * sum_abs_of_edges(s) / 2};
}

/// Others promise nothing.
template <class Other>
std::optional<InterpolationErrors> errors_of(const Other&, const Surface&) {
    return std::nullopt;
}

/// Measures the weights in the square; nothing where double does not know their sum to be above 0.
std::optional<Surface> surface_at(const View& view, const ViewBounds& bounds, const CornersWorld& p_world,
                                  const PixelCoord& pixel) {
    const ViewRay<double> ray(view, pixel.x, pixel.y);
    Surface s{view, pixel, p_world, ray, neighbour_of(ray, bounds, p_world), bounds.of(p_world)};
    if (!s.seen.image) return std::nullopt;
    double sum = 0, sum_abs = 0, steepness = 0;
    for (const Affine<double>& edge : s.seen.image->edge) {
        sum += edge.c;
        sum_abs += std::abs(edge.c) + s.seen.edge_error;
        steepness += std::abs(edge.a) + std::abs(edge.b);
    }
    s.least_sum = sum - s.seen.bounds.depth_eps_px * steepness - 3 * s.seen.edge_error;
    s.spread = std::max(1.0, sum_abs / s.least_sum);
    return s.least_sum > 0 ? std::optional(s) : std::nullopt;
}

double slack_of(const Surface& s, const InterpolationErrors& errors, const std::array<double, 3>& a) {
    constexpr double underflow = 0x1p-126;
    const auto [low, high] = std::ranges::minmax(a);
    const double largest = std::max(std::abs(low), std::abs(high)), share = errors.edge / s.least_sum;
    return errors.relative * largest * s.spread + (high - low) * s.spread * compounded(share) + underflow;
}

/// Values that are admissible by another way than interpolation; empty: none.
struct OtherWay {
    double low = unlimited, high = -unlimited;
};

/// A value between the admissible ones' ends?
bool is_admissible(const Surface& s, const std::array<double, 3>& at_corners, float value, double slack,
                   const OtherWay& other) {
    if (!std::isfinite(value)) return false;
    if (!std::isfinite(slack)) return true;
    const auto decide = [&]<class Number>(Number) {
        const auto image =
            image_of(ViewRay<Number>(s.view, s.pixel.x, s.pixel.y), corners<Number>(s.p_world));
        if (!image) return true;
        const std::vector<Weights<Number>> places = extreme_places(*image, s.seen.bounds.depth_eps_px);
        const auto is_not_beyond = [&](int side) {
            return zproof::is_not_beyond<Number>(places, at_corners, value, slack, side);
        };
        return (value >= other.low || is_not_beyond(+1)) && (value <= other.high || is_not_beyond(-1));
    };
    try {
        return decide(Interval());
    } catch (const UndecidedSign&) {
        return decide(Rational());
    }
}

/// The ends in double.
WrongAttribute told(const Surface& s, const char* channel, const std::array<double, 3>& a, float value,
                    double slack) {
    WrongAttribute wrong{channel, value, unlimited, -unlimited};
    for (const auto& w : extreme_places(*s.seen.image, s.seen.bounds.depth_eps_px)) {
        const double here = (w.of_corner[0] * a[0] + w.of_corner[1] * a[1] + w.of_corner[2] * a[2]) / w.sum;
        wrong.low = std::min(wrong.low, here - slack);
        wrong.high = std::max(wrong.high, here + slack);
    }
    return wrong;
}

/// One value of the frame, and what it interpolates.
struct Value {
    const char* channel;
    float value;
    std::array<double, 3> at_corners;
    OtherWay other{};
};

/// A position may also be made from the depth: origin + depth direction, in float32 at least.
OtherWay by_depth(const DepthBound& depth, double origin, double direction) {
    const double a = origin + depth.low * direction, b = origin + depth.high * direction;
    const double largest = std::max(std::abs(depth.low), std::abs(depth.high));
    const double error = gamma(4, unit_roundoff_float32) * (std::abs(origin) + largest * std::abs(direction));
    return {std::min(a, b) - error, std::max(a, b) + error};
}

template <std::size_t Count>
void add(std::vector<Value>& values, const Plane<std::array<float, Count>>& plane, const PixelCoord& pixel,
         const std::array<const char*, Count>& channels,
         const std::array<std::array<double, 3>, Count>& at_corners) {
    if (plane.size().width == 0) return;
    for (std::size_t i = 0; i < Count; ++i)
        values.push_back({channels[i], plane.at(pixel.x, pixel.y)[i], at_corners[i]});
}

std::array<std::array<double, 3>, 2> uv_at_corners(const Scene& scene, const glm::uvec3& t) {
    const auto& uv = scene.vertices.uv.front();
    return {{{uv[t.x].x, uv[t.y].x, uv[t.z].x}, {uv[t.x].y, uv[t.y].y, uv[t.z].y}}};
}

std::vector<Value> values_at(const Scene& scene, const Surface& s, const ViewBounds& bounds,
                             const Frame& frame) {
    const auto id = std::uint32_t(frame.primitive.at(s.pixel.x, s.pixel.y));
    const Attributes& given = frame.attributes;
    std::vector<Value> values;
    add<2>(values, given.barycentric, s.pixel, {"b1", "b2"}, {{{0, 1, 0}, {0, 0, 1}}});
    if (!scene.vertices.uv.empty())
        add<2>(values, given.uv, s.pixel, {"u", "v"}, uv_at_corners(scene, scene.triangles[id]));
    if (given.position_world.size().width == 0) return values;
    const DepthBound depth =
        TriangleDepth(TriangleInView(s.view, bounds, s.p_world), bounds).at(s.pixel.x, s.pixel.y);
    const std::array origin{s.ray.origin.x, s.ray.origin.y, s.ray.origin.z},
        direction{s.ray.direction.x, s.ray.direction.y, s.ray.direction.z};
    constexpr std::array channels{"Px", "Py", "Pz"};
    for (int k = 0; k < 3; ++k) {
        const auto i = std::size_t(k);
        values.push_back({channels[i],
                          given.position_world.at(s.pixel.x, s.pixel.y)[i],
                          {s.p_world[0][k], s.p_world[1][k], s.p_world[2][k]},
                          by_depth(depth, origin[i], direction[i])});
    }
    return values;
}

}  // namespace

std::optional<WrongAttribute> AttributeCheck::first_wrong(const Frame& frame, const PixelCoord& pixel) const {
    const PrimitiveId id = frame.primitive.at(pixel.x, pixel.y);
    if (std::size_t(id) >= scene_.triangles.size()) return std::nullopt;
    const auto s = surface_at(view_, bounds_, corners_of(scene_, std::uint32_t(id)), pixel);
    if (!s) return std::nullopt;
    const auto errors = std::visit([&](const auto& p) { return errors_of(p, *s); }, precision_);
    if (!errors) return std::nullopt;
    for (const Value& v : values_at(scene_, *s, bounds_, frame)) {
        const double slack = slack_of(*s, *errors, v.at_corners);
        if (!is_admissible(*s, v.at_corners, v.value, slack, v.other))
            return told(*s, v.channel, v.at_corners, v.value, slack);
    }
    return std::nullopt;
}

}  // namespace zproof
