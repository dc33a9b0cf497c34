#include "measure/fit/depth_error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "compare/bounds/triangle_depth.h"
#include "compare/bounds/triangle_image.h"
#include "math/rational.h"

namespace zproof::measure {
namespace {

/// A share of a depth that is less than any float32 tells.
constexpr double negligible = 0x1p-42;

/// The triangle's inverse depth at a pixel's centre, and how far that may be off.
struct InverseDepth {
    double value, error;
};

InverseDepth inverse_depth_at(const View& view, const TriangleInView& triangle, const CornersWorld& p_world,
                              const PixelAnswer& at) {
    const double value = triangle.inverse_depth.at(at.pixel.x, at.pixel.y), error = triangle.own_error;
    if (error <= negligible * std::abs(value)) return {value, error};
    const auto image = image_of(ViewRay<Rational>(view, at.pixel.x, at.pixel.y), corners<Rational>(p_world));
    if (!image) return {value, error};
    const double exact = static_cast<double>(image->inverse_depth.c);
    return {exact, std::abs(exact) * unit_roundoff_float64};
}

/// The depths that displacement explains, lowest and highest; no depth is near enough beyond a horizon.
struct DepthRange {
    double low, high;
};

DepthRange range_of(const InverseDepth& w, double shift, Projection projection) {
    if (projection == Projection::parallel) return {-w.value - shift, -w.value + shift};
    const double nearest = w.value + shift, farthest = w.value - shift;
    return {nearest > 0 ? 1 / nearest : unlimited, farthest > 0 ? 1 / farthest : unlimited};
}

DepthError error_beyond(const DepthRange& range, float depth, double margin, const Camera& camera) {
    const double z = depth, bound = z < range.low ? range.low : range.high;
    const double error = std::max({range.low - z, z - range.high, 0.0});
    const double step = double(std::nextafter(depth, background_depth)) - z;
    const double span = camera.far_depth - camera.near_depth;
    return {.relative = error == 0 ? 0 : error / std::abs(bound) + margin,
            .ulps = error / step,
            .of_range = std::isfinite(span) ? error / span : 0};
}

DepthError error_of(const View& view, const TriangleInView& triangle, const CornersWorld& p_world,
                    const PixelAnswer& at, double eps_px) {
    const float depth = at.answer.camera_depth;
    if (!std::isfinite(depth)) return {unlimited, unlimited, unlimited};
    if (triangle.is_edge_on || !std::isfinite(triangle.own_error)) return {};
    const Projection projection = view.camera.projection;
    const InverseDepth w = inverse_depth_at(view, triangle, p_world, at);
    const DepthRange range = range_of(w, eps_px * triangle.gradient, projection);
    if (!std::isfinite(range.low)) return {unlimited, unlimited, unlimited};
    // of the inverse depth in units of itself; of a parallel view's depth, of itself
    const double margin = w.error / std::abs(w.value) + 8 * unit_roundoff_float64;
    return error_beyond(range, depth, margin, view.camera);
}

}  // namespace

std::vector<DepthError> depth_errors(const Scene& scene, const View& view,
                                     std::span<const PixelAnswer> answers, double eps_px) {
    const ViewBounds bounds(view, BoundedPrecision{.eps_px = eps_px});
    const ViewRay<double> first_pixel(view, 0, 0);
    std::vector<DepthError> errors(answers.size());
    const auto work = [&](const tbb::blocked_range<std::size_t>& range) {
        PrimitiveId known = PrimitiveId::none;
        CornersWorld p_world{};
        std::optional<TriangleInView> triangle;
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            const PrimitiveId id = answers[i].answer.primitive;
            if (id == PrimitiveId::none) continue;
            if (id != known) {
                p_world = corners_of(scene, std::uint32_t(id));
                triangle.emplace(first_pixel, bounds, p_world);
                known = id;
            }
            errors[i] = error_of(view, *triangle, p_world, answers[i], eps_px);
        }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, answers.size(), 4096), work);
    return errors;
}

}  // namespace zproof::measure
