// The mean of texels against rational arithmetic, and the pieces of pixels that several triangles share.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "filters/area/area_integral.h"
#include "filters/area/bilinear_moments.h"
#include "filters/area/pixel_weight.h"
#include "filters/area/surfaces.h"
#include "filters/area/texel_walk.h"
#include "filters/area/triangle_rules.h"
#include "math/interval.h"
#include "math/rational.h"
#include "tests/oracle/pictures.h"
#include "tests/oracle/scenes_at_random.h"
#include "textured_plane.h"

namespace zproof::oracle {

namespace {

using namespace area;

/// Scene and view as exact numbers, or as intervals that hold them.
template <class Number>
SeenTriangle<Number> seen_at(const Scene& scene, const View& view, std::uint32_t id, int x, int y) {
    const RasterRays<Number> rays(view);
    const glm::uvec3 corners = scene.triangles[id];
    const auto t = seen(rays, corners_world<Number>(scene, corners),
                        corner_texels<Number>(scene, scene.materials[0], corners));
    return from(*t, Number(x + 0.5), Number(y + 0.5));
}

/// Red of the texels times their areas.
struct RationalSum {
    const SurfaceColour& colour;
    Cell base;
    Rational sum = 0;

    Rational red(const Cell& c) const {
        return Rational(
            double(colour.texel(colour.column(base.column + c.column), colour.row(base.row + c.row)).r));
    }
    void part(const Cell& cell, const Polygon<Rational>& polygon) { sum += red(cell) * area_of(polygon); }
    static bool takes(const TexelLattice<Rational>&, std::int64_t, std::int64_t, std::int64_t) {
        return true;
    }
    void whole(const TexelLattice<Rational>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) {
        lattice.visit_run(row, first, last,
                          [&](const Cell& cell, const Rational& area) { sum += red(cell) * area; });
    }
};

Polygon<Rational> image_in_pixel(const SeenTriangle<Rational>& t) {
    Polygon<Rational> polygon = square(Rational(1) / 2);
    for (const Affine<Rational>& edge : t.edge) polygon = cut(polygon, edge).inside;
    return polygon;
}

/// The mean over a pixel of a scene of triangles that do not hide each other, exactly.
double rational_mean(const Scene& scene, const View& view, int x, int y) {
    const Surfaces surfaces(scene, view);
    Rational mean = 0;
    for (std::uint32_t id = 0; id < scene.triangles.size(); ++id) {
        const auto t = seen_at<Rational>(scene, view, id, x, y);
        const Polygon<Rational> polygon = image_in_pixel(t);
        if (polygon.size() < 3) continue;
        const auto [map, base] = rebased(t.texels, polygon[0]);
        RationalSum sum{surfaces.colour(id), base};
        TexelWalk<Rational, RationalSum>(map, sum).rows(polygon);
        mean += sum.sum;
    }
    return double(mean);
}

double width(const Interval& i) { return i.high() - i.low(); }
double size(const Interval& i) { return std::max(std::abs(i.low()), std::abs(i.high())); }

/// How far rounding may move the line f = 0 within the pixel: the width of f's interval, made of the camera
/// and the corners by outward rounding, and 8 roundings of the value when a corner is cut
/// (docs/area-integral.md, "Rounding").
double line_error(const Affine<Interval>& f) {
    const double error =
        width(f.c) + (width(f.a) + width(f.b)) / 2 + 8 * 0x1p-53 * (size(f.c) + (size(f.a) + size(f.b)) / 2);
    return error / std::hypot(std::min(std::abs(f.a.low()), std::abs(f.a.high())),
                              std::min(std::abs(f.b.low()), std::abs(f.b.high())));
}

/// Of the mean at a pixel: every line may be off along all of its length, and texels differ by at most 1.
double rounding_bound(const Scene& scene, const View& view, std::uint32_t id, int x, int y) {
    const auto t = seen_at<Interval>(scene, view, id, x, y);
    const auto about = seen_at<double>(scene, view, id, x, y);
    double bound = 0;
    for (const auto axis : {&Homography<Interval>::u, &Homography<Interval>::v}) {
        const bool is_u = axis == &Homography<Interval>::u;
        double low = 1e300, high = -1e300;
        for (const Point<double>& p : square(0.5)) {
            const double place = about.texels.at(p.x, p.y)[is_u ? 0 : 1];
            low = std::min(low, place), high = std::max(high, place);
        }
        for (double k = std::floor(low); k <= std::ceil(high); ++k)
            bound += std::sqrt(2) * line_error(t.texels.*axis - Interval(k) * t.texels.w);
    }
    for (const Affine<Interval>& edge : t.edge) bound += std::sqrt(2) * line_error(edge);
    return bound;
}

TEST(AreaIntegral, IsExactButForRounding) {
    const Scene scene = textured_plane(
        64, {.image = noise(37, 23, 5), .per_unit = 0.31, .phi_degrees = 25, .offset = {0.3, 0.71}});
    const View view = ground_view(20, 16, 30);
    const AreaTruth truth = area_truth(scene, view, Reconstruction::nearest);
    double worst = 0, worst_share = 0;
    for (int y = 1; y < 16; y += 2)
        for (int x = 0; x < 20; x += 3) {
            if (truth.kind.at(x, y) != TruthKind::interior) continue;
            const double error = std::abs(truth.mean.at(x, y).r - rational_mean(scene, view, x, y));
            const double bound = rounding_bound(scene, view, 0, x, y) + rounding_bound(scene, view, 1, x, y);
            worst = std::max(worst, error), worst_share = std::max(worst_share, error / bound);
        }
    EXPECT_LE(worst_share, 1);
    EXPECT_GT(worst, 0);
}

/// The corners of cell (k, l) in the image.
Polygon<double> cell_in_image(const Homography<double>& map, const Cell& cell) {
    Polygon<double> polygon = square(100.0);
    for (const auto& [along, first] : {std::pair{map.u, cell.column}, {map.v, cell.row}}) {
        polygon = cut(polygon, from_line(along, first, map.w)).inside;
        polygon = cut(polygon, -from_line(along, first + 1, map.w)).inside;
    }
    return polygon;
}

/// Slopes of 2^-8 per cell, the steepest that the series takes.
TEST(BilinearMoments, OfWholeCellsAreThoseOfTheirPolygons) {
    const Homography<double> map{{0.9, 0.2, 0.3}, {-0.3, 1.1, 0.1}, {0.002, 0.0015, 1}};
    const TexelLattice<double> lattice(map);
    const PixelWeight& box = weight_of(Reconstruction::bilinear);
    const WholeCellMoments<1> whole(map, lattice, box, -3, -2, 3);
    ASSERT_TRUE(whole.hold());
    for (const Cell cell : {Cell{-2, -3}, Cell{1, -3}, Cell{2, -3}}) {
        const Homography<double> within{from_line(map.u, cell.column, map.w),
                                        from_line(map.v, cell.row, map.w), map.w};
        const BilinearMoments a = whole.of(cell),
                              b = bilinear_moments<1>(cell_in_image(map, cell), within, box);
        EXPECT_NEAR(a.one[0], b.one[0], 3e-9 * b.one[0]);
        EXPECT_NEAR(a.s[0], b.s[0], 3e-9 * b.one[0]);
        EXPECT_NEAR(a.t[0], b.t[0], 3e-9 * b.one[0]);
        EXPECT_NEAR(a.st[0], b.st[0], 3e-9 * b.one[0]);
        EXPECT_GT(std::abs(a.s[0] / a.one[0] - 0.5), 1e-4);  // or nothing was asked of the slopes
    }
    EXPECT_FALSE((WholeCellMoments<1>(map, lattice, box, -3, -2, 300).hold()));
}

/// A step along u, and one along v, take |dx| + |dy| of `step_px` or a little less.
Homography<double> cells_of(double step_px) {
    const double per_px = 1 / step_px;
    return {{per_px, 0.01 * per_px, 3.3}, {-0.008 * per_px, 1.02 * per_px, 1.7}, {0.0004, -0.0003, 1}};
}

template <int across>
void expect_whole_cells_of_their_polygons(Reconstruction what, double step_px, double share) {
    const PixelWeight& weight = weight_of(what);
    const Homography<double> map = cells_of(step_px);
    const TexelLattice<double> lattice(map);
    const WholeCellMoments<across> whole(map, lattice, weight, 2, -1, 4);
    ASSERT_TRUE(whole.hold());
    for (const Cell cell : {Cell{-1, 2}, Cell{0, 2}, Cell{3, 2}}) {
        const Homography<double> within{from_line(map.u, cell.column, map.w),
                                        from_line(map.v, cell.row, map.w), map.w};
        const auto a = whole.of(cell), b = bilinear_moments<across>(cell_in_image(map, cell), within, weight);
        const double off = share * step_px * step_px;
        for (std::size_t i = 0; i < a.one.size(); ++i) {
            EXPECT_NEAR(a.one[i], b.one[i], off) << i;
            EXPECT_NEAR(a.s[i], b.s[i], off) << i;
            EXPECT_NEAR(a.t[i], b.t[i], off) << i;
            EXPECT_NEAR(a.st[i], b.st[i], off) << i;
        }
        EXPECT_GT(std::abs(a.one[0] - a.one[1]), 100 * off);  // or all pixels have one weight
    }
}

/// Shares of the cell's area. Steps of 1/8 px are the longest that Gauss's three points take, of 1/64 px its
/// two.
TEST(BilinearMoments, OfWholeCellsUnderAWeightAreThoseOfTheirPolygons) {
    for (const double step_px : {0x1p-3, 0x1p-6}) {
        const double shorter = 0.96 * step_px;
        expect_whole_cells_of_their_polygons<2>(Reconstruction::gaussian, shorter, 3e-7);
        expect_whole_cells_of_their_polygons<3>(Reconstruction::blackman_harris, shorter, 3e-7);
        expect_whole_cells_of_their_polygons<4>(Reconstruction::mitchell, shorter, 3e-7);
    }
    const Homography<double> map = cells_of(0x1.1p-3);
    EXPECT_FALSE(
        (WholeCellMoments<4>(map, TexelLattice<double>(map), weight_of(Reconstruction::mitchell), 2, -1, 4)
             .hold()));
}

double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

/// Over a triangle of area 1, the integral of b0^i b1^j b2^k is 2 i! j! k! / (i + j + k + 2)!.
double worst_monomial(std::span<const Node> rule, int degree) {
    double worst = 0;
    for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j)
            for (int k = 0; i + j + k <= degree; ++k) {
                double sum = 0;
                for (const Node& n : rule)
                    sum += n.weight * std::pow(n.a, i) * std::pow(n.b, j) * std::pow(n.c, k);
                const double exact =
                    2 * factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 2);
                worst = std::max(worst, std::abs(sum - exact));
            }
    return worst;
}

