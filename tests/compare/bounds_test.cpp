/// Do the derived bounds bound? A rasterizer's transform is done in its own arithmetic, and how far each
/// corner strays from its exact place is measured in rationals.
#include "compare/bounds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/triangle_image.h"
#include "math/rational.h"
#include "random_surroundings.h"

namespace zproof {
namespace {

/// clip_from_world rows for x, y and depth, made in double and rounded once to Float.
template <class Float>
struct Transform {
    std::array<std::array<Float, 4>, 3> row;
    const View* view;

    explicit Transform(const View& v) : row{}, view(&v) {
        const Camera& c = v.camera;
        const glm::dvec3 eye(c.eye_world);
        const double w = c.window.right - c.window.left, h = c.window.top - c.window.bottom;
        const double mid_x = (c.window.right + c.window.left) / w,
                     mid_y = (c.window.top + c.window.bottom) / h;
        const glm::dvec3 x = 2 / w * c.right + mid_x * c.back, y = 2 / h * c.up + mid_y * c.back;
        const std::array<glm::dvec3, 3> axis{x, y, -c.back};
        for (std::size_t i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) row[i][std::size_t(k)] = Float(axis[i][k]);
            row[i][3] = Float(-glm::dot(axis[i], eye));
        }
    }
    /// Raster x, y on a grid of 1/256 px.
    glm::dvec2 operator()(const glm::vec3& p) const {
        const auto apply = [&](std::size_t i) {
            return ((row[i][0] * Float(p.x) + row[i][1] * Float(p.y)) + row[i][2] * Float(p.z)) + row[i][3];
        };
        const Float depth = apply(2), x = apply(0) / depth, y = apply(1) / depth;
        const Float x_px = (x + 1) * (Float(0.5) * Float(view->width)),
                    y_px = (1 - y) * (Float(0.5) * Float(view->height));
        return {std::nearbyint(double(x_px) * 256) / 256, std::nearbyint(double(y_px) * 256) / 256};
    }
};

/// The larger of the displacements in x and y, exactly measured, in px.
double strays_by(const View& view, const glm::vec3& p_world, const glm::dvec2& raster) {
    const Sight<Rational> sight(view, 0, 0);
    const auto v = exactly<Rational>(glm::dvec3(p_world)) - sight.origin;
    const Rational all = dot(sight.step_x, cross(sight.step_y, sight.direction));
    const Rational t = dot(sight.step_x, cross(sight.step_y, v)) / all;
    const Rational x = dot(v, cross(sight.step_y, sight.direction)) / all / t;
    const Rational y = dot(sight.step_x, cross(v, sight.direction)) / all / t;
    const Rational dx = x + Rational(0.5) - Rational(raster.x), dy = y + Rational(0.5) - Rational(raster.y);
    return std::max(std::abs(dx.convert_to<double>()), std::abs(dy.convert_to<double>()));
}

View turned_view(Dice& dice) {
    View view = random_view(dice);
    view.camera.projection = Projection::perspective;
    view.camera.shear = {0, 0};
    view.camera.near_depth = 0.25;
    view.camera.far_depth = 100;
    return view;
}

template <class Float>
double largest_share_of_eps(Arithmetic arithmetic) {
    double largest = 0;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        Dice dice(seed);
        const View view = turned_view(dice);
        const Camera& c = view.camera;
        const ViewBounds bounds(view, RasterPrecision{.transform = arithmetic});
        CornersWorld p;
        for (glm::vec3& corner : p) {
            const double depth = dice.between(0.5, 20);
            const double u = dice.between(c.window.left, c.window.right),
                         v = dice.between(c.window.bottom, c.window.top);
            corner = glm::vec3(glm::dvec3(c.eye_world) + depth * (u * c.right + v * c.up - c.back));
        }
        const TriangleBounds of_triangle = bounds.of(p);
        const double eps = of_triangle.at(1 / of_triangle.nearest, 0).eps_px;
        const Transform<Float> transform(view);
        for (const glm::vec3& corner : p)
            largest = std::max(largest, strays_by(view, corner, transform(corner)) / eps);
    }
    return largest;
}

TEST(Bounds, NoCornerOfAFloat64RasterizerStraysByMoreThanEpsAndSomeNearlyDo) {
    const double share = largest_share_of_eps<double>(Arithmetic::float64);
    EXPECT_LE(share, 1);
    EXPECT_GT(share, 0.5);
}

TEST(Bounds, NoCornerOfAFloat32RasterizerStraysByMoreThanEpsAndSomeNearlyDo) {
    const double share = largest_share_of_eps<float>(Arithmetic::float32);
    EXPECT_LE(share, 1);
    EXPECT_GT(share, 0.5);
}

TEST(Bounds, TheGridsShareIsHalfAStepOrAWholeOne) {
    const View view;
    EXPECT_EQ(ViewBounds(view, RasterPrecision{.subpixel_bits = 8}).background_eps_px(), 0x1p-9);
    EXPECT_EQ(ViewBounds(view, RasterPrecision{.subpixel_bits = 4}).background_eps_px(), 0x1p-5);
    EXPECT_EQ(
        ViewBounds(view, RasterPrecision{.subpixel_bits = 8, .snap = Snap::truncate}).background_eps_px(),
        0x1p-8);
}

TEST(Bounds, EveryRayIsRoundedAndBackgroundKnowsIt) {
    const double own = ViewBounds(View{}, RayPrecision{}).background_eps_px();
    EXPECT_GT(own, 0) << "a point would ask a triangle's edge exactly";
    EXPECT_LT(own, 0x1p-9);
}

}  // namespace
}  // namespace zproof
