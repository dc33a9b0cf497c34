/// Do the derived bounds bound? A rasterizer's transform is done in its own arithmetic, and how far each
/// corner strays from its exact place is measured in rationals.
#include "compare/bounds/bounds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/admissible/neighbourhood.h"
#include "compare/bounds/triangle_image.h"
#include "math/rational.h"
#include "random_surroundings.h"

namespace zproof {
namespace {

/// A corner before the divide.
template <class Float>
struct ClipCorner {
    Float x, y, w;
};

/// clip_from_world rows for x, y and depth, made in double and rounded once to Float.
template <class Float>
struct Transform {
    std::array<std::array<Float, 4>, 3> row;
    glm::vec3 origin{0};
    const View* view;

    explicit Transform(const View& v, Origin from = Origin::world) : row{}, view(&v) {
        const Camera& c = v.camera;
        const double w = c.window.right - c.window.left, h = c.window.top - c.window.bottom;
        const double mid_x = (c.window.right + c.window.left) / w,
                     mid_y = (c.window.top + c.window.bottom) / h;
        const glm::dvec3 x = 2 / w * c.right + mid_x * c.back, y = 2 / h * c.up + mid_y * c.back;
        const std::array<glm::dvec3, 3> axis{x, y, -c.back};
        if (from == Origin::eye) origin = c.eye_world;
        const glm::dvec3 eye(c.eye_world - origin);
        for (std::size_t i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) row[i][std::size_t(k)] = Float(axis[i][k]);
            row[i][3] = Float(-glm::dot(axis[i], eye));
        }
    }
    ClipCorner<Float> clip(const glm::vec3& p) const {
        const std::array<Float, 3> q{Float(p.x) - Float(origin.x), Float(p.y) - Float(origin.y),
                                     Float(p.z) - Float(origin.z)};
        const auto apply = [&](std::size_t i) {
            return ((row[i][0] * q[0] + row[i][1] * q[1]) + row[i][2] * q[2]) + row[i][3];
        };
        return {apply(0), apply(1), apply(2)};
    }
    /// Raster x, y on the grid.
    glm::dvec2 raster(const ClipCorner<Float>& c, int subpixel_bits) const {
        const Float x = c.x / c.w, y = c.y / c.w;
        const Float x_px = (x + 1) * (Float(0.5) * Float(view->width)),
                    y_px = (1 - y) * (Float(0.5) * Float(view->height));
        const double per_px = std::exp2(subpixel_bits);
        return {std::nearbyint(double(x_px) * per_px) / per_px,
                std::nearbyint(double(y_px) * per_px) / per_px};
    }
};

/// The larger of the displacements in x and y, exactly measured, in px.
double strays_by(const View& view, const glm::dvec3& p_world, const glm::dvec2& raster) {
    const ViewRay<Rational> ray(view, 0, 0);
    const auto v = exactly<Rational>(p_world) - ray.origin;
    const Rational all = dot(ray.step_x, cross(ray.step_y, ray.direction));
    const Rational t = dot(ray.step_x, cross(ray.step_y, v)) / all;
    const Rational x = dot(v, cross(ray.step_y, ray.direction)) / all / t;
    const Rational y = dot(ray.step_x, cross(v, ray.direction)) / all / t;
    const Rational dx = x + Rational(0.5) - Rational(raster.x), dy = y + Rational(0.5) - Rational(raster.y);
    return std::max(std::abs(dx.convert_to<double>()), std::abs(dy.convert_to<double>()));
}

View turned_view(Rng& rng) {
    View view = random_view(rng);
    view.camera.projection = Projection::perspective;
    view.camera.shear = {0, 0};
    view.camera.near_depth = 0.25;
    view.camera.far_depth = 100;
    return view;
}

/// A corner at this depth, as a place in the window: 0 and 1 are its sides.
glm::vec3 corner_at(const Camera& c, double depth, double across, double up) {
    const double u = c.window.left + across * (c.window.right - c.window.left);
    const double v = c.window.bottom + up * (c.window.top - c.window.bottom);
    return glm::vec3(glm::dvec3(c.eye_world) + depth * (u * c.right + v * c.up - c.back));
}

template <class Float>
double largest_share_of_eps(const RasterPrecision& precision, const glm::vec3& moved = glm::vec3(0)) {
    double largest = 0;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        Rng rng(seed);
        View view = turned_view(rng);
        view.camera.eye_world += moved;
        const ViewBounds bounds(view, precision);
        CornersWorld p;
        for (glm::vec3& corner : p)
            corner = corner_at(view.camera, rng.between(0.5, 20), rng.between(0, 1), rng.between(0, 1));
        const TriangleBounds of_triangle = bounds.of(p);
        const double eps = of_triangle.most_eps_px();
        const Transform<Float> transform(view, precision.origin);
        for (const glm::vec3& corner : p)
            largest = std::max(largest,
                               strays_by(view, glm::dvec3(corner),
                                         transform.raster(transform.clip(corner), precision.subpixel_bits)) /
                                   eps);
    }
    return largest;
}

