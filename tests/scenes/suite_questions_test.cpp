// What the reasons of the suite's scenes of odd sizes, planes, cuts, indices and stacks promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "scenes/suite.h"

namespace zproof {
namespace {

using Corners = std::array<glm::dvec3, 3>;

Corners corners_in_camera(const Loaded& loaded, const View& view, std::size_t triangle) {
    Corners corners;
    for (int c = 0; c < 3; ++c) {
        const glm::dvec3 p =
            glm::dvec3(loaded.scene.vertices.position_world[loaded.scene.triangles[triangle][c]]) -
            glm::dvec3(view.camera.eye_world);
        corners[std::size_t(c)] = {glm::dot(p, view.camera.right), glm::dot(p, view.camera.up),
                                   glm::dot(p, view.camera.back)};
    }
    return corners;
}

const View& view_of(const Loaded& loaded, const std::string& name) {
    return *std::ranges::find(loaded.views, name, &View::name);
}

/// The six half spaces of the view's frustum: above 0 inside. No shear.
std::vector<std::function<double(const glm::dvec3&)>> frustum_of(const View& view) {
    const Camera& c = view.camera;
    const bool perspective = c.projection == Projection::perspective;
    const auto scale = [perspective](const glm::dvec3& p) { return perspective ? -p.z : 1; };
    return {[&c](const glm::dvec3& p) { return -p.z - c.near_depth; },
            [&c](const glm::dvec3& p) { return c.far_depth + p.z; },
            [&c, scale](const glm::dvec3& p) { return p.x - c.window.left * scale(p); },
            [&c, scale](const glm::dvec3& p) { return c.window.right * scale(p) - p.x; },
            [&c, scale](const glm::dvec3& p) { return p.y - c.window.bottom * scale(p); },
            [&c, scale](const glm::dvec3& p) { return c.window.top * scale(p) - p.y; }};
}

/// What of a triangle lies in the frustum, and how many planes it took a piece.
struct Piece {
    std::vector<glm::dvec3> corners;
    int planes = 0;
};

/// Sutherland and Hodgman 1974.
Piece piece_in_frustum(const Corners& triangle, const View& view) {
    Piece piece{{triangle.begin(), triangle.end()}};
    for (const auto& inside : frustum_of(view)) {
        std::vector<glm::dvec3> kept;
        bool cut = false;
        for (std::size_t i = 0; i < piece.corners.size(); ++i) {
            const glm::dvec3 &p = piece.corners[i], &q = piece.corners[(i + 1) % piece.corners.size()];
            const double at_p = inside(p), at_q = inside(q);
            cut = cut || at_p < 0;
            if (at_p >= 0) kept.push_back(p);
            if ((at_p < 0) != (at_q < 0)) kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        }
        piece.planes += cut && !kept.empty();
        piece.corners = kept;
    }
    return piece;
}

/// Raster position of a point of a centred view along the axis.
glm::dvec2 to_raster(const View& view, const glm::dvec3& p) {
    const Window& w = view.camera.window;
    const double scale = view.camera.projection == Projection::perspective ? -p.z : 1;
    return {(p.x / scale - w.left) / (w.right - w.left) * view.width,
            (w.top - p.y / scale) / (w.top - w.bottom) * view.height};
}

/// Square pixels.
double area_px(const std::vector<glm::dvec2>& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        twice += p.x * q.y - q.x * p.y;
    }
    return std::abs(twice) / 2;
}

TEST(PictureSizes, AreOddNarrowAndLongWithPixelsThatAreNotSquare) {
    const Loaded loaded = generate_suite_scene("picture_sizes", 640, 360);
    std::set<std::pair<int, int>> sizes;
    std::array<int, 3> shapes{};
    for (const View& view : loaded.views) {
        sizes.insert({view.width, view.height});
        const Window& w = view.camera.window;
        const double stretch = (w.right - w.left) / view.width * view.height / (w.top - w.bottom);
        ++shapes[stretch > 1.1 ? 2 : stretch < 0.9 ? 0 : 1];
    }
    EXPECT_TRUE(sizes.contains({1, 1}));
    for (const auto& is_there : {std::function<bool(int, int)>([](int w, int h) { return w == 1 && h > 64; }),
                                 {[](int w, int h) { return h == 1 && w > 64; }},
                                 {[](int w, int h) { return w > 8192 && h > 1; }},
                                 {[](int w, int h) { return h > 8192 && w > 1; }},
                                 {[](int w, int h) { return w % 2 == 1 && h % 2 == 1 && w > 16 && h > 64; }},
                                 {[](int w, int h) { return w % 64 == 2 && h % 64 == 2; }}})
        EXPECT_TRUE(
            std::ranges::any_of(sizes, [&](const auto& size) { return is_there(size.first, size.second); }));
    EXPECT_EQ(shapes[0], 1);
    EXPECT_EQ(shapes[2], 1);
}

TEST(FarAtInfinity, HasSheetsInEveryBinadeToAHundredMillionTimesNear) {
    const Loaded loaded = generate_suite_scene("far_at_infinity");
    std::set<int> binades;
    for (const View& view : loaded.views)
        EXPECT_EQ(view.camera.far_depth, std::numeric_limits<double>::infinity());
    for (const glm::vec3& p : loaded.scene.vertices.position_world)
        binades.insert(std::ilogb(-p.z / loaded.views[0].camera.near_depth));
    for (int binade = 1; binade < 27; ++binade) EXPECT_TRUE(binades.contains(binade)) << binade;
}

TEST(ParallelPlanes, LieBehindTheEyeAndHaveSquaresExactlyInThem) {
    const Loaded loaded = generate_suite_scene("parallel_planes");
    EXPECT_LT(view_of(loaded, "around-the-eye").camera.near_depth, 0);
    EXPECT_LT(view_of(loaded, "behind-the-eye").camera.far_depth, 0);
    const Camera& short_of_far = view_of(loaded, "short-of-far").camera;
    EXPECT_GT(short_of_far.near_depth, 0);
    EXPECT_LT(short_of_far.far_depth - short_of_far.near_depth, short_of_far.far_depth - 10);
    EXPECT_NE(view_of(loaded, "oblique").camera.shear, glm::dvec2(0));
    for (const View& view : loaded.views)
        for (const double plane : {view.camera.near_depth, view.camera.far_depth}) {
            int in_the_plane = 0, before = 0, behind = 0;
            for (std::size_t i = 0; i < loaded.scene.triangles.size(); ++i) {
                const Corners corners = corners_in_camera(loaded, view, i);
                in_the_plane += std::ranges::all_of(corners, [&](const auto& p) { return -p.z == plane; });
                before += std::ranges::any_of(corners, [&](const auto& p) { return -p.z < plane; });
                behind += std::ranges::any_of(corners, [&](const auto& p) { return -p.z > plane; });
            }
            EXPECT_EQ(in_the_plane, 2) << view.name << " at " << plane;
            EXPECT_GT(before, 5) << view.name << " at " << plane;
            EXPECT_GT(behind, 5) << view.name << " at " << plane;
        }
}

TEST(FrustumCuts, LeaveUpToNineCornersOfTrianglesThatThreeToSixPlanesCut) {
    const Loaded loaded = generate_suite_scene("frustum_cuts");
    ASSERT_EQ(loaded.views.size(), 2u);
    for (const View& view : loaded.views) {
        std::array<int, 7> by_planes{};
        std::array<int, 10> by_corners{};
        for (std::size_t i = 0; i < loaded.scene.triangles.size(); ++i) {
            const Piece piece = piece_in_frustum(corners_in_camera(loaded, view, i), view);
            if (piece.corners.empty()) continue;
            ++by_planes[std::size_t(piece.planes)];
            ++by_corners[piece.corners.size()];
        }
        for (const std::size_t planes : {3u, 4u, 5u, 6u})
            EXPECT_GT(by_planes[planes], 1) << view.name << planes;
        for (const std::size_t corners : {5u, 6u, 7u})
            EXPECT_GT(by_corners[corners], 1) << view.name << corners;
        EXPECT_GE(by_corners[9], 8) << view.name;
    }
}

TEST(FrustumCuts, PassThroughCornersThatLieExactlyInAPlane) {
    const Loaded loaded = generate_suite_scene("frustum_cuts");
    for (const View& view : loaded.views) {
        const auto planes = frustum_of(view);
        for (const std::size_t plane : {0u, 5u}) {
            int cut_through_a_corner = 0;
            for (std::size_t i = 0; i < loaded.scene.triangles.size(); ++i) {
                std::array<double, 3> inside{};
                std::ranges::transform(corners_in_camera(loaded, view, i), inside.begin(), planes[plane]);
                std::ranges::sort(inside);
                cut_through_a_corner += inside[0] < 0 && inside[1] == 0 && inside[2] > 0;
            }
            EXPECT_EQ(cut_through_a_corner, 7) << view.name << plane;
        }
    }
}

TEST(ClippedTips, AreOfTwoPixelsAtEverySize) {
    for (const auto& [width, height] : {std::pair{1920, 1080}, {641, 359}}) {
        const Loaded loaded = generate_suite_scene("clipped_tips", width, height);
        const View& view = loaded.views[0];
        int tips = 0;
        for (std::size_t i = 0; i + 1 < loaded.scene.triangles.size(); ++i) {
            const Piece piece = piece_in_frustum(corners_in_camera(loaded, view, i), view);
            ASSERT_GT(piece.planes, 0);
            std::vector<glm::dvec2> polygon;
            for (const glm::dvec3& p : piece.corners) polygon.push_back(to_raster(view, p));
            const double area = area_px(polygon);
            tips += area > 1 && area < 2;
        }
        EXPECT_EQ(tips, int(loaded.scene.triangles.size()) - 1);
    }
}

std::vector<std::uint32_t> ids_with_area(const Scene& scene) {
    std::vector<std::uint32_t> ids;
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i)
        if (scene.triangles[i].x != scene.triangles[i].y) ids.push_back(i);
    return ids;
}