TEST(TriangleRules, AreExactUpToTheirDegree) {
    EXPECT_LT(worst_monomial(rule_of_degree_5(), 5), 1e-15);
    EXPECT_GT(worst_monomial(rule_of_degree_5(), 6), 1e-6);
    EXPECT_LT(worst_monomial(rule_of_degree_8(), 8), 1e-14);  // given to 15 digits
    EXPECT_GT(worst_monomial(rule_of_degree_8(), 9), 1e-8);
    EXPECT_LT(worst_monomial(rule_of_degree_10(), 10), 1e-15);
    EXPECT_GT(worst_monomial(rule_of_degree_10(), 11), 1e-8);
}

/// Triangles three by three corners, each of a material of its own: white, then red, then green.
Scene painted(const Corners& corners) {
    Scene scene = scene_of(corners);
    scene.materials.resize(3);
    scene.materials[1].base_color_factor = {1, 0, 0, 1};
    scene.materials[2].base_color_factor = {0, 1, 0, 1};
    scene.parts.clear();
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i)
        scene.parts.push_back(
            {.node = "", .mesh = "", .first_triangle = i, .triangle_count = 1, .material = int(i)});
    return scene;
}

AreaTruth truth_of(const Scene& scene) {
    return area_truth(scene, unit_pixels(4, 4), Reconstruction::nearest);
}