TEST(Bounds, NoCornerOfAFloat64RasterizerStraysByMoreThanEpsAndSomeNearlyDo) {
    const double share = largest_share_of_eps<double>({.transform = Arithmetic::float64});
    EXPECT_LE(share, 1);
    EXPECT_GT(share, 0.5);
}

TEST(Bounds, NoCornerOfAFloat32RasterizerStraysByMoreThanEpsAndSomeNearlyDo) {
    const double share = largest_share_of_eps<float>({.transform = Arithmetic::float32});
    EXPECT_LE(share, 1);
    EXPECT_GT(share, 0.5);
}

/// A grid so fine that only arithmetic moves corners.
constexpr int finest_grid = 24;

/// Far from the origin, where a fused matrix would move corners by pixels.
TEST(Bounds, NoCornerStraysByMoreThanEpsWhereTheEyeIsSubtractedFirst) {
    const glm::vec3 far_away{7000, -9000, 5000};
    for (const Origin origin : {Origin::eye, Origin::world}) {
        const RasterPrecision precision{.origin = origin, .subpixel_bits = finest_grid};
        const double share = largest_share_of_eps<float>(precision, far_away);
        EXPECT_LE(share, 1);
        EXPECT_GT(share, 0.05);
    }
}

/// A new corner where the edge from `out`, right of the window, to `in` leaves it.
template <class Float>
ClipCorner<Float> at_right_side(const ClipCorner<Float>& out, const ClipCorner<Float>& in, Float& t) {
    const Float beyond = out.w - out.x, within = in.w - in.x;
    t = beyond / (beyond - within);
    return {out.x + t * (in.x - out.x), out.y + t * (in.y - out.y), out.w + t * (in.w - out.w)};
}

TEST(Bounds, NoCornerMadeByClippingStraysByMoreThanEps) {
    double largest = 0;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        Rng rng(seed);
        const View view = turned_view(rng);
        const auto corner = [&](double across) {
            return corner_at(view.camera, rng.between(0.5, 20), across, rng.between(0, 1));
        };
        const double far_out = std::exp2(rng.between(0, 14));
        const CornersWorld p{corner(1 + far_out), corner(0.9), corner(0.1)};
        const ViewBounds bounds(view, RasterPrecision{.origin = Origin::eye,
                                                      .subpixel_bits = finest_grid,
                                                      .clipping = Clipping::view_volume});
        const Transform<float> transform(view, Origin::eye);
        const Transform<double> exact(view, Origin::eye);
        float t = 0;
        double t_true = 0;
        const ClipCorner<float> made = at_right_side(transform.clip(p[0]), transform.clip(p[1]), t);
        const ClipCorner<double> truly = at_right_side(exact.clip(p[0]), exact.clip(p[1]), t_true);
        const glm::dvec3 out(p[0]), in(p[1]);
        const double eps = BoundsOnPlane(bounds.of(p), 0).at(1 / truly.w).eps_px;
        largest = std::max(
            largest, strays_by(view, out + t_true * (in - out), transform.raster(made, finest_grid)) / eps);
    }
    EXPECT_LE(largest, 1);
    EXPECT_GT(largest, 0.1);
}

TEST(Bounds, TheGridsShareIsHalfAStepOrAWholeOne) {
    const View view;
    EXPECT_EQ(ViewBounds(view, RasterPrecision{.subpixel_bits = 8}).background_eps_px(), 0x1p-9);
    EXPECT_EQ(ViewBounds(view, RasterPrecision{.subpixel_bits = 4}).background_eps_px(), 0x1p-5);
    EXPECT_EQ(
        ViewBounds(view, RasterPrecision{.subpixel_bits = 8, .snap = Snap::truncate}).background_eps_px(),
        0x1p-8);
}

/// Of the smallest triangles and the largest, in views of any kind.
TEST(Bounds, NoTriangleHasLessThanBackground) {
    const std::array<Precision, 5> precisions{
        RasterPrecision{.subpixel_bits = 8}, RasterPrecision{.transform = Arithmetic::float64},
        RayPrecision{}, RayPrecision{.arithmetic = Arithmetic::float64}, PlaneRayPrecision{}};
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const ViewBounds bounds(s.view, precisions[seed % precisions.size()]);
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t)
            ASSERT_GE(own_eps_px(s.scene, s.view, bounds, {s.x, s.y}, PrimitiveId(t)),
                      bounds.background_eps_px());
    }
}

