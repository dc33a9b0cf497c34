/// A run of pixels must say, to the last bit, what each pixel says by itself.
#include "compare/agree/depth_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

constexpr int longest_run = 70;

/// The ends of an interval and their neighbours, the truth, or what nobody's depth is.
float some_depth(Rng& rng, const DepthBound& bound) {
    constexpr float inf = std::numeric_limits<float>::infinity(), most = std::numeric_limits<float>::max();
    constexpr float odd[] = {std::numeric_limits<float>::quiet_NaN(), inf, -inf, -1, -0.f, 0, 1e-40f, most};
    if (rng.below(8) == 0) return odd[rng.below(8)];
    const double share = rng.between(0, 1.25), end = rng.below(2) ? bound.low : bound.high;
    const double places[] = {bound.low, bound.truth, bound.high, bound.truth + share * (end - bound.truth)};
    const auto z = float(places[rng.below(4)]);
    return rng.below(3) == 0 ? z : std::nextafter(z, rng.below(2) ? -inf : inf);
}

/// Without any bound, all depths are as good; only a pixel by itself says so.
bool is_bounded(const DepthBound& bound) {
    return std::isfinite(bound.truth) && !(bound.low == 0 && std::isinf(bound.high));
}

struct Tried {
    int certain = 0, undecided = 0, unbounded = 0, with_plane_offset = 0;
};

void try_run(const TriangleDepth& triangle, const PixelCoord& first, std::span<const float> depths,
             Tried& tried) {
    constexpr double untouched = 77;
    const std::size_t whole = (depths.size() + errors_together - 1) / errors_together * errors_together;
    std::vector<double> errors(whole + 1, untouched);
    std::vector<float> padded(depths.begin(), depths.end());
    padded.resize(whole, std::numeric_limits<float>::quiet_NaN());
    find_depth_errors(triangle, first.x, first.y, depths.size(), padded.data(), errors.data());
    ASSERT_EQ(errors.back(), untouched) << "beyond the run";
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const DepthBound bound = triangle.at(first.x + int(i), first.y);
        const bool is_certain = triangle.has_plane() && triangle.certainly_holds(bound, depths[i]);
        const double expected = is_certain ? error_over_bound(bound, depths[i]) : undecided_error;
        if (is_bounded(bound) || errors[i] != undecided_error) {
            ASSERT_EQ(errors[i], expected)
                << "pixel " << i << " of " << depths.size() << ", depth " << depths[i];
            ASSERT_FALSE(std::signbit(errors[i]) && errors[i] == 0);
        }
        ++(!is_bounded(bound) ? tried.unbounded : is_certain ? tried.certain : tried.undecided);
    }
}

class DepthErrors : public testing::TestWithParam<Projection> {};
INSTANTIATE_TEST_SUITE_P(Projections, DepthErrors,
                         testing::Values(Projection::perspective, Projection::parallel));

TEST_P(DepthErrors, OfARunAreThoseOfItsPixelsWhateverItsLength) {
    const Precision precisions[] = {RasterPrecision{},
                                    RayPrecision{},
                                    raster_precision(),
                                    ray_precision(),
                                    PlaneRayPrecision{},
                                    RasterPrecision{.subpixel_bits = 0, .depth_roundings = 4000},
                                    RasterPrecision{.depth_buffer = DepthBuffer::reversed_z,
                                                    .depth_interpolation = DepthInterpolation::plane}};
    Tried tried;
    for (std::uint32_t seed = 0; seed < 240; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        if (s.view.camera.projection != GetParam()) continue;
        Rng rng(seed);
        for (const Neighbour& n : s.around.neighbours) {
            const int which = rng.below(int(std::size(precisions)));
            SCOPED_TRACE("precision " + std::to_string(which));
            const ViewBounds bounds(s.view, precisions[which]);
            const TriangleDepth triangle(TriangleInView(s.view, bounds, n.p_world), bounds);
            for (int length = 1; length <= longest_run; ++length) {
                const PixelCoord first{rng.below(16) - length / 2, s.y};
                std::vector<float> depths;
                for (int i = 0; i < length; ++i)
                    depths.push_back(some_depth(rng, triangle.at(first.x + i, first.y)));
                const int certain_before = tried.certain;
                try_run(triangle, first, depths, tried);
                if (bounds.of(n.p_world).plane_offset > 0)
                    tried.with_plane_offset += tried.certain - certain_before;
                if (HasFatalFailure()) return;
            }
        }
    }
    EXPECT_GT(tried.certain, 50'000);
    EXPECT_GT(tried.undecided, 50'000);
    EXPECT_GT(tried.unbounded, 1'000);
    EXPECT_TRUE(GetParam() == Projection::parallel || tried.with_plane_offset > 10'000);
}

/// Seen edge-on, only its corners bound its depth: that is left to the second tier.
TEST(DepthErrorsOf, ATriangleWithoutAPlaneAreUndecided) {
    const View view = pixel_view(Projection::perspective, 4, 4);
    const Scene scene = scene_of(view, {{{{1.5, -8, 2}, {1.5, 24, 2}, {1.5, 8, 8}}}});
    const ViewBounds bounds(view, raster_precision());
    const TriangleDepth triangle(TriangleInView(view, bounds, corners_of(scene, 0)), bounds);
    ASSERT_FALSE(triangle.has_plane());
    const float depths[errors_together] = {2, 4, 8, 4};
    double errors[errors_together]{};
    find_depth_errors(triangle, 0, 1, errors_together, depths, errors);
    for (const double error : errors) EXPECT_EQ(error, undecided_error);
}

}  // namespace
}  // namespace zproof
