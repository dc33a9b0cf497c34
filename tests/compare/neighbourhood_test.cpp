/// What is said of a triangle at a pixel in double is off by no more than it says.
#include "compare/admissible/neighbourhood.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/rational.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

Rational exact_value(const Affine<double>& f, const PixelOffset& at) {
    return Rational(f.a) * Rational(at.x) + Rational(f.b) * Rational(at.y) + Rational(f.c);
}

struct Tried {
    int trusted = 0, others = 0;
    double largest_share = 0;  ///< of an error, in what it may be
};

/// Both within a pixel of the centre, the double also where it is worked out in double.
void hold(const Affine<double>& f, const Affine<Rational>& truth, double error, Rng& rng, Tried& tried) {
    const PixelOffset inside{rng.between(-1, 1), rng.between(-1, 1)};
    for (const PixelOffset& at : {PixelOffset{-1, -1}, {1, -1}, {-1, 1}, {1, 1}, {0, 0}, inside}) {
        const Rational true_value = truth.at(Rational(at.x), Rational(at.y));
        const Rational off = abs(exact_value(f, at) - true_value);
        ASSERT_LE(off, Rational(error)) << at.x << ' ' << at.y;
        ASSERT_LE(abs(Rational(f.at(at.x, at.y)) - true_value), Rational(2 * error)) << at.x << ' ' << at.y;
        if (error > 0)
            tried.largest_share = std::max(tried.largest_share, double(Rational(off / Rational(error))));
    }
}

void hold(const View& view, const PixelCoord& place, const CornersWorld& p, Rng& rng, Tried& tried) {
    const ViewBounds bounds(view, RayPrecision{});
    const Neighbour n = neighbour_of(ViewRay<double>(view, place.x, place.y), bounds, p);
    ++(n.is_trusted ? tried.trusted : tried.others);
    const ViewRay<Rational> exact_ray(view, place.x, place.y);
    if (!n.is_trusted) {
        const auto edges = edges_of(ViewRay<double>(view, place.x, place.y), corners<double>(p));
        const auto exact_edges = edges_of(exact_ray, corners<Rational>(p));
        for (std::size_t edge = 0; edge < 3; ++edge)
            hold(edges[edge], exact_edges[edge], n.edge_error, rng, tried);
        return;
    }
    const auto truth = image_of(exact_ray, corners<Rational>(p));
    ASSERT_TRUE(truth) << "trusted, and edge-on";
    for (std::size_t edge = 0; edge < 3; ++edge)
        hold(n.image->edge[edge], truth->edge[edge], n.edge_error, rng, tried);
    hold(n.image->inverse_depth, truth->inverse_depth, n.plane_error, rng, tried);
}

void expect_tried(const Tried& tried) {
    EXPECT_GT(tried.trusted, 300);
    EXPECT_GT(tried.largest_share, 1e-4) << "the errors are needlessly large";
}

TEST(Neighbour, IsOffByNoMoreThanItsErrors) {
    Tried tried;
    for (std::uint32_t seed = 0; seed < 1200; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Rng rng(seed);
        for (const Neighbour& n : s.around.neighbours) hold(s.view, {s.x, s.y}, n.p_world, rng, tried);
        if (HasFatalFailure()) return;
    }
    expect_tried(tried);
    EXPECT_GT(tried.others, 50);
}

/// The origin of the view ray is a small difference of large numbers there: its rounding counts.
TEST(Neighbour, IsOffByNoMoreThanItsErrorsWhereParallelRaysStartFarAway) {
    Tried tried;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        const View view = view_from_far_away(rng);
        const PixelCoord place{rng.below(16), rng.below(16)};
        const Scene scene = random_crowd(rng, view, place.x, place.y);
        for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
            hold(view, place, corners_of(scene, t), rng, tried);
        if (HasFatalFailure()) return;
    }
    expect_tried(tried);
}

/// Two corners of a triangle of the crowd, and one far behind the third.
TEST(Neighbour, IsOffByNoMoreThanItsErrorsWithOneFarCorner) {
    Tried tried;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Rng rng(seed);
        const glm::vec3 eye = s.view.camera.eye_world;
        for (const Neighbour& n : s.around.neighbours) {
            CornersWorld p = n.p_world;
            const auto far = std::size_t(rng.below(3));
            p[far] = eye + float(std::exp2(rng.between(4, 24))) * (p[far] - eye) + (p[(far + 1) % 3] - eye);
            hold(s.view, {s.x, s.y}, p, rng, tried);
        }
        if (HasFatalFailure()) return;
    }
    expect_tried(tried);
}

/// Whoever drew it before: the image stays, and all that is a renderer's is the new one's.
TEST(SetBounds, MakesANeighbourAnotherRenderers) {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const ViewBounds ray_bounds(s.view, RayPrecision{}),
            raster_bounds(s.view, RasterPrecision{.subpixel_bits = 4});
        const ViewRay<double> ray(s.view, s.x, s.y);
        for (const Neighbour& n : s.around.neighbours) {
            Neighbour changed = neighbour_of(ray, ray_bounds, n.p_world);
            set_bounds(changed, BoundedTriangle(raster_bounds, n.p_world), s.view.camera.projection);
            const Neighbour expected = neighbour_of(ray, raster_bounds, n.p_world);
            ASSERT_EQ(changed.bounds.eps_px, expected.bounds.eps_px);
            ASSERT_EQ(changed.bounds.depth_eps_px, expected.bounds.depth_eps_px);
            ASSERT_EQ(changed.bounds.depth_relative, expected.bounds.depth_relative);
            ASSERT_EQ(changed.bounds.depth_absolute, expected.bounds.depth_absolute);
            ASSERT_EQ(changed.bounds.inverse_depth_error, expected.bounds.inverse_depth_error);
            ASSERT_EQ(changed.near_slack, expected.near_slack);
            ASSERT_EQ(changed.far_slack, expected.far_slack);
            ASSERT_EQ(changed.nearest, expected.nearest);
            ASSERT_EQ(changed.farthest, expected.farthest);
            ASSERT_EQ(changed.least_inverse_depth, expected.least_inverse_depth);
            ASSERT_EQ(changed.greatest_inverse_depth, expected.greatest_inverse_depth);
            ASSERT_EQ(changed.is_trusted, expected.is_trusted);
            ASSERT_EQ(changed.plane_error, expected.plane_error);
        }
    }
}

TEST(InverseDepthOf, HasTheBitsOfTheWholeImage) {
    int images = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        for (const Neighbour& n : s.around.neighbours) {
            const ViewRay<double> ray(s.view, s.x, s.y);
            const auto image = image_of(ray, corners<double>(n.p_world));
            const auto inverse_depth = inverse_depth_of(ray, corners<double>(n.p_world));
            ASSERT_EQ(image.has_value(), inverse_depth.has_value());
            if (!image) continue;
            ++images;
            const auto parts = [](const Affine<double>& f) { return std::array{f.a, f.b, f.c}; };
            ASSERT_EQ(parts(*inverse_depth), parts(image->inverse_depth));
        }
    }
    EXPECT_GT(images, 500);
}

}  // namespace
}  // namespace zproof
