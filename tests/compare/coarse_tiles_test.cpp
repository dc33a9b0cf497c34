/// Where both name one triangle, the reference's promise must be no larger than the candidate's.
#include "compare/agree/coarse_tiles.h"

#include <gtest/gtest.h>

#include "compare/admissible/neighbourhood.h"
#include "compare/judge.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

constexpr int width = 100, height = 60;

/// Triangles of all sizes, some across the planes of near and far.
std::vector<Triangle> random_triangles(Rng& rng, int count) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i) {
        const double size = std::ldexp(1.0, rng.below(12) - 3), near = rng.below(3) ? 2 : 0.1;
        Triangle t;
        for (Corner& corner : t)
            corner = {width * rng.between(0, 1) + size * (rng.between(0, 1) - 0.5),
                      height * rng.between(0, 1) + size * (rng.between(0, 1) - 0.5),
                      near + (rng.below(4) ? 20 : 2000) * rng.between(0, 1)};
        triangles.push_back(t);
    }
    return triangles;
}

/// Is a triangle within its own eps of a pixel outside of coarse tiles displaced farther by the reference?
void expect_finer_outside_of_coarse_tiles(const FramePair& pair, int& fine, int& coarse_pixels) {
    const CoarseTiles coarse(pair);
    const ViewRays<double> rays(pair.view);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (coarse.hold(x, y)) {
                ++coarse_pixels;
                continue;
            }
            for (std::uint32_t i = 0; i < pair.scene.triangles.size(); ++i) {
                const CornersWorld p_world = corners_of(pair.scene, i);
                const Neighbour by_reference = neighbour_of(rays.at(x, y), pair.reference.bounds, p_world),
                                by_candidate = neighbour_of(rays.at(x, y), pair.candidate.bounds, p_world);
                if (!by_reference.image || !comes_within(*by_reference.image, by_reference.bounds.eps_px))
                    continue;
                ASSERT_LE(by_reference.bounds.eps_px, by_candidate.bounds.eps_px)
                    << x << ' ' << y << ' ' << i;
                ++fine;
            }
        }
}

FramePair pair_of(const TestScene& t) {
    return {t.scene,
            t.view,
            {t.view, {t.candidate, t.candidate_precision}},
            {t.view, {t.reference, t.reference_precision}}};
}

TEST(CoarseTiles, HoldEveryPixelNearATriangleThatTheReferenceDisplacesFarther) {
    int fine = 0, coarse = 0;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        TestScene t(rng.below(2) ? Projection::perspective : Projection::parallel, width, height,
                    random_triangles(rng, 12));
        RasterPrecision raster{.subpixel_bits = 6 + rng.below(9)};
        if (rng.below(2)) raster.transform = Arithmetic::float64;
        t.candidate_precision = raster;
        if (rng.below(4) == 0)
            t.candidate_precision = BoundedPrecision{.eps_px = std::ldexp(1.0, -8 - rng.below(8))};
        if (rng.below(4) == 0) t.candidate_precision = RayPrecision{.arithmetic = Arithmetic::float64};
        expect_finer_outside_of_coarse_tiles(pair_of(t), fine, coarse);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(fine, 10'000);
    EXPECT_GT(coarse, 10'000);
}

TEST(CoarseTiles, AreAllWhereABackgroundIsCoarser) {
    TestScene t(Projection::parallel, width, height, {wall(4)});
    t.candidate_precision = BoundedPrecision{.eps_px = 1e-9};
    EXPECT_TRUE(CoarseTiles(pair_of(t)).hold(0, 0));
    t.candidate_precision = raster_precision();
    EXPECT_FALSE(CoarseTiles(pair_of(t)).has_any());
}

/// A triangle that both leave out agrees with nobody but the scene.
TEST(CoarseTiles, SendAWrongAnswerThatBothShareToTheAdmissibleSet) {
    TestScene t(Projection::parallel, 8, 8, {wall_left_of(4, 4)});
    answer_everywhere(t.reference, 0, 4);
    for (int y = 0; y < 8; ++y)
        for (int x = 4; x < 8; ++x) answer_background(t.reference, x, y);
    answer_background(t.reference, 3, 3);  // half a pixel beside the edge
    t.candidate = t.reference;
    t.candidate_precision = BoundedPrecision{.eps_px = 0.4, .depth_relative = 1e-6};
    t.reference_precision = BoundedPrecision{.eps_px = 0.4, .depth_relative = 1e-6};
    EXPECT_EQ(t.class_at(3, 3), PixelClass::agree) << "the reference promises no less";
    t.reference_precision = BoundedPrecision{.eps_px = 0.6, .depth_relative = 1e-6};
    EXPECT_EQ(t.class_at(3, 3), PixelClass::hole);
    EXPECT_EQ(t.class_at(2, 3), PixelClass::agree);
}

}  // namespace
}  // namespace zproof
