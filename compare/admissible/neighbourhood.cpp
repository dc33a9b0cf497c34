#include "compare/admissible/neighbourhood.h"

#include <algorithm>
#include <cmath>

#include "math/rounding.h"

namespace zproof {

namespace {

double steepness(const Affine<double>& f) { return std::abs(f.a) + std::abs(f.b); }

/// The image's plane over eps, clamped to the corners' inverse depths where the renderer keeps to them.
InverseDepthRange on_plane(const Neighbour& n, const InverseDepthRange& corners, bool keeps_to_corners) {
    const double shift =
        n.bounds.depth_eps_px * (n.gradient + n.plane_error) + n.plane_error + n.bounds.inverse_depth_error;
    const double middle = n.image->inverse_depth.c + n.bounds.inverse_depth_bias;
    const double low = middle - shift, high = middle + shift;
    const double least = std::clamp(low, corners.least, corners.greatest);
    const double greatest = std::clamp(high, least, corners.greatest);
    return {keeps_to_corners ? least : low, keeps_to_corners ? greatest : high};
}

/// The range widened by what rounding does to depth. Divisions come first; what they give is chosen
/// afterwards.
InverseDepthRange rounded(const InverseDepthRange& range, const LocalBounds& bounds, bool perspective) {
    const double r = bounds.depth_relative, a = bounds.depth_absolute;
    const double least_abs = std::abs(range.least), greatest_abs = std::abs(range.greatest);
    if (!perspective) return {range.least - least_abs * r - a, range.greatest + greatest_abs * r + a};
    const double share = r + a * greatest_abs;
    const double greatest = range.greatest + greatest_abs * share / (1 - share);
    return {range.least - least_abs * (r + a * least_abs), share < 1 ? greatest : unlimited};
}

InverseDepthRange inverse_depth_range(const Neighbour& n, bool keeps_to_corners, Projection projection) {
    const bool is_bounded =
        std::isfinite(n.bounds.depth_relative + n.bounds.depth_absolute + n.bounds.inverse_depth_error) &&
        (n.is_plane_known || keeps_to_corners);
    if (!is_bounded) return any_inverse_depth;
    const InverseDepthRange corners{inverse_depth_of(n.farthest, projection),
                                    inverse_depth_of(n.nearest, projection)};
    return rounded(n.image ? on_plane(n, corners, keeps_to_corners) : corners, n.bounds,
                   projection == Projection::perspective);
}

double size_of(const Vector3<double>& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// Forward errors of a triple product: at most 16 roundings, with every difference and product in absolute
/// value. Parallel projections round the origin of the ray as well, by a share of its size.
struct ProductErrors {
    double edge;         ///< of an edge's value within a pixel of the centre
    double orientation;  ///< of what the sign of all edges is taken from
};

ProductErrors product_errors(const ViewRay<double>& ray, const Corners<double>& p_world,
                             const ViewBounds::RaySize& ray_size) {
    constexpr double share = gamma(16, unit_roundoff_float64) * 4;
    const double steps = size_of(ray.step_x) + size_of(ray.step_y);
    const bool is_parallel = ray.projection == Projection::parallel;
    const double of_origin = is_parallel ? ray_size.origin : 0, moved = is_parallel ? steps : 0;
    double from_eye = 0;
    for (const Vector3<double>& p : p_world)
        from_eye = std::max(from_eye, size_of(p - ray.origin) + share * of_origin + moved);
    const double square = share * from_eye * (from_eye + of_origin);
    return {square * (ray_size.direction + steps), square * (is_parallel ? ray_size.direction : from_eye)};
}

/// What image_of() takes the orientation from, in absolute value.
double orientation_of(const ViewRay<double>& ray, const Corners<double>& p) {
    const Vector3<double> v0 = p[0] - ray.origin, v1 = p[1] - ray.origin, v2 = p[2] - ray.origin;
    const Vector3<double> normal = cross(v1 - v0, v2 - v0);
    return std::abs(dot(normal, ray.projection == Projection::perspective ? v0 : ray.direction));
}

}  // namespace

bool comes_within(const TriangleImage<double>& image, double eps_px) {
    return std::ranges::all_of(image.edge,
                               [&](const Affine<double>& e) { return e.c + eps_px * steepness(e) >= 0; });
}

std::optional<std::size_t> Neighbourhood::index_of(PrimitiveId triangle) const {
    const auto found = std::ranges::find(neighbours, std::uint32_t(triangle), &Neighbour::triangle);
    if (found == neighbours.end()) return std::nullopt;
    return std::size_t(found - neighbours.begin());
}

Neighbour seen_at(const ViewRay<double>& ray, const BoundedTriangle& triangle) {
    Neighbour n;
    n.p_world = triangle.p_world;
    const Corners<double> p_world = corners<double>(n.p_world);
    n.image = image_of(ray, p_world);
    n.edges = n.image ? n.image->edge : edges_of(ray, p_world);
    const ProductErrors errors = product_errors(ray, p_world, triangle.ray_size);
    n.edge_error = errors.edge;
    if (!n.image) return n;
    n.gradient = steepness(n.image->inverse_depth);
    n.plane_error = triangle.plane_error.at(std::abs(n.image->inverse_depth.c) + n.gradient);
    n.is_plane_known = std::isfinite(n.plane_error);
    n.is_trusted = n.is_plane_known && orientation_of(ray, p_world) > errors.orientation;
    return n;
}

void set_bounds(Neighbour& n, const BoundedTriangle& triangle, Projection projection) {
    static_cast<TriangleLimits&>(n) = triangle.bounds;
    const double of_nearest = n.nearest > 0 ? 1 / n.nearest : 0;
    n.bounds = BoundsOnPlane(triangle.bounds, n.gradient).at(n.image ? n.image->inverse_depth.c : of_nearest);
    const InverseDepthRange range = inverse_depth_range(n, triangle.keeps_to_corners, projection);
    n.least_inverse_depth = range.least;
    n.greatest_inverse_depth = range.greatest;
}

Neighbour neighbour_of(const ViewRay<double>& ray, const BoundedTriangle& triangle) {
    Neighbour n = seen_at(ray, triangle);
    set_bounds(n, triangle, ray.projection);
    return n;
}

Neighbourhood neighbourhood_of(const Scene& scene, const View& view, const ViewBounds& bounds,
                               const SearchPixel& search_pixel, double own_eps_px) {
    const ViewRay<double> ray(view, search_pixel.x, search_pixel.y);
    Neighbourhood around{
        view, search_pixel.x, search_pixel.y, own_eps_px, bounds.is_watertight(), bounds.clip_windows(), {}};
    around.view.camera.near_depth = bounds.near_depth();
    for (const std::uint32_t triangle : search_pixel.triangles) {
        Neighbour& n = around.neighbours.emplace_back(neighbour_of(ray, bounds, corners_of(scene, triangle)));
        n.triangle = triangle;
        if (n.image && comes_within(*n.image, own_eps_px))
            around.eps_px = std::max(around.eps_px, n.bounds.eps_px);
    }
    return around;
}

double own_eps_px(const Scene& scene, const View& view, const ViewBounds& bounds, const PixelCoord& place,
                  PrimitiveId answer) {
    if (answer == PrimitiveId::none) return bounds.background_eps_px();
    const ViewRay<double> ray(view, place.x, place.y);
    return neighbour_of(ray, bounds, corners_of(scene, std::uint32_t(answer))).bounds.eps_px;
}

}  // namespace zproof
