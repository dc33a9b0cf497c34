// Errors of routes, and the operation that loses a pixel.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "lessons/projection/accuracy.h"
#include "lessons/projection/border_lattice.h"
#include "tests/lessons/projection/random_frusta.h"

namespace zproof::study::projection {
namespace {

Scene cloud(const std::vector<glm::vec3>& points) {
    Scene scene;
    scene.name = "cloud";
    scene.vertices.position_world.assign(points.begin(), points.end());
    return scene;
}

View front(int width = 640, int height = 480) {
    View view{.name = "front", .camera = {}};
    view.width = width, view.height = height;
    return view;  // at the origin, looking down -z; canvas [-1, 1], near 0.1
}

Scene random_cloud(int count) {
    test::RandomFrusta random{11};
    std::vector<glm::vec3> points;
    for (int i = 0; i < count; ++i)
        points.emplace_back(
            glm::vec3(glm::dvec3{random.number(-2, 2), random.number(-2, 2), random.number(-5, -0.2)}));
    return cloud(points);
}

const RouteScore& score_of(const ViewAccuracy& accuracy, std::string_view route, std::string_view numbers) {
    const auto found = std::ranges::find_if(accuracy.routes, [&](const RouteScore& score) {
        return score.route == route && score.numbers == numbers;
    });
    if (found == accuracy.routes.end()) throw std::runtime_error{std::string{route} + ": no such score"};
    return *found;
}

TEST(Accuracy, EveryVertexHasItsPlace) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const ViewAccuracy a = accuracy_of(
        cloud({{0, 0, -1}, {5, 0, -1}, {0, 0, 0}, {0, 0, 1}, {nan, 0, -1}, {1, 1, -1}, {0.25f, 0, -1}}),
        front(), 100);
    EXPECT_EQ(a.vertices, 7u);
    EXPECT_EQ(a.not_finite, 1u);
    EXPECT_EQ(a.studied, 6u);
    EXPECT_EQ(a.on_canvas, 3u);  // the canvas's own corner among them
    EXPECT_EQ(a.off_canvas, 1u);
    EXPECT_EQ(a.behind_eye, 2u);  // on the eye's plane as well
    ASSERT_EQ(a.rows.size(), 3u);
    EXPECT_EQ(a.rows[0].x, 320);
    EXPECT_EQ(a.rows[0].y, 240);
    EXPECT_EQ(a.rows[1].x, 640);
    EXPECT_EQ(a.rows[1].y, 0);
    EXPECT_EQ(a.rows[2].x, 400);
    EXPECT_EQ(a.on_pixel_border, 3u);
}

TEST(Accuracy, DoubleIsFinerThanSingleByTwentyNineBits) {
    const ViewAccuracy a = accuracy_of(random_cloud(400), front(), 1000);
    ASSERT_GT(a.on_canvas, 50u);
    for (const char* route : {"stages", "stages-unit", "matrices", "one-matrix", "canvas"}) {
        const RouteScore &single = score_of(a, route, "float32"), &twice = score_of(a, route, "float64");
        EXPECT_GT(single.px.median, 1e-7) << route;
        EXPECT_LT(single.px.largest, 1e-2) << route;
        const double ratio = single.px.median / twice.px.median;
        EXPECT_GT(ratio, 0x1p27) << route;
        EXPECT_LT(ratio, 0x1p31) << route;
        EXPECT_EQ(single.no_number, 0u);
    }
}

/// x = -1/3 to the next float, times near = 0.1 and so on: exact arithmetic says 213.33..., no pixel border.
TEST(Accuracy, CostsOfOperationsAddUpToTheError) {
    const ViewAccuracy a = accuracy_of(random_cloud(60), front(), 1000);
    for (const RouteScore& score : a.routes) {
        double sum = 0;
        for (const OperationScore& operation : score.operations) sum += operation.largest_px;
        EXPECT_GE(sum * (1 + 1e-9), score.px.largest) << score.route;
        EXPECT_GT(sum, 0);
    }
}

/// On the border of two pixels exactly; near = 0.1 is no float, and near x / -z brings it to either side.
TEST(Accuracy, APixelLostIsTracedToItsOperation) {
    std::vector<glm::vec3> on_borders;
    for (int i = -63; i < 64; ++i) on_borders.emplace_back(float(i) / 64, 0.25f, -1.0f);
    const ViewAccuracy a = accuracy_of(cloud(on_borders), front(), 1000);
    EXPECT_EQ(a.on_pixel_border, a.on_canvas);
    ASSERT_FALSE(a.lost.empty());
    for (const LostPixel& lost : a.lost) {
        // Axes and eye are whole numbers here: the first stage is exact and loses nothing.
        EXPECT_NE(lost.stage, "world to camera");
        EXPECT_GT(lost.error_px, 0);
        const bool is_other = lost.got_x != lost.pixel_x || lost.got_y != lost.pixel_y;
        EXPECT_TRUE(is_other);
    }
    for (const RouteScore& score : a.routes) {
        std::uint64_t lost = 0;
        for (const OperationScore& operation : score.operations) lost += operation.pixels_lost;
        EXPECT_EQ(lost, score.other_pixel) << score.route << " " << score.numbers;
    }
    EXPECT_EQ(score_of(a, "canvas", "float32").other_pixel, 0u);  // eighths and sixty-fourths all the way
    const RouteScore& stages = score_of(a, "stages", "float32");
    EXPECT_GT(stages.other_pixel, 0u);
    for (const OperationScore& operation : stages.operations)
        EXPECT_EQ(operation.pixels_lost, operation.operation == "near x" ? stages.other_pixel : 0u);
}

TEST(BorderLattice, LiesOnBordersAndTheRouteWithoutANearPlaneKeepsAllOfThem) {
    const ViewAccuracy a = accuracy_of(border_lattice(), lattice_view(), 10'000);
    EXPECT_EQ(a.on_canvas, a.vertices);
    EXPECT_EQ(a.on_pixel_border, a.vertices);
    // No near plane: every number on the way is a multiple of a power of two.
    EXPECT_EQ(score_of(a, "canvas", "float32").other_pixel, 0u);
    EXPECT_EQ(score_of(a, "canvas", "float64").px.largest, 0);
    EXPECT_GT(score_of(a, "stages", "float32").other_pixel, 0u);
    EXPECT_GT(score_of(a, "stages", "float32").px.largest, score_of(a, "stages", "float64").px.largest);
}

TEST(Accuracy, TheCanvasIsAskedOnlyWhereThereIsOne) {
    View off_axis = front();
    off_axis.camera.window.right = 1.5;
    const ViewAccuracy a = accuracy_of(random_cloud(10), off_axis, 100);
    EXPECT_TRUE(std::ranges::none_of(a.routes, [](const RouteScore& s) { return s.route == "canvas"; }));
    EXPECT_EQ(a.routes.size(), 8u);
}

TEST(Accuracy, AVertexTooFarForFloatsIsNoNumber) {
    const ViewAccuracy a =
        accuracy_of(cloud({{0, 0, -1}, {0, 3e38f, -3e38f}, {2e38f, 0, -3e38f}}), front(), 100);
    EXPECT_EQ(a.on_canvas, 3u);
    // 2 x / (r - l) on a canvas 0.2 wide overflows nowhere, the dot product of far axes would: both stay
    // finite.
    for (const RouteScore& score : a.routes) EXPECT_EQ(score.no_number, 0u) << score.route << score.numbers;
    View beside = front();
    beside.camera.eye_world = {-3e38f, 0, 0};
    const ViewAccuracy b = accuracy_of(
        cloud({{3e38f, 0, -3e38f}, {3e38f, 0, -3.4e38f}}),
        [&] {
            beside.camera.window.right = 4;
            return beside;
        }(),
        100);
    EXPECT_EQ(b.on_canvas, 2u);
    EXPECT_EQ(score_of(b, "stages", "float32").no_number, 2u);  // 6e38 is no float
    EXPECT_EQ(score_of(b, "stages", "float64").no_number, 0u);
}

TEST(Accuracy, IsThinnedEvenlyAndTheSameForAnyNumberOfThreads) {
    const Scene scene = random_cloud(500);
    const auto rows_on = [&](int threads) {
        tbb::task_arena arena{threads};
        return arena.execute([&] { return accuracy_of(scene, front(), 100); });
    };
    const ViewAccuracy one = rows_on(1), two = rows_on(2);
    EXPECT_EQ(one.studied, 100u);
    ASSERT_EQ(one.rows.size(), two.rows.size());
    for (std::size_t i = 0; i < one.rows.size(); ++i) {
        EXPECT_EQ(one.rows[i].vertex, two.rows[i].vertex);
        for (std::size_t r = 0; r < one.routes.size(); ++r)
            EXPECT_EQ(one.rows[i].errors[r].px, two.rows[i].errors[r].px);
    }
}

}  // namespace
}  // namespace zproof::study::projection