TEST(HighIds, ShowEveryBitAndWhatLiesAroundIt) {
    for (const auto& [name, first, last] :
         {std::tuple{"high_ids", 16, 20}, std::tuple{"ids_beyond_float", 20, 24}}) {
        const Loaded loaded = generate_suite_scene(name);
        const std::vector<std::uint32_t> ids = ids_with_area(loaded.scene);
        EXPECT_GT(loaded.scene.triangles.size(), std::size_t{1} << last);
        for (int bit = first; bit <= last; ++bit)
            for (const std::uint32_t id : {(1u << bit) - 1, 1u << bit, (1u << bit) + 1})
                EXPECT_TRUE(std::ranges::binary_search(ids, id)) << name << " " << id;
        EXPECT_GT(
            std::ranges::count_if(ids, [&](std::uint32_t id) { return id >> last == 1 && id % 2 == 1; }), 10);
        for (const std::uint32_t id : ids)
            for (const glm::dvec3& p : corners_in_camera(loaded, loaded.views[0], id)) {
                const glm::dvec2 at = to_raster(loaded.views[0], p);
                ASSERT_TRUE(at.x > 0 && at.y > 0 && at.x < loaded.views[0].width &&
                            at.y < loaded.views[0].height);
            }
    }
}

TEST(FarIndices, JumpByExactly65536FromOneCellToTheNext) {
    const Scene scene = generate_suite_scene("far_indices").scene;
    std::size_t jumps = 0;
    for (std::size_t i = 2; i < scene.triangles.size(); i += 2)
        jumps += scene.triangles[i].x == scene.triangles[i - 2].x + 0x10000;
    EXPECT_GT(jumps, scene.triangles.size() / 3);
}

