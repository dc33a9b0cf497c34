#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing.h"
#include "rasterizer/rasterizer.h"
#include "truth.h"

namespace zproof::rasterizer {
namespace {

struct Count {
    int compared = 0, covered = 0;
};

/// Snapping moves an edge by at most 2^-9 px in x and in y; float64 by far less than another 2^-9 in these
/// scenes.
constexpr double reach_px = 0x1p-8;

/// Every pixel whose answer is certain must have it, and its depth within the derived bound: the vertices'
/// displacement times the slope, and two float32 roundings.
void expect_truth(const Scene& scene, const View& view, Count& count) {
    const Frame frame = render(scene, view);
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const auto truth = certain_truth(scene, view, x, y, reach_px);
            if (!truth) continue;
            ++count.compared;
            ASSERT_EQ(frame.primitive.at(x, y), truth->primitive) << "pixel " << x << ", " << y;
            if (truth->primitive == PrimitiveId::none) {
                ASSERT_EQ(frame.camera_depth.at(x, y), background_depth);
                continue;
            }
            ++count.covered;
            const double bound =
                0x1.01p-9 * truth->depth_slope_px * 1.01 + 0x1.01p-23 * std::abs(truth->depth);
            ASSERT_NEAR(frame.camera_depth.at(x, y), truth->depth, bound) << "pixel " << x << ", " << y;
        }
    }
}

/// Eye inside a cloud of triangles: many cross the near plane and the plane of the eye.
void expect_truth_in_clouds(View view, int seeds) {
    view.width = 53;
    view.height = 41;
    Count count;
    for (int seed = 0; seed < seeds; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random{std::uint32_t(seed)};
        const Scene scene = scene_of(random_triangles(random, 12, {-6, -6, -6}, {6, 6, 6}));
        ASSERT_NO_FATAL_FAILURE(expect_truth(scene, view, count));
    }
    testing::Test::RecordProperty("compared", count.compared);
    testing::Test::RecordProperty("covered", count.covered);
    EXPECT_GT(count.compared, seeds * 53 * 41 / 2)
        << "most pixels must be certain, or the test proves little";
    EXPECT_GT(count.covered, seeds * 53 * 41 / 8);
}

View turned_view() {
    View view;
    view.camera.eye_world = {0.5f, -0.25f, 1.0f};
    view.camera.right = {0.6, 0, -0.8};
    view.camera.back = {0.8, 0, 0.6};
    view.camera.window = {.left = -1.1, .right = 0.9, .bottom = -0.7, .top = 0.8};
    view.camera.near_depth = 0.3;
    view.camera.far_depth = 8;
    return view;
}

TEST(Visibility, PerspectiveAgreesWithBruteForce) { expect_truth_in_clouds(turned_view(), 150); }

TEST(Visibility, InfiniteFarPlaneAgreesWithBruteForce) {
    View view = turned_view();
    view.camera.far_depth = std::numeric_limits<double>::infinity();
    view.camera.ndc_depth = NdcDepth::zero_to_one_reversed;
    expect_truth_in_clouds(view, 50);
}

// Near / far of 1e7 and clipped corners that project far outside the guard band.
TEST(Visibility, TinyNearDepthAgreesWithBruteForce) {
    View view = turned_view();
    view.camera.near_depth = 1e-4;
    view.camera.far_depth = 1e3;
    expect_truth_in_clouds(view, 100);
}

TEST(Visibility, ParallelAgreesWithBruteForce) {
    View view = turned_view();
    view.camera.projection = Projection::parallel;
    view.camera.window = {.left = -4, .right = 5, .bottom = -3, .top = 4};
    expect_truth_in_clouds(view, 50);
}

TEST(Visibility, ObliqueAgreesWithBruteForce) {
    View view = turned_view();
    view.camera.projection = Projection::parallel;
    view.camera.window = {.left = -4, .right = 5, .bottom = -3, .top = 4};
    view.camera.shear = {0.5, -0.3};
    view.camera.near_depth = -2;
    expect_truth_in_clouds(view, 50);
}

// Triangles a thousand times larger than the view, seen from among them: the guard band cuts nearly all.
TEST(Visibility, HugeTrianglesAgreeWithBruteForce) {
    View view = turned_view();
    view.width = 53;
    view.height = 41;
    view.camera.far_depth = 1e6;
    Count count;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        const Scene scene = scene_of(random_triangles(random, 6, glm::dvec3(-6000), glm::dvec3(6000)));
        ASSERT_NO_FATAL_FAILURE(expect_truth(scene, view, count));
    }
    EXPECT_GT(count.covered, 20'000);
}