TEST(AreaIntegral, AnEdgeBeforeNothingLeavesItsAreaExactly) {
    // To the left of x = 0.3, which is raster 2.3.
    const AreaTruth truth = truth_of(painted({{0.3f, -40, -1}, {0.3f, 40, -1}, {-80, 0, -1}}));
    EXPECT_EQ(truth.kind.at(1, 1), TruthKind::interior);
    EXPECT_EQ(truth.kind.at(2, 1), TruthKind::silhouette);
    EXPECT_EQ(truth.kind.at(3, 1), TruthKind::background);
    EXPECT_DOUBLE_EQ(truth.mean.at(1, 1).r, 1);
    EXPECT_DOUBLE_EQ(truth.mean.at(2, 1).r, double(0.3f));
    EXPECT_EQ(truth.mean.at(3, 1), glm::dvec3(0));
}

TEST(AreaIntegral, AnOccluderTakesItsAreaFromWhatIsBehind) {
    const AreaTruth truth =
        truth_of(painted(together({wall(2), {{0.3f, -40, -1}, {0.3f, 40, -1}, {-80, 0, -1}}})));
    EXPECT_EQ(truth.kind.at(2, 2), TruthKind::silhouette);
    EXPECT_DOUBLE_EQ(truth.mean.at(2, 2).r, 1);
    EXPECT_DOUBLE_EQ(truth.mean.at(2, 2).g, 1 - double(0.3f));
    EXPECT_DOUBLE_EQ(truth.mean.at(0, 2).g, 0);
    EXPECT_EQ(truth.kind.at(0, 2), TruthKind::interior);
}

