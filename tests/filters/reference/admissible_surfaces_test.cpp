/// What a pixel may show by exact geometry: on edges, at corners, behind others, and near all of these.
#include "filters/reference/admissible_surfaces.h"

#include <gmock/gmock.h>

#include "tests/oracle/scenes_at_random.h"

namespace zproof::oracle {
namespace {

using testing::ElementsAre;

constexpr PrimitiveId first{0}, second{1}, none = PrimitiveId::none;

/// One unit to a pixel: x = column, y = -row, at depth -z.
View flat_view(int width, int height) {
    View view;
    view.width = width;
    view.height = height;
    view.camera.projection = Projection::parallel;
    view.camera.window = {0, double(width), -double(height), 0};
    view.camera.near_depth = 1;
    view.camera.far_depth = 9;
    return view;
}

std::vector<PrimitiveId> seen_at(const Scene& scene, int x, int y, const FilterPrecision& precision = {}) {
    const AdmissibleSurfaces surfaces{scene, flat_view(4, 4), precision};
    const auto ids = surfaces.at(x, y);
    return {ids.begin(), ids.end()};
}

/// A square from (0, 0) to (4, 4) px whose two triangles share its diagonal, moved to the right.
Scene square(float right_by, float z) {
    const glm::vec3 a{right_by, 0, z}, b{4 + right_by, 0, z}, c{4 + right_by, -4, z}, d{right_by, -4, z};
    return scene_of({a, b, c, a, c, d});
}

TEST(AdmissibleSurfaces, HoldTheOneTriangleThatCoversTheCentre) {
    EXPECT_THAT(seen_at(square(0, -2), 3, 0), ElementsAre(first));
    EXPECT_THAT(seen_at(square(0, -2), 0, 3), ElementsAre(second));
    EXPECT_THAT(seen_at(square(3, -2), 0, 0), ElementsAre(none));
}

TEST(AdmissibleSurfaces, OnASharedEdgeHoldBothAndNotTheBackground) {
    EXPECT_THAT(seen_at(square(0, -2), 1, 1), ElementsAre(first, second));
}

TEST(AdmissibleSurfaces, OnTheOutlineHoldTheBackground) {
    EXPECT_THAT(seen_at(square(-1.5F, -2), 2, 1), ElementsAre(first, none));
}

/// 4.7e-4 px beside the shared edge.
TEST(AdmissibleSurfaces, NextToAnEdgeHoldWhatTheDisplacementReaches) {
    const Scene scene = square(-4.7e-4F, -2);
    EXPECT_THAT(seen_at(scene, 1, 1), ElementsAre(first));
    EXPECT_THAT(seen_at(scene, 1, 1, {.displacement_px = 1e-3}), ElementsAre(first, second));
    EXPECT_THAT(seen_at(scene, 1, 1, {.displacement_px = 1e-4}), ElementsAre(first));
}

/// Six triangles round (1.5, 1.5): the sample may leave each of them, and is caught by the next one.
TEST(AdmissibleSurfaces, RoundASharedCornerHoldAllTrianglesAndNotTheBackground) {
    const glm::vec3 hub{1.5, -1.5, -2};
    const std::vector<glm::vec3> rim{{4, -1, -2},  {3, 1, -2},  {0, 0, -2},
                                     {-1, -2, -2}, {1, -4, -2}, {4, -4, -2}};
    std::vector<glm::vec3> corners;
    for (std::size_t i = 0; i < rim.size(); ++i)
        corners.insert(corners.end(), {hub, rim[i], rim[(i + 1) % rim.size()]});
    EXPECT_EQ(seen_at(scene_of(corners), 1, 1).size(), 6u);
    EXPECT_THAT(seen_at(scene_of(corners), 1, 1), testing::Not(testing::Contains(none)));
    corners.resize(15);
    EXPECT_THAT(seen_at(scene_of(corners), 1, 1), testing::Contains(none)) << "one of the six is missing";
}

/// An outline: both triangles lie on the same side of the edge that they share.
TEST(AdmissibleSurfaces, AtAFoldHoldTheBackground) {
    const glm::vec3 a{1.5, 0, -2}, b{1.5, -4, -2}, c{4, -2, -2}, d{4, -2, -3};
    EXPECT_THAT(seen_at(scene_of({a, b, c, b, a, d}), 1, 1), ElementsAre(first, second, none));
}

/// The square and a triangle over its upper left half.
Scene square_and_triangle(float triangle_z) {
    const glm::vec3 a{0, 0, -2}, b{4, 0, -2}, c{4, -4, -2}, d{0, -4, -2};
    const glm::vec3 p{0, 0, triangle_z}, q{4, 0, triangle_z}, r{0, -4, triangle_z};
    return scene_of({a, b, c, a, c, d, p, q, r});
}

TEST(AdmissibleSurfaces, LeaveOutWhatIsHidden) {
    EXPECT_THAT(seen_at(square_and_triangle(-3), 0, 1), ElementsAre(second));
    EXPECT_THAT(seen_at(square_and_triangle(-3), 1, 1), ElementsAre(first, second)) << "behind a shared edge";
    EXPECT_THAT(seen_at(square_and_triangle(-1.5F), 0, 1), ElementsAre(PrimitiveId{2}));
    EXPECT_THAT(seen_at(square_and_triangle(-2), 0, 1), ElementsAre(second, PrimitiveId{2}))
        << "equally near";
}

TEST(AdmissibleSurfaces, EndAtNearAndFar) {
    EXPECT_THAT(seen_at(square(0, -0.5F), 3, 0), ElementsAre(none));
    EXPECT_THAT(seen_at(square(0, -10), 3, 0), ElementsAre(none));
    EXPECT_THAT(seen_at(square(0, -9), 3, 0), ElementsAre(first, none)) << "in the far plane";
}

TEST(ExactVisibility, GivesASharedEdgeToTheFirstTriangle) {
    EXPECT_EQ(exact_visibility(square(0, -2), flat_view(4, 4)).primitive.at(1, 1), first);
    EXPECT_EQ(exact_visibility(square(0, -2), flat_view(4, 4)).camera_depth.at(1, 1), 2.0F);
}

TEST(ExactVisibility, GivesAnOutlineToTheNearerTriangle) {
    const glm::vec3 p{-9, 0, -3}, q{9, 0, -3}, r{0, -18, -3}, a{1.5, 0, -2}, b{1.5, -4, -2}, c{4, -2, -2};
    EXPECT_EQ(exact_visibility(scene_of({p, q, r, a, b, c}), flat_view(4, 4)).primitive.at(1, 1), second);
}

/// The shared edge passes the pixel's centre at 6e-19 px.
TEST(ExactVisibility, TellsWhatDoublesCannot) {
    const auto seen = [](float corner_x) {
        const glm::vec3 a{corner_x, 0, -2}, b{4, 0, -2}, c{4, -4, -2}, d{0, -4, -2};
        return exact_visibility(scene_of({a, b, c, a, c, d}), flat_view(4, 4)).primitive.at(1, 1);
    };
    EXPECT_EQ(seen(0x1p-60F), second);
    EXPECT_EQ(seen(-0x1p-60F), first);
}

View moved(const View& view, double x_px, double y_px) {
    View other = view;
    Window& w = other.camera.window;
    const double right = x_px * (w.right - w.left) / view.width,
                 down = y_px * (w.top - w.bottom) / view.height;
    w = {w.left + right, w.right + right, w.bottom - down, w.top - down};
    return other;
}

/// Whatever a sample sees that is displaced by no more than what is promised, is admissible.
class OfRandomScenes : public testing::TestWithParam<ProjectionKind> {};

TEST_P(OfRandomScenes, HoldWhatDisplacedSamplesSee) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        Rng rng{seed};
        const View view = random_view(rng, GetParam());
        const Scene scene = random_soup(rng, view.camera, 40);
        const double e = std::exp2(rng.between(-12, -1));
        const AdmissibleSurfaces surfaces{scene, view, {.displacement_px = e}};
        std::uint64_t held = 0, pixels = 0;
        for (int i = 0; i < 6; ++i) {
            const Frame frame =
                exact_visibility(scene, moved(view, rng.between(-e, e) * 0.999, rng.between(-e, e) * 0.999));
            for (int y = 0; y < view.height; ++y)
                for (int x = 0; x < view.width; ++x) {
                    const auto ids = surfaces.at(x, y);
                    held += ids.size(), ++pixels;
                    ASSERT_THAT(ids, testing::Contains(frame.primitive.at(x, y)))
                        << "seed " << seed << ", e " << e << ", pixel (" << x << ", " << y << ")";
                }
        }
        EXPECT_LT(double(held), double(pixels) * (1 + 4 * e + 0.1))
            << "seed " << seed << ": the set is too large";
    }
}

INSTANTIATE_TEST_SUITE_P(AdmissibleSurfaces, OfRandomScenes,
                         testing::Values(ProjectionKind::perspective, ProjectionKind::off_axis,
                                         ProjectionKind::orthographic, ProjectionKind::oblique));

}  // namespace
}  // namespace zproof::oracle