// A sheet of triangles shares its edges, and the near plane cuts many of them: still each pixel is hit
// exactly once.
TEST(Visibility, NearClippedSheetHasNoHoleAndNoOverlap) {
    View view = turned_view();
    view.width = view.height = 48;
    view.camera.near_depth = 0.5;
    view.camera.far_depth = 1e5;
    // A plane through the whole picture, from behind the eye to far away, is seen wherever it is beyond near.
    std::vector<Triangle> sheet;
    const auto corner = [&](int i, int j) {
        const Camera& c = view.camera;
        const double side = 3.0 * (i - 3) + 0.37 * (j % 2), depth = 5.0 * (j - 1) - 2.3;
        return glm::vec3(glm::dvec3(c.eye_world) + side * 5.0 * c.right + (-0.6 - 0.05 * depth) * c.up -
                         depth * c.back);
    };
    for (int j = 0; j < 6; ++j) {
        for (int i = 0; i < 6; ++i) {
            sheet.push_back({corner(i, j), corner(i + 1, j), corner(i, j + 1)});
            sheet.push_back({corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
        }
    }
    Plane<int> hits({view.width, view.height});
    for (const Triangle& t : sheet) {
        const Frame alone = render(scene_of({t}), view);
        for (std::size_t i = 0; i < hits.pixels().size(); ++i) {
            hits.pixels()[i] += alone.primitive.pixels()[i] != PrimitiveId::none;
        }
    }
    const Frame together = render(scene_of(sheet), view);
    int covered = 0;
    for (std::size_t i = 0; i < hits.pixels().size(); ++i) {
        ASSERT_LE(hits.pixels()[i], 1);
        ASSERT_EQ(together.primitive.pixels()[i] != PrimitiveId::none, hits.pixels()[i] == 1);
        covered += hits.pixels()[i];
    }
    EXPECT_GT(covered, 300);
    // No hole: within a column, the covered rows are without a gap.
    for (int x = 0; x < view.width; ++x) {
        int changes = 0;
        for (int y = 1; y < view.height; ++y) changes += hits.at(x, y) != hits.at(x, y - 1);
        ASSERT_LE(changes, 2) << "column " << x;
    }
}

TEST(Visibility, EqualDepthKeepsTheEarlierTriangle) {
    const Triangle t = at_pixels(0, 0, 16, 0, 0, 16);
    EXPECT_EQ(ids(render(scene_of({t, t, t}), raster_view(4, 4))), "\n0000\n0000\n0000\n0000\n");
}

TEST(Visibility, OrderOfTrianglesOnlyRenamesThem) {
    std::mt19937 random(11);
    for (int round = 0; round < 50; ++round) {
        auto triangles = random_triangles(random, 20, {-4, -36, -50}, {36, 4, -1});
        const Frame forward = render(scene_of(triangles), raster_view(32, 32));
        std::reverse(triangles.begin(), triangles.end());
        const Frame backward = render(scene_of(triangles), raster_view(32, 32));
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 32; ++x) {
                const PrimitiveId id = forward.primitive.at(x, y);
                const PrimitiveId renamed =
                    id == PrimitiveId::none ? id : PrimitiveId(19 - static_cast<std::uint32_t>(id));
                ASSERT_EQ(backward.primitive.at(x, y), renamed);
                ASSERT_EQ(backward.camera_depth.at(x, y), forward.camera_depth.at(x, y));
            }
        }
    }
}

// 1 / depth is stored as float32 and inverted once: the depth of a wall square to the view shows both
// roundings.
TEST(Visibility, DepthOfASquareWallIsRoundedTwice) {
    View view;
    view.width = view.height = 2;
    for (int i = 1; i < 2000; ++i) {
        const float depth = 1.0f + float(i) * 0.0137f;
        const Frame frame =
            render(scene_of({{glm::vec3{-99, -99, -depth}, {299, -99, -depth}, {-99, 299, -depth}}}), view);
        ASSERT_EQ(frame.camera_depth.at(1, 1), 1.0f / float(1.0 / double(depth))) << depth;
    }
}

/// The affine function through three corners' values, at the centre of pixel (x, y).
long double interpolated(const std::array<glm::dvec2, 3>& p, const std::array<long double, 3>& value, int x,
                         int y) {
    const auto cross = [](long double ax, long double ay, long double bx, long double by) {
        return ax * by - ay * bx;
    };
    const long double cx = x + 0.5L, cy = y + 0.5L;
    long double sum = 0, area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &a = p[(i + 1) % 3], &b = p[(i + 2) % 3];
        const long double part = cross(a.x - cx, a.y - cy, b.x - cx, b.y - cy);
        sum += part * value[i];
        area += part;
    }
    return sum / area;
}

// With corners on whole pixels nothing is lost to the snap, and what is left is float64 (far below a
// float32's last place) and the roundings that precision() declares.
TEST(Visibility, DepthIsLostToTheDeclaredRoundingsOnly) {
    const std::array<glm::dvec2, 3> p{glm::dvec2{1, 2}, {31, 4}, {9, 29}};
    const std::array<long double, 3> depth{3, 7, 5};
    for (const Projection kind : {Projection::parallel, Projection::perspective}) {
        const bool perspective = kind == Projection::perspective;
        View view = raster_view(32, 32);
        view.camera.projection = kind;
        Triangle triangle;
        std::array<long double, 3> functional;
        for (std::size_t i = 0; i < 3; ++i) {
            const double scale = perspective ? double(depth[i]) : 1.0;
            triangle[i] = glm::vec3(p[i].x * scale, -p[i].y * scale, -depth[i]);
            functional[i] = perspective ? 1 / depth[i] : depth[i];
        }
        const Frame frame = render(scene_of({triangle}), view);
        for (int y = 8; y < 16; ++y) {
            for (int x = 10; x < 18; ++x) {
                const float stored = float(interpolated(p, functional, x, y));
                ASSERT_EQ(frame.camera_depth.at(x, y), perspective ? 1 / stored : stored) << x << ", " << y;
            }
        }
    }
}

}  // namespace
}  // namespace zproof::rasterizer