TEST(AreaIntegral, SurfacesThatCrossAreCutWhereTheyCross) {
    // A plane at depth 1.5 + x before x = 1/2, where it goes through the wall at depth 2: raster 2.25.
    const Corners tilted{{-1, -30, -0.5}, {-1, 30, -0.5}, {30, 0, -31.5}};
    const AreaTruth truth = truth_of(painted(together({wall(2), tilted})));
    EXPECT_NEAR(truth.mean.at(2, 1).g, 0.75, 1e-14);
    EXPECT_NEAR(truth.mean.at(2, 1).r, 1, 1e-14);
    EXPECT_EQ(truth.kind.at(2, 1), TruthKind::silhouette);
    EXPECT_NEAR(truth.mean.at(3, 1).g, 1, 1e-14);
    EXPECT_NEAR(truth.mean.at(1, 1).g, 0, 1e-14);
}

TEST(AreaIntegral, OfCoincidentTrianglesTheFirstIsSeen) {
    const AreaTruth truth = truth_of(painted(together({wall(2), wall(2), wall(2)})));
    for (const glm::dvec3& mean : truth.mean.pixels()) EXPECT_EQ(mean, glm::dvec3(1));
    EXPECT_EQ(std::ranges::count(truth.kind.pixels(), TruthKind::interior), 16);
}

/// A wall of two triangles whose common edge crosses pixels.
Corners split_wall() {
    return {{-9, -7, -1}, {9, -7, -1}, {9, 8, -1}, {-9, -7, -1}, {9, 8, -1}, {-9, 8, -1}};
}

TEST(AreaIntegral, ADiagonalIsNoSilhouetteUnlessTheMaterialChanges) {
    Scene scene = painted(split_wall());
    const AreaTruth two_colours = truth_of(scene);
    EXPECT_GE(std::ranges::count(two_colours.kind.pixels(), TruthKind::silhouette), 4);
    for (Part& part : scene.parts) part.material = 0;
    const AreaTruth one = truth_of(scene);
    EXPECT_EQ(std::ranges::count(one.kind.pixels(), TruthKind::interior), 16);
    for (const glm::dvec3& mean : one.mean.pixels()) EXPECT_NEAR(mean.r, 1, 1e-15);
}