TEST(ManyPrimitives, AreMoreThan256AndOfSeveralSizes) {
    const Scene scene = generate_suite_scene("many_primitives").scene;
    std::set<std::uint32_t> sizes;
    for (const Part& part : scene.parts) sizes.insert(part.triangle_count);
    EXPECT_EQ(scene.parts.size(), 336u);
    EXPECT_GE(sizes.size(), 4u);
}

TEST(OneBox, IsThatOfTwoHundredTrianglesThatShareAnEdge) {
    const Loaded loaded = generate_suite_scene("one_box");
    std::size_t alike = 0;
    for (std::size_t i = 0; i < loaded.scene.parts[0].triangle_count; ++i) {
        const auto& p = loaded.scene.vertices.position_world;
        const glm::uvec3& t = loaded.scene.triangles[i];
        EXPECT_EQ(glm::uvec2(t), glm::uvec2(loaded.scene.triangles[0]));
        alike += glm::min(p[t.x], glm::min(p[t.y], p[t.z])) == glm::vec3{-1, -1, -0.5} &&
                 glm::max(p[t.x], glm::max(p[t.y], p[t.z])) == glm::vec3{1, 1, 0.5};
    }
    EXPECT_EQ(alike, 200u);
    EXPECT_EQ(loaded.scene.parts.back().triangle_count, 1000u);
    EXPECT_EQ(loaded.scene.triangles.back(), loaded.scene.triangles[loaded.scene.triangles.size() - 1000]);
}

