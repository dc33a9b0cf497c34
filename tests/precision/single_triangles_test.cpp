/// Triangles that the suite does not have, one at a time: needles, and such as run from close to the eye to
/// far away.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "compare/judge.h"
#include "oracle/embree.h"
#include "tests/precision/emulated_rasterizer.h"

namespace zproof {
namespace {

struct Declared {
    std::string name;
    RasterPrecision precision;
};

std::vector<Declared> tolerant() {
    constexpr RasterPrecision software{.snap = Snap::none,
                                       .edge_functions = EdgeFunctions::from_corner,
                                       .barycentric_tolerance = 1e-3,
                                       .watertight = false,
                                       .depth_roundings = 4};
    RasterPrecision coarse = software, wide = software, wider, fine, moved, reversed;
    coarse.barycentric_tolerance = 0.01;
    wide.edge_arithmetic = Arithmetic::float64;
    wide.barycentric_tolerance = 0.01;
    wider = fine = moved = reversed = wide;
    wider.transform = Arithmetic::float64;
    wider.interpolation = Arithmetic::float64;
    wider.barycentric_tolerance = 0.2;
    fine.transform = Arithmetic::float64;
    fine.depth_roundings = 1;
    moved.interpolation = Arithmetic::float64;
    moved.barycentric_tolerance = 0.05;
    moved.depth_roundings = 1;
    reversed.depth_buffer = DepthBuffer::reversed_z;
    return {{"software", software}, {"coarse", coarse}, {"wide", wide},        {"wider", wider},
            {"fine", fine},         {"moved", moved},   {"reversed", reversed}};
}

RasterPrecision with_float32_edges_of_float64_corners(EdgeFunctions edges) {
    return {.transform = Arithmetic::float64,
            .snap = Snap::none,
            .edge_functions = edges,
            .watertight = false,
            .interpolation = Arithmetic::float64};
}

class Draw {
  public:
    explicit Draw(unsigned seed) : words_(seed) {}

    double between(double low, double high) { return low + (high - low) * double(words_()) / 0x1p32; }
    double power(double low, double high) { return low * std::exp2(between(0, std::log2(high / low))); }