TEST(AreaIntegral, AStepInDepthIsASilhouetteInOneMaterialToo) {
    Scene scene = painted(together({wall(2), {{0.3f, -40, -1}, {0.3f, 40, -1}, {-80, 0, -1}}}));
    for (Part& part : scene.parts) part.material = 0;
    const AreaTruth truth = truth_of(scene);
    EXPECT_EQ(truth.kind.at(2, 1), TruthKind::silhouette);
    EXPECT_DOUBLE_EQ(truth.mean.at(2, 1).g, 1);
}

/// The square of side 4 px is what decides, whatever the truth looks at.
TEST(AreaIntegral, SurfacesAroundAPixelDoNotDependOnTheTruth) {
    const Scene scene =
        painted({{0.3f, -40, -1}, {0.3f, 40, -1}, {-80, 0, -1}});  // to the left of raster 4.3
    const View view = unit_pixels(8, 4);
    const Plane<TruthKind> around = surfaces_around(scene, view);
    for (int x = 0; x < 8; ++x)
        EXPECT_EQ(around.at(x, 1), x <= 1   ? TruthKind::interior    // reaches to 3.5
                                   : x >= 6 ? TruthKind::background  // begins at 4.5
                                            : TruthKind::silhouette);
    const AreaTruth widest = area_truth(scene, view, Reconstruction::mitchell);
    for (std::size_t i = 0; i < around.pixels().size(); ++i)
        EXPECT_EQ(around.pixels()[i], widest.kind.pixels()[i]) << i;
}

/// Taller than the rows that are integrated at once.
TEST(AreaIntegral, KindsFollowAnEdgeDownATallView) {
    const Scene scene = painted({{3, -80, -1}, {-3, 80, -1}, {-80, 0, -1}});
    const View view = unit_pixels(8, 150);
    const Plane<TruthKind> around = surfaces_around(scene, view);
    const AreaTruth widest = area_truth(scene, view, Reconstruction::mitchell);
    for (std::size_t i = 0; i < around.pixels().size(); ++i)
        EXPECT_EQ(around.pixels()[i], widest.kind.pixels()[i]) << i;
    for (const TruthKind kind : {TruthKind::background, TruthKind::interior, TruthKind::silhouette})
        EXPECT_GT(std::ranges::count(around.pixels(), kind), 100);
}

/// In the last row; those before, some of which are integrated at once and forgotten, see one triangle.
TEST(AreaIntegral, TooManyTrianglesAreEstimated) {
    constexpr int rows = 100;
    Corners corners{{-50, 3, -1}, {50, 3, -1}, {0, 4000, -1}};
    for (int i = 0; i < 40; ++i) {
        const float x = -2 + 0.1f * float(i);
        corners.insert(corners.end(), {{x, -1, -1}, {x + 0.05f, -1, -1}, {x, 1, -1}});
    }
    Scene scene = scene_of(corners);
    scene.materials.resize(1);
    View view = unit_pixels(1, rows);
    view.camera.window = {-2, 2, -2, 4 * rows - 2};
    const AreaTruth truth = area_truth(scene, view, Reconstruction::nearest);
    for (int y = 0; y < rows - 2; ++y) EXPECT_EQ(truth.kind.at(0, y), TruthKind::interior) << y;
    EXPECT_EQ(truth.kind.at(0, rows - 1), TruthKind::sampled);
    EXPECT_NEAR(truth.mean.at(0, rows - 1).r, 40 * 0.05 / 16, truth.half_width.at(0, rows - 1));
    EXPECT_LE(truth.half_width.at(0, rows - 1), 0.005);
    EXPECT_GT(truth.half_width.at(0, rows - 1), 0);
}

TEST(AreaIntegral, WhatIsNotResolvedIsKnown) {
    EXPECT_TRUE(is_resolved(-0.05, 0.01));
    EXPECT_FALSE(is_resolved(0.049, 0.01));
}

}  // namespace

}  // namespace zproof::oracle