TEST(OneTile, HoldsAHundredThousandTrianglesTheLastOnesInFront) {
    for (const auto& [width, height] : {std::pair{1920, 1080}, {641, 359}}) {
        const Loaded loaded = generate_suite_scene("one_tile", width, height);
        const View& view = loaded.views[0];
        const Part& pile = loaded.scene.parts[0];
        EXPECT_EQ(pile.triangle_count, 100'000u);
        const glm::dvec2 first = glm::floor(to_raster(view, corners_in_camera(loaded, view, 0)[0]) / 16.0);
        double last_z = -1;
        for (std::size_t i = 0; i < pile.triangle_count; ++i)
            for (const glm::dvec3& p : corners_in_camera(loaded, view, i)) {
                const glm::dvec2 at = to_raster(view, p) - 16.0 * first;
                ASSERT_TRUE(at.x >= 0 && at.y >= 0 && at.x <= 16 && at.y <= 16) << i;
                ASSERT_GE(p.z + 1024, last_z);
                last_z = p.z + 1024;
            }
    }
}

TEST(BesidePixelCentres, LieSharedEdgesCloserThanABillionthOfAPixelSquared) {
    const Scene scene = generate_suite_scene("beside_pixel_centres", 480, 270).scene;
    ASSERT_EQ(scene.triangles.size(), 1600u);
    const auto cross = [](const glm::dvec2& p, const glm::dvec2& q) { return p.x * q.y - p.y * q.x; };
    int outside_of_the_first = 0;
    for (std::size_t i = 0; i < 800; ++i) {  // world units are pixels
        const glm::dvec2 centre{-119.5 + 6 * double(i % 40), 59.5 - 6 * double(i / 40)};
        const glm::uvec3 first = scene.triangles[2 * i], second = scene.triangles[2 * i + 1];
        const auto corner = [&](std::uint32_t vertex) {
            return glm::dvec2(scene.vertices.position_world[vertex]) - centre;
        };
        EXPECT_EQ(glm::uvec2(first), glm::uvec2(second));
        const glm::dvec2 a = corner(first.x), b = corner(first.y);
        EXPECT_EQ(cross(a, b), 0x1p-30);
        EXPECT_LT(glm::dot(a, b), 0);
        const double of_first = cross(b - a, corner(first.z) - a),
                     of_second = cross(b - a, corner(second.z) - a);
        EXPECT_LT(of_first * of_second, 0);
        outside_of_the_first += of_first < 0;
    }
    EXPECT_GT(outside_of_the_first, 300);
    EXPECT_LT(outside_of_the_first, 500);
}

TEST(OddCameras, HaveTheFieldsOfViewPlanesAndAxesThatTheReasonNames) {
    const Loaded loaded = generate_suite_scene("odd_cameras");
    const auto degrees = [&](const char* name) {
        return 2 * std::atan(view_of(loaded, name).camera.window.top) * 180 / std::acos(-1.0);
    };
    EXPECT_NEAR(degrees("narrow"), 0.1, 1e-4);
    EXPECT_NEAR(degrees("wide"), 179, 1e-3);
    const Camera& close = view_of(loaded, "close").camera;
    EXPECT_DOUBLE_EQ(close.far_depth / close.near_depth, 1e9);
    const Camera& skewed = view_of(loaded, "skewed").camera;
    EXPECT_GT(std::abs(glm::dot(skewed.right, skewed.up)), 1e-13);
    EXPECT_NO_THROW(validate(skewed));
    EXPECT_GT(view_of(loaded, "beside").camera.window.left, 1);
}

}  // namespace
}  // namespace zproof