  private:
    std::mt19937 words_;
};

/// A raster position and a depth. In braces numbers are drawn from left to right.
struct Seen {
    double x, y, depth;
};

glm::vec3 seen_at(const View& view, const Seen& seen) {
    const auto& [x, y, depth] = seen;
    const Camera& c = view.camera;
    const glm::dvec3 beside = (2 * x / view.width - 1) * c.right + (1 - 2 * y / view.height) * c.up;
    return glm::vec3(glm::dvec3(c.eye_world) +
                     (c.projection == Projection::perspective ? depth : 1.0) * beside - depth * c.back);
}

View view_from(const glm::vec3& eye, int width, int height, double turn = 0) {
    View view;
    view.width = width, view.height = height;
    Camera& c = view.camera;
    c.eye_world = eye;
    c.back = {std::sin(turn) * std::cos(turn / 9), std::sin(turn / 9), std::cos(turn) * std::cos(turn / 9)};
    c.right = normalize(cross(glm::dvec3(0, 1, 0), c.back));
    c.up = cross(c.back, c.right);
    c.window = {-1, 1, -1, 1};
    c.near_depth = 0.1;
    c.far_depth = 2000;
    return view;
}

std::uint64_t defects_of(const std::array<Seen, 3>& corners, const View& view,
                         const RasterPrecision& precision) {
    Scene scene;
    for (const Seen& corner : corners) scene.vertices.position_world.push_back(seen_at(view, corner));
    scene.triangles = {{0, 1, 2}};
    scene.materials.emplace_back();
    scene.parts.emplace_back().triangle_count = 1;
    return defect_count(judge(scene, view, {emulate(precision, scene, view), precision},
                              {oracle::Embree(scene).trace(view), oracle::embree_precision()}));
}

/// Two corners close to the eye and one far away: a weight of minus the tolerance there counts by the ratio
/// of their depths.
TEST(SingleTriangles, OfATolerantRasterizerRunFarAway) {
    for (const auto& [name, precision] : tolerant()) {
        Draw draw(3);
        for (int i = 0; i < 400; ++i) {
            const View view = view_from(i % 2 == 0 ? glm::vec3(0) : glm::vec3(1000, 700, -400), 64, 64,
                                        draw.between(-3, 3));
            const double near = draw.power(0.2, 2), far = draw.power(10, 1500);
            EXPECT_EQ(
                defects_of({{{draw.between(-40, 20), draw.between(20, 100), near},
                             {draw.between(40, 100), draw.between(20, 100), near * draw.between(0.8, 1.2)},
                             {draw.between(20, 40), draw.between(10, 30), far}}},
                           view, precision),
                0u)
                << name << ' ' << i;
        }
    }
}

/// Needles, which both weights of a corner leave behind it; on a grid, and on none; with a larger area than
/// theirs.
TEST(SingleTriangles, OfATolerantRasterizerEndBeyondTheirTips) {
    for (const auto& [snap, epsilon_px2] :
         {std::pair{Snap::none, 0.0}, std::pair{Snap::nearest, 0.0}, std::pair{Snap::none, 1.0}})
        for (const Projection projection : {Projection::perspective, Projection::parallel}) {
            const RasterPrecision precision{.transform = Arithmetic::float64,
                                            .snap = snap,
                                            .edge_functions = EdgeFunctions::from_corner,
                                            .edge_arithmetic = Arithmetic::float64,
                                            .barycentric_tolerance = 1e-2,
                                            .area_epsilon_px2 = epsilon_px2,
                                            .watertight = false};
            Draw draw(5);
            for (int i = 0; i < 200; ++i) {
                View view = view_from(glm::vec3(0), 256, 16);
                view.camera.projection = projection;
                const double thin = draw.power(1e-4, 1), y = draw.between(4, 12), x = draw.between(150, 240),
                             upright = draw.between(-1, 1);
                EXPECT_EQ(
                    defects_of({{{2, y, 1}, {x, y + upright * thin, 4}, {x + upright * thin, y + thin, 4}}},
                               view, precision),
                    0u)
                    << i;
            }
        }
}

/// A corner at 1500 px is rounded by 1e-4 px, of which a thin triangle's depth takes notice.
TEST(SingleTriangles, HaveCornersThatNarrowEdgeFunctionsRound) {
    for (const EdgeFunctions edges : {EdgeFunctions::from_corner, EdgeFunctions::window_coefficients}) {
        Draw draw(7);
        for (int i = 0; i < 40; ++i) {
            const View view = view_from(glm::vec3(0), 1920, 4);
            const double x = draw.between(1200, 1900), width = draw.power(0.5, 20);
            EXPECT_EQ(defects_of({{{x, -4, draw.between(1, 8)},
                                   {x + width, -4, draw.between(1, 8)},
                                   {x + draw.between(0, width), 9, draw.between(1, 8)}}},
                                 view, with_float32_edges_of_float64_corners(edges)),
                      0u)
                << i;
        }
    }
}

std::array<Seen, 3> three(const std::function<Seen()>& drawn) { return {drawn(), drawn(), drawn()}; }

/// Clipping compares z, which far away is coarse.
TEST(SingleTriangles, OfVaryingsReachBeyondTheFarPlane) {
    constexpr RasterPrecision precision{.depth_buffer = DepthBuffer::standard_z,
                                        .matrix_far = MatrixFar::finite,
                                        .shown_depth = ShownDepth::varying};
    Draw draw(13);
    for (int i = 0; i < 400; ++i) {
        View view = view_from(glm::vec3(0), 64, 64);
        view.camera.near_depth = 0.05, view.camera.far_depth = draw.between(150, 250);
        const auto corner = [&] {
            return Seen{draw.between(-64, 128), draw.between(-64, 128), draw.power(20, 1000)};
        };
        EXPECT_EQ(defects_of(three(corner), view, precision), 0u) << i;
    }
}

/// What a side of the picture leaves of a large triangle may be too small to be drawn.
TEST(SingleTriangles, LoseTheSmallPiecesThatSidesLeave) {
    constexpr RasterPrecision precision{.transform = Arithmetic::float64,
                                        .snap = Snap::none,
                                        .edge_functions = EdgeFunctions::from_corner,
                                        .edge_arithmetic = Arithmetic::float64,
                                        .least_area_px2 = 2,
                                        .watertight = false,
                                        .clipping = Clipping::view_volume};
    Draw draw(17);
    for (int i = 0; i < 400; ++i) {
        const View view = view_from(glm::vec3(0), 16, 16);
        const auto corner = [&] {
            return Seen{draw.between(-8, 24), draw.between(-8, 24), draw.between(1, 2)};
        };
        EXPECT_EQ(defects_of(three(corner), view, precision), 0u) << i;
    }
}

/// The image's diagonal, which rounding opens, is one of what the sides leave of a triangle that covers it.
TEST(SingleTriangles, AreOpenAlongTheDiagonalsThatSidesLeave) {
    constexpr RasterPrecision precision{.matrices = 3,
                                        .snap = Snap::none,
                                        .edge_functions = EdgeFunctions::window_coefficients,
                                        .watertight = false,
                                        .clipping = Clipping::view_volume,
                                        .depth_roundings = 4};
    Draw draw(29);
    for (int i = 0; i < 400; ++i) {
        const int side = int(draw.between(20, 60));
        const View view = view_from(glm::vec3(1000, 700, -400), side, side, draw.between(-3, 3));
        const double far = side * draw.between(2, 3);
        const auto depth = [&] { return draw.power(1, 100); };
        EXPECT_EQ(
            defects_of({{{-far, -far, depth()}, {far, -far, depth()}, {0, far, depth()}}}, view, precision),
            0u)
            << i;
    }
}

/// Far leaves nothing of it, but for rounding: a piece beside a corner, whose edges are as short as any.
TEST(SingleTriangles, HaveCornersBehindTheFarPlane) {
    constexpr RasterPrecision precision{.matrices = 3,
                                        .snap = Snap::none,
                                        .edge_functions = EdgeFunctions::window_coefficients,
                                        .watertight = false,
                                        .clipping = Clipping::view_volume,
                                        .depth_roundings = 4};
    Draw draw(19);
    for (int i = 0; i < 4000; ++i) {
        View view = view_from(glm::vec3(0), 16, 16);
        const double far = view.camera.far_depth = draw.between(9, 11);
        const auto beyond = [&](double share) {
            return Seen{draw.between(-20, 40), draw.between(-20, 40), far * (1 + share)};
        };
        const Seen corner{draw.between(2, 14), draw.between(2, 14), far * (1 + draw.between(0, 3e-7))};
        EXPECT_EQ(defects_of({{corner, beyond(0.002), beyond(0.003)}}, view, precision), 0u) << i;
    }
}

/// Depths of both signs cancel where the eye is, and their roundings do not.
TEST(SingleTriangles, PassAParallelEye) {
    constexpr RasterPrecision precision{.transform = Arithmetic::float64,
                                        .snap = Snap::none,
                                        .edge_functions = EdgeFunctions::from_corner,
                                        .edge_arithmetic = Arithmetic::float64,
                                        .watertight = false,
                                        .depth_roundings = 1};
    Draw draw(23);
    for (int i = 0; i < 400; ++i) {
        View view = view_from(glm::vec3(0), 64, 16);
        view.camera.projection = Projection::parallel;
        view.camera.near_depth = -300;
        const auto corner = [&] {
            return Seen{draw.between(-64, 128), draw.between(-16, 32), draw.between(-250, 250)};
        };
        EXPECT_EQ(defects_of(three(corner), view, precision), 0u) << i;
    }
}

}  // namespace
}  // namespace zproof