TEST(Bounds, EveryRayIsRoundedAndBackgroundKnowsIt) {
    const double own = ViewBounds(View{}, RayPrecision{}).background_eps_px();
    EXPECT_GT(own, 0) << "a point would ask a triangle's edge exactly";
    EXPECT_LT(own, 0x1p-9);
}

/// What a plane ray caster says of one triangle and the ray through a pixel's centre, in double.
bool plane_ray_hits(const View& view, const CornersWorld& p_world, int x, int y) {
    const Camera& c = view.camera;
    const Window& w = c.window;
    const double u = (w.left + w.right) / 2 + (w.right - w.left) * ((x + 0.5) / view.width - 0.5);
    const double v = (w.top + w.bottom) / 2 - (w.top - w.bottom) * ((y + 0.5) / view.height - 0.5);
    const glm::dvec3 d = glm::normalize(u * c.right + v * c.up - c.back);
    std::array<glm::dvec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = glm::dvec3(p_world[i]) - glm::dvec3(c.eye_world);
    const glm::dvec3 n = glm::normalize(glm::cross(p[0] - p[1], p[2] - p[1]));
    const glm::dvec3 hit = glm::dot(n, p[0]) / glm::dot(n, d) * d;
    int widest = 0;  // the normal's largest coordinate; the test is made in the other two
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(n[axis]) > std::abs(n[widest])) widest = axis;
    const int s = (widest + 1) % 3, t = (widest + 2) % 3;
    int positive = 0, negative = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &from = p[i], &to = p[(i + 1) % 3];
        const double left = (to[s] - hit[s]) * (to[t] - from[t]),
                     right = (to[t] - hit[t]) * (to[s] - from[s]);
        positive += left > right;
        negative += left < right;
    }
    return positive == 0 || negative == 0;
}

struct Disagreements {
    int count = 0;
    double largest_share = 0;  ///< distance from the nearest edge, over eps
};

/// A triangle with an edge through the pixel's centre, but for rounding.
CornersWorld triangle_with_an_edge_at_the_centre(Rng& rng, View& view) {
    const Camera& c = view.camera;
    CornersWorld p;
    for (glm::vec3& corner : p)
        corner = glm::vec3(glm::dvec3(c.eye_world) + rng.between(-3, 3) * c.right +
                           rng.between(-3, 3) * c.up - rng.between(1, 9) * c.back);
    const double share = rng.between(0.1, 0.9);
    const glm::dvec3 on_edge =
        (1 - share) * glm::dvec3(p[0]) + share * glm::dvec3(p[1]) - glm::dvec3(c.eye_world);
    const double depth = -glm::dot(c.back, on_edge);
    const double u = glm::dot(c.right, on_edge) / depth, v = glm::dot(c.up, on_edge) / depth;
    view.width = view.height = 8;  // the centre of pixel (3, 3) is at 7/16 of either side
    view.camera.window = {u - 0.7, u + 0.9, v - 0.9, v + 0.7};
    return p;
}

Disagreements plane_ray_disagreements() {
    Disagreements disagreements;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        Rng rng(seed);
        View view = turned_view(rng);
        const CornersWorld p = triangle_with_an_edge_at_the_centre(rng, view);
        Corners<Rational> exact;
        for (std::size_t i = 0; i < 3; ++i) exact[i] = exactly<Rational>(glm::dvec3(p[i]));
        const auto image = image_of(ViewRay<Rational>(view, 3, 3), exact);
        if (!image) continue;
        double nearest_edge = unlimited;
        bool inside = true;
        for (const auto& edge : image->edge) {
            const Rational distance = magnitude(edge.c) / (magnitude(edge.a) + magnitude(edge.b));
            nearest_edge = std::min(nearest_edge, distance.convert_to<double>());
            inside = inside && sign(edge.c) >= 0;
        }
        if (plane_ray_hits(view, p, 3, 3) == inside) continue;
        const ViewBounds bounds(view, PlaneRayPrecision{});
        const double inverse_depth = image->inverse_depth.c.convert_to<double>();
        const double eps = BoundsOnPlane(bounds.of(p), 0).at(inverse_depth).eps_px;
        ++disagreements.count;
        disagreements.largest_share = std::max(disagreements.largest_share, nearest_edge / eps);
    }
    return disagreements;
}

/// The test is made for it: a third of the edges or more are hit on the wrong side.
TEST(Bounds, APlaneRayMistakesNoEdgeThatIsFartherThanEps) {
    const Disagreements disagreements = plane_ray_disagreements();
    EXPECT_GT(disagreements.count, 100);
    EXPECT_LE(disagreements.largest_share, 1);
    EXPECT_GT(disagreements.largest_share, 0.001) << "the bound is too loose to say anything";
}

}  // namespace
}  // namespace zproof
