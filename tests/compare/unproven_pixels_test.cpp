/// Where both name one triangle, the reference's promise must be no larger than the candidate's.
#include "compare/adjudicate/unproven_pixels.h"

#include <gtest/gtest.h>

#include "compare/adjudicate/image_box.h"
#include "compare/admissible/neighbourhood.h"
#include "compare/judge.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

constexpr int width = 100, height = 60;

/// Triangles of all sizes, some across the plane of far.
std::vector<Triangle> random_triangles(Rng& rng, int count) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i) {
        const double size = std::ldexp(1.0, rng.below(12) - 3), near = 2;
        Triangle t;
        for (Corner& corner : t)
            corner = {width * rng.between(0, 1) + size * (rng.between(0, 1) - 0.5),
                      height * rng.between(0, 1) + size * (rng.between(0, 1) - 0.5),
                      near + (rng.below(4) ? 20 : 2000) * rng.between(0, 1)};
        triangles.push_back(t);
    }
    return triangles;
}

/// Is the pixel's centre nearer than eps to an edge of the image, or to its outside?
bool is_near_an_edge(const TriangleImage<double>& image, double eps_px) {
    return comes_within(image, eps_px) && !comes_within(image, -eps_px);
}

/// Some of the triangles are shown, each at pixels of its own and wherever that may be.
void show_some(TestScene& t, Rng& rng) {
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto i = std::uint32_t(rng.below(2 * int(t.scene.triangles.size())));
            if (i % 2 == 0 && i < t.scene.triangles.size()) t.reference.primitive.at(x, y) = PrimitiveId(i);
        }
    t.candidate = t.reference;
    t.candidate.camera_depth.at(0, 0) = 1;  // of another renderer
}

/// Does the reference displace an edge over a pixel that is not listed farther than the candidate may, of
/// what it shows there, or of what is truly there?
void expect_finer_at_other_pixels(const FramePair& pair, int& fine, int& listed) {
    const Plane<std::uint8_t> unproven = find_unproven_pixels(pair);
    const ViewRays<double> rays(pair.view);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            listed += unproven.at(x, y);
            for (std::uint32_t i = 0; i < pair.scene.triangles.size() && !unproven.at(x, y); ++i) {
                const CornersWorld p_world = corners_of(pair.scene, i);
                const Neighbour by_reference = neighbour_of(rays.at(x, y), pair.reference.bounds, p_world),
                                by_candidate = neighbour_of(rays.at(x, y), pair.candidate.bounds, p_world);
                const double eps_px = by_reference.bounds.eps_px;
                const bool is_shown = pair.reference.frame.primitive.at(x, y) == PrimitiveId(i);
                if (!is_shown && !(by_reference.image && comes_within(*by_reference.image, 0))) continue;
                const Box box = BoxProjection(pair.view)(p_world);
                if (!box.meets(square_around(x, y, eps_px))) continue;  // beyond a tip
                if (!by_reference.image || !is_near_an_edge(*by_reference.image, eps_px)) continue;
                ASSERT_LE(eps_px, by_candidate.bounds.eps_px) << x << ' ' << y << ' ' << i;
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

TEST(UnprovenPixels, AreThoseBesideEdgesThatTheReferenceDisplacesFarther) {
    int fine = 0, listed = 0;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        TestScene t(rng.below(2) ? Projection::perspective : Projection::parallel, width, height,
                    random_triangles(rng, 12));
        RasterPrecision raster{.subpixel_bits = 2 + rng.below(9)};
        if (rng.below(2)) raster.transform = Arithmetic::float64;
        t.candidate_precision = raster;
        t.reference_precision = RasterPrecision{.subpixel_bits = 2 + rng.below(5)};
        if (rng.below(4) == 0)
            t.candidate_precision = BoundedPrecision{.eps_px = std::ldexp(1.0, -8 - rng.below(8))};
        show_some(t, rng);
        expect_finer_at_other_pixels(pair_of(t), fine, listed);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(fine, 500);
    EXPECT_GT(listed, 10'000);
}

TEST(UnprovenPixels, AreAllWhereOnlyTheReferenceMayLeaveGaps) {
    TestScene t(Projection::parallel, 2, 2, {wall(4)});
    t.candidate_precision = BoundedPrecision{.eps_px = 0.1, .depth_relative = 1e-6};
    t.candidate.camera_depth.at(0, 0) = 1;
    const auto listed = [&](bool is_watertight) {
        t.reference_precision =
            BoundedPrecision{.eps_px = 0.1, .depth_relative = 1e-6, .watertight = is_watertight};
        return std::ranges::count(find_unproven_pixels(pair_of(t)).pixels(), 1);
    };
    EXPECT_EQ(listed(true), 0);
    EXPECT_EQ(listed(false), 4);
}

/// Half a pixel beside the edge, both leave a triangle out. As one frame that is no agreement; as two it is,
/// since the reference promises as much.
TEST(UnprovenPixels, AreAllOfAFrameThatIsTheReferences) {
    TestScene t(Projection::parallel, 8, 8, {wall_left_of(4, 4)});
    answer_everywhere(t.reference, 0, 4);
    for (int y = 0; y < 8; ++y)
        for (int x = 4; x < 8; ++x) answer_background(t.reference, x, y);
    answer_background(t.reference, 3, 3);
    t.candidate = t.reference;
    t.candidate_precision = t.reference_precision = BoundedPrecision{.eps_px = 0.4, .depth_relative = 1e-6};
    EXPECT_EQ(t.class_at(3, 3), PixelClass::hole);
    EXPECT_EQ(t.class_at(2, 3), PixelClass::agree);
    EXPECT_EQ(t.class_at(5, 3), PixelClass::agree);
    answer(t.candidate, 0, 0, 0, 4 + 0x1p-20);
    EXPECT_EQ(t.class_at(3, 3), PixelClass::agree);
    t.candidate = t.reference;
    answer(t.candidate, 7, 7, 0, 4);
    EXPECT_EQ(t.class_at(3, 3), PixelClass::agree);
}

/// A triangle that both leave out agrees with nobody but the scene.
/// The corners that near makes are displaced like others: by 1/4 px. It cuts at x = 2.4.
TEST(UnprovenPixels, AreThoseBesideACutThatTheReferenceDisplacesFarther) {
    for (const bool is_far : {false, true}) {
        TestScene t(Projection::parallel, 4, 1, {{{{-64, -64, -64}, {192, -64, 192}, {-64, 192, -64}}}});
        Camera& c = t.view.camera;
        (is_far ? c.far_depth : c.near_depth) = is_far ? 2.6 : 2.4;
        (is_far ? c.near_depth : c.far_depth) = is_far ? -64 : 64;
        t.reference_precision = RasterPrecision{.transform = Arithmetic::float64, .subpixel_bits = 1};
        t.candidate_precision = BoundedPrecision{.eps_px = 1e-4, .depth_relative = 1e-6};
        const int shown = is_far ? 0 : 3;
        answer(t.reference, shown, 0, 0, shown + 0.5);
        answer(t.candidate, shown, 0, 0, shown + 0.5 - 0x1p-22);  // another renderer
        EXPECT_EQ(t.class_at(2, 0), PixelClass::hole) << is_far;
        EXPECT_EQ(t.class_at(is_far ? 3 : 1, 0), PixelClass::agree) << is_far;
    }
}

TEST(UnprovenPixels, GoToTheAdmissibleSet) {
    TestScene t(Projection::parallel, 8, 8, {wall_left_of(4, 4)});
    answer_everywhere(t.reference, 0, 4);
    for (int y = 0; y < 8; ++y)
        for (int x = 4; x < 8; ++x) answer_background(t.reference, x, y);
    answer_background(t.reference, 3, 3);  // half a pixel beside the edge
    t.candidate = t.reference;
    answer(t.candidate, 0, 0, 0, 4 + 0x1p-20);  // another renderer
    t.candidate_precision = BoundedPrecision{.eps_px = 0.4, .depth_relative = 1e-6};
    t.reference_precision = BoundedPrecision{.eps_px = 0.4, .depth_relative = 1e-6};
    EXPECT_EQ(t.class_at(3, 3), PixelClass::agree) << "the reference promises no less";
    t.reference_precision = BoundedPrecision{.eps_px = 0.6, .depth_relative = 1e-6};
    EXPECT_EQ(t.class_at(3, 3), PixelClass::hole);
    EXPECT_EQ(t.class_at(2, 3), PixelClass::agree);
}

}  // namespace
}  // namespace zproof
