// What the reasons in the suite's manifest promise, scene by scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "scenes/scene_hash.h"
#include "scenes/suite.h"
#include "scenes/suite/random.h"
#include "scenes/suite/shapes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof {
namespace {

using Corners = std::array<glm::dvec3, 3>;

Corners corners(const Scene& scene, std::size_t triangle) {
    const glm::uvec3& t = scene.triangles[triangle];
    const auto& p = scene.vertices.position_world;
    return {glm::dvec3(p[t.x]), glm::dvec3(p[t.y]), glm::dvec3(p[t.z])};
}

glm::dvec3 to_camera(const Camera& camera, const glm::dvec3& p_world) {
    const glm::dvec3 p = p_world - glm::dvec3(camera.eye_world);
    return {glm::dot(p, camera.right), glm::dot(p, camera.up), glm::dot(p, camera.back)};
}

/// The raster position of a point ahead of the camera, by the formula of scenes/camera.h.
glm::dvec2 to_raster(const View& view, const glm::dvec3& p_world) {
    const Camera& camera = view.camera;
    const glm::dvec3 p = to_camera(camera, p_world);
    const double scale = camera.projection == Projection::perspective ? -p.z : 1;
    const glm::dvec2 sheared = glm::dvec2(p) + p.z * camera.shear, uv = sheared / scale;
    const Window& w = camera.window;
    const glm::dvec2 pixel{(w.right - w.left) / view.width, (w.top - w.bottom) / view.height};
    return {(uv.x - w.left) / pixel.x, (w.top - uv.y) / pixel.y};
}

/// How often each edge occurs in each direction, by vertex index.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const Scene& scene) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const glm::uvec3& t : scene.triangles) {
        ++edges[{t.x, t.y}];
        ++edges[{t.y, t.z}];
        ++edges[{t.z, t.x}];
    }
    return edges;
}

/// Edges without exactly one neighbour that runs the other way.
std::size_t open_edges(const Scene& scene) {
    const auto edges = directed_edges(scene);
    return static_cast<std::size_t>(std::ranges::count_if(edges, [&](const auto& edge) {
        const auto back = edges.find({edge.first.second, edge.first.first});
        return edge.second != 1 || back == edges.end() || back->second != 1;
    }));
}

/// The number of triangles that the camera ray through a raster position meets between near and far.
int layers_at(const Scene& scene, const View& view, const glm::dvec2& p_raster) {
    const Window& w = view.camera.window;
    const glm::dvec3 d{w.left + (w.right - w.left) * p_raster.x / view.width,
                       w.top - (w.top - w.bottom) * p_raster.y / view.height, -1};
    int layers = 0;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        Corners v = corners(scene, i);
        for (glm::dvec3& p : v) p = to_camera(view.camera, p);
        const double b0 = glm::dot(d, glm::cross(v[1], v[2])), b1 = glm::dot(d, glm::cross(v[2], v[0])),
                     b2 = glm::dot(d, glm::cross(v[0], v[1]));
        const bool within = (b0 > 0 && b1 > 0 && b2 > 0) || (b0 < 0 && b1 < 0 && b2 < 0);
        const double depth = glm::dot(v[0], glm::cross(v[1], v[2])) / (b0 + b1 + b2);
        layers += within && depth >= view.camera.near_depth && depth <= view.camera.far_depth;
    }
    return layers;
}

/// Pixels of image length along which triangles cross the given camera depth, inside the image.
double cut_length_px(const Scene& scene, const View& view, double depth) {
    double length = 0;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        std::vector<glm::dvec2> ends;
        const Corners v = corners(scene, i);
        for (std::size_t a = 0; a < 3; ++a) {
            const glm::dvec3& p = v[a];
            const glm::dvec3& q = v[(a + 1) % 3];
            const double p_over = -to_camera(view.camera, p).z - depth,
                         q_over = -to_camera(view.camera, q).z - depth;
            if ((p_over < 0) == (q_over < 0)) continue;
            ends.push_back(to_raster(view, p + (q - p) * (p_over / (p_over - q_over))));
        }
        if (ends.size() != 2) continue;
        constexpr int steps = 256;
        const glm::dvec2 step = (ends[1] - ends[0]) / static_cast<double>(steps);
        for (int s = 0; s < steps; ++s) {
            const glm::dvec2 at = ends[0] + (s + 0.5) * step;
            if (at.x > 0 && at.y > 0 && at.x < view.width && at.y < view.height) length += glm::length(step);
        }
    }
    return length;
}

TEST(UnitCircle, IsExactAtQuarterTurnsAndOnTheCircleBetween) {
    EXPECT_EQ(suite::unit_circle(0), glm::dvec2(1, 0));
    EXPECT_EQ(suite::unit_circle(0.25), glm::dvec2(0, 1));
    EXPECT_EQ(suite::unit_circle(-0.5), glm::dvec2(-1, 0));
    EXPECT_EQ(suite::unit_circle(1.75), glm::dvec2(0, -1));
    for (int i = -100; i < 100; ++i) {
        const double turns = i / 64.0 + 0.001, angle = turns * 2 * std::acos(-1.0);
        EXPECT_NEAR(suite::unit_circle(turns).x, std::cos(angle), 1e-14);
        EXPECT_NEAR(suite::unit_circle(turns).y, std::sin(angle), 1e-14);
    }
}

TEST(Random, IsSplitMix64) {
    suite::Random random(1234567);  // the reference values of Vigna's splitmix64.c for this seed
    EXPECT_EQ(random.bits(), 6457827717110365317u);
    EXPECT_EQ(random.bits(), 3203168211198807973u);
}

TEST(NearPlane, CutsTheImageByNearAndFarInBothScenes) {
    const Loaded large = generate_suite_scene("near_plane");
    EXPECT_GT(cut_length_px(large.scene, large.views[0], large.views[0].camera.near_depth), 6'000);
    EXPECT_GT(cut_length_px(large.scene, large.views[0], large.views[0].camera.far_depth), 2'000);
    const Loaded blades = generate_suite_scene("clip_blades");
    EXPECT_EQ(blades.scene.triangles.size(), 1500u);
    EXPECT_GT(cut_length_px(blades.scene, blades.views[0], blades.views[0].camera.near_depth), 50'000);
    EXPECT_GT(cut_length_px(blades.scene, blades.views[1], blades.views[1].camera.far_depth), 50'000);
}

TEST(NearPlane, HasVerticesBehindTheEyeAndTrianglesThroughEverySideOfTheFrustum) {
    const Loaded loaded = generate_suite_scene("near_plane");
    const View& view = loaded.views[0];
    const auto& positions = loaded.scene.vertices.position_world;
    EXPECT_GT(std::ranges::count_if(
                  positions, [&](const glm::vec3& p) { return to_camera(view.camera, glm::dvec3(p)).z > 0; }),
              10);
    std::array<int, 4> crossings{};
    for (std::size_t i = 0; i < loaded.scene.triangles.size(); ++i) {
        std::array<std::array<bool, 3>, 4> outside{};
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec3 p = to_camera(view.camera, corners(loaded.scene, i)[c]);
            const Window& w = view.camera.window;
            outside[0][c] = p.x < w.left * -p.z;
            outside[1][c] = p.x > w.right * -p.z;
            outside[2][c] = p.y < w.bottom * -p.z;
            outside[3][c] = p.y > w.top * -p.z;
        }
        for (std::size_t side = 0; side < 4; ++side)
            crossings[side] += std::ranges::count(outside[side], true) % 3 != 0;
    }
    for (const int count : crossings) EXPECT_GT(count, 10);
}

TEST(GuardBand, HasAPaneWhoseCornersRoundUpByAUnitRoundoffInOneOverDepth) {
    const Scene scene = generate_suite_scene("guard_band").scene;
    for (std::size_t t = scene.triangles.size() - 2; t < scene.triangles.size(); ++t)
        for (const glm::dvec3& p_world : corners(scene, t)) {
            const double inverse_depth = -1 / p_world.z,
                         error = double(float(inverse_depth)) / inverse_depth - 1;
            EXPECT_GT(error, 0.98 * 0x1p-24);
            EXPECT_LE(error, 0x1p-24);
        }
}

TEST(MillionTriangles, AreExactlyThatAndTheSameOnEveryMachine) {
    const Scene scene = generate_suite_scene("million_triangles").scene;
    EXPECT_EQ(scene.triangles.size(), 1'000'000u);
    EXPECT_EQ(sha256_of(scene), "64977e587e94ca956e4b462860040ce88d1305dc6c632ef8ea90217145bfaf19");
}

TEST(Sheet, ByRowsIsWhatItIsPointByPoint) {
    constexpr suite::Cells cells{.across = 8, .down = 4};
    const auto point = [](double s, double t) { return glm::dvec3{s / 3, -0.0, -t}; };
    suite::MeshBuilder by_points("sheet"), by_rows("sheet");
    for (suite::MeshBuilder* mesh : {&by_points, &by_rows}) {
        mesh->begin_part("before", glm::vec3(1));
        mesh->lone_triangle({glm::dvec3(0), glm::dvec3(1), glm::dvec3(2)});
        mesh->begin_part("sheet", glm::vec3(1));
    }
    suite::add_sheet(by_points, cells, point);
    suite::add_sheet_by_rows(by_rows, cells, [&](int row, std::span<glm::vec3> p_world) {
        for (std::size_t i = 0; i < p_world.size(); ++i) p_world[i] = point(double(i) / 8, double(row) / 4);
    });
    const Scene expected = by_points.finish({}).scene, made = by_rows.finish({}).scene;
    EXPECT_EQ(sha256_of(made), sha256_of(expected));
    EXPECT_EQ(made.parts.back().triangle_count, expected.parts.back().triangle_count);
}

TEST(DeepOverdraw, IsTwentyDeepOnAverageAndNowhereThin) {
    const Loaded loaded = generate_suite_scene("deep_overdraw");
    EXPECT_EQ(loaded.scene.triangles.size(), 200'000u);
    suite::Random random(99);
    int total = 0, thinnest = 1'000'000;
    constexpr int samples = 60;
    for (int i = 0; i < samples; ++i) {
        const double x = random.uniform(0, 1920), y = random.uniform(0, 1080);
        const int layers = layers_at(loaded.scene, loaded.views[0], {x, y});
        total += layers;
        thinnest = std::min(thinnest, layers);
    }
    EXPECT_GT(total, 20 * samples);
    EXPECT_GT(thinnest, 5);
}

TEST(Slivers, AreManyAndThin) {
    const Loaded loaded = generate_suite_scene("slivers");
    int thin = 0, thinner_than_a_sub_pixel = 0;
    for (std::size_t i = 0; i < loaded.scene.triangles.size(); ++i) {
        const Corners v = corners(loaded.scene, i);
        const double longest =
            std::max({glm::distance(v[0], v[1]), glm::distance(v[1], v[2]), glm::distance(v[2], v[0])});
        const double width = glm::length(glm::cross(v[1] - v[0], v[2] - v[0])) / longest;
        thin += width < longest / 100;
        thinner_than_a_sub_pixel += width < longest / 20'000;
    }
    EXPECT_GT(thin, 15'000);
    EXPECT_GT(thinner_than_a_sub_pixel, 1'000);
}

TEST(Degenerate, HasEveryKindOfFlaw) {
    const Scene scene = generate_suite_scene("degenerate").scene;
    int repeated_index = 0, repeated_position = 0, no_area = 0, sub_pixel = 0;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const glm::uvec3& t = scene.triangles[i];
        const Corners v = corners(scene, i);
        const bool same_index = t.x == t.y || t.y == t.z || t.z == t.x;
        const bool same_position = v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
        const double extent = std::max(glm::distance(v[0], v[1]), glm::distance(v[0], v[2]));
        repeated_index += same_index;
        repeated_position += !same_index && same_position;
        no_area += !same_position && glm::cross(v[1] - v[0], v[2] - v[0]) == glm::dvec3(0);
        sub_pixel += extent > 0 && extent < -v[0].z / 1080;
    }
    EXPECT_EQ(repeated_index, 6000);
    EXPECT_GE(repeated_position, 12'000);
    EXPECT_GE(no_area, 5000);
    EXPECT_GE(sub_pixel, 11'000);
}

TEST(FanAtPixelCentre, MeetsExactlyThereAtEverySizeInBothProjections) {
    for (const auto& [width, height] : {std::pair{1920, 1080}, {1280, 720}, {641, 359}, {97, 64}}) {
        SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
        const Loaded loaded = generate_suite_scene("fan_at_pixel_centre", width, height);
        ASSERT_EQ(loaded.views.size(), 2u);
        const std::uint32_t hub = loaded.scene.triangles[0].x;
        EXPECT_EQ(
            std::ranges::count_if(loaded.scene.triangles, [&](const glm::uvec3& t) { return t.x == hub; }),
            128);
        for (const View& view : loaded.views)
            for (std::uint32_t v = hub; v <= hub + 128; ++v) {  // the hub and the rim: all at pixel centres
                const glm::dvec2 at = to_raster(view, glm::dvec3(loaded.scene.vertices.position_world[v]));
                ASSERT_EQ(at, glm::floor(at) + 0.5) << view.name << ", vertex " << v;
                if (v == hub) {
                    EXPECT_EQ(at, glm::dvec2(width / 2, height / 2) + 0.5);
                }
            }
    }
}

TEST(FanAtPixelCentre, CoversTheImageOnce) {
    const Loaded loaded = generate_suite_scene("fan_at_pixel_centre", 97, 64);
    for (const View& view : loaded.views)
        for (const glm::dvec2& corner :
             {glm::dvec2{0.1, 0.2}, {96.9, 0.3}, {0.2, 63.7}, {96.8, 63.9}, {33.3, 21.7}}) {
            if (view.camera.projection != Projection::perspective) continue;
            EXPECT_EQ(layers_at(loaded.scene, view, corner), 1);
        }
}

TEST(SharedEdges, AreSharedByIndexAndEndAtPixelCentres) {
    const Loaded loaded = generate_suite_scene("shared_edges");
    const View& view = loaded.views[0];
    int interior = 0, open = 0;
    const auto edges = directed_edges(loaded.scene);
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        const bool shared = edges.contains({edge.second, edge.first});
        interior += shared;
        if (shared) continue;
        ++open;
        const glm::dvec2 at = to_raster(view, glm::dvec3(loaded.scene.vertices.position_world[edge.first]));
        EXPECT_TRUE(at.x < 0 || at.y < 0 || at.x > view.width || at.y > view.height)
            << "an open edge within the image";
    }
    EXPECT_GT(interior, 50'000);
    EXPECT_GT(open, 0);
    const auto& positions = loaded.scene.vertices.position_world;
    const auto on_centre = std::ranges::count_if(positions, [&](const glm::vec3& p) {
        const glm::dvec2 at = to_raster(view, glm::dvec3(p));
        return at == glm::floor(at) + 0.5;
    });
    EXPECT_GT(on_centre, 8'000);
}

TEST(Coplanar, HasManyFacesInTheSamePlane) {
    const Scene scene = generate_suite_scene("coplanar").scene;
    int in_wall = 0;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i)
        in_wall += std::ranges::all_of(corners(scene, i), [](const glm::dvec3& p) { return p.z == -16; });
    EXPECT_EQ(in_wall, 74);
}

TEST(Cracks, AreClosedInExactArithmetic) {
    const Scene strips = generate_suite_scene("abutting_strips").scene;
    const Scene wall = generate_suite_scene("t_junctions").scene;
    const auto backdrop = [](const glm::vec3& p) { return p.z == -30; };
    for (const glm::vec3& p : strips.vertices.position_world) {
        if (backdrop(p)) continue;
        const glm::dvec3 q(p);  // every vertex lies on its line and in the plane, without rounding
        const double line = (q.y - q.x * 5 / 64) * 16;
        ASSERT_EQ(line, std::floor(line));
        ASSERT_EQ(q.z, q.x / 8 + q.y / 16);
    }
    for (const glm::vec3& p : wall.vertices.position_world) {
        if (backdrop(p)) continue;
        const glm::dvec3 q(p);
        ASSERT_EQ(q.x * 8, std::floor(q.x * 8));
        ASSERT_EQ(q.y * 8, std::floor(q.y * 8));
        ASSERT_EQ(q.z, (3 * q.x - 5 * q.y) / 16);
    }
}

TEST(Cracks, AreManyBecauseNeighboursShareNoVertex) {
    const Loaded loaded = generate_suite_scene("abutting_strips");
    const auto edges = directed_edges(loaded.scene);
    double open_px = 0;
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        if (edges.contains({edge.second, edge.first})) continue;
        const auto& p = loaded.scene.vertices.position_world;
        if (p[edge.first].z == -30) continue;
        const glm::dvec2 a = to_raster(loaded.views[0], glm::dvec3(p[edge.first]));
        const glm::dvec2 b = to_raster(loaded.views[0], glm::dvec3(p[edge.second]));
        const bool seen = a.x > 0 && a.x < 1920 && a.y > 0 && a.y < 1080;
        open_px += seen ? glm::distance(a, b) : 0;
    }
    EXPECT_GT(open_px, 2 * 500'000);  // each line is the edge of two strips
}

TEST(TJunctions, AreManyBecauseNeighboursDifferInSize) {
    const Scene scene = generate_suite_scene("t_junctions").scene;
    EXPECT_GT(open_edges(scene), 2'000u);
    std::map<double, int> sizes;
    for (std::size_t i = 0; i < scene.triangles.size(); i += 2)
        ++sizes[corners(scene, i)[1].x - corners(scene, i)[0].x];
    EXPECT_EQ(sizes.size(), 5u) << "2, 4, 8 and 16 eighths, and the backdrop";
}

TEST(FarFromOrigin, LiesBetweenAHundredThousandAndAMillionUnitsAway) {
    for (const glm::vec3& p : generate_suite_scene("far_from_origin").scene.vertices.position_world) {
        ASSERT_GT(glm::length(glm::dvec3(p)), 1e5);
        ASSERT_LT(glm::length(glm::dvec3(p)), 1e6);
    }
}

TEST(DepthRange, IsTenMillionAndHasSomethingInEveryBinade) {
    const Loaded loaded = generate_suite_scene("depth_range");
    std::map<int, int> binades;
    for (const View& view : loaded.views) EXPECT_EQ(view.camera.far_depth / view.camera.near_depth, 1e7);
    for (const glm::vec3& p : loaded.scene.vertices.position_world) ++binades[std::ilogb(p.z)];
    for (int exponent = -6; exponent <= 16; ++exponent) EXPECT_GT(binades[exponent], 100) << exponent;
}

TEST(BackFaces, TurnBothWays) {
    const Loaded loaded = generate_suite_scene("back_faces");
    std::array<int, 2> count{};
    for (std::size_t i = 0; i < loaded.scene.triangles.size(); ++i) {
        const Corners v = corners(loaded.scene, i);
        const glm::dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
        ++count[glm::dot(normal, v[0] - glm::dvec3(loaded.views[0].camera.eye_world)) > 0];
    }
    EXPECT_GT(count[0], 8'000);
    EXPECT_GT(count[1], 8'000);
}

TEST(ClosedSurfaces, AreClosed) { EXPECT_EQ(open_edges(generate_suite_scene("closed_surfaces").scene), 0u); }

TEST(ClosedSurfaces, FaceOutwards) {
    const Scene scene = generate_suite_scene("closed_surfaces").scene;
    for (const Part& part : scene.parts) {
        double six_volumes = 0;
        for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
            const Corners v = corners(scene, part.first_triangle + i);
            six_volumes += glm::dot(v[0], glm::cross(v[1], v[2]));
        }
        EXPECT_GT(six_volumes, 0) << part.node;
    }
}

TEST(Room, IsClosedAroundItsCamerasAndHasAboutTwelveThousandTriangles) {
    const Loaded loaded = generate_suite_scene("room");
    EXPECT_EQ(open_edges(loaded.scene), 0u);
    EXPECT_GT(loaded.scene.triangles.size(), 11'000u);
    EXPECT_LT(loaded.scene.triangles.size(), 13'000u);
    suite::Random random(77);
    for (const View& view : loaded.views)
        for (int i = 0; i < 50; ++i) {
            const double x = random.uniform(0, 1920), y = random.uniform(0, 1080);
            EXPECT_GE(layers_at(loaded.scene, view, {x, y}), 1);
        }
}

TEST(OffAxis, HasAWindowThatTheAxisDoesNotPass) {
    int beside = 0;
    for (const View& view : generate_suite_scene("off_axis").views) {
        EXPECT_NE(view.camera.window.left, -view.camera.window.right);
        beside += view.camera.window.left > 0 && view.camera.window.top < 0;
    }
    EXPECT_EQ(beside, 1);
}

TEST(ParallelScenes, AreParallelAndOnlyTheObliqueOneIsSheared) {
    for (const View& view : generate_suite_scene("orthographic").views) {
        EXPECT_EQ(view.camera.projection, Projection::parallel);
        EXPECT_EQ(view.camera.shear, glm::dvec2(0));
    }
    for (const View& view : generate_suite_scene("oblique").views) {
        EXPECT_EQ(view.camera.projection, Projection::parallel);
        EXPECT_GT(glm::length(view.camera.shear), 0.4);
    }
}

TEST(TexturedGround, HasAnImageAndCoordinatesThatRepeatEveryFourUnits) {
    const Scene scene = generate_suite_scene("textured_ground").scene;
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].texels.size(), 4u * 256 * 256);
    EXPECT_EQ(scene.materials[static_cast<std::size_t>(scene.parts[0].material)].base_color.image, 0);
    ASSERT_EQ(scene.vertices.uv.size(), 1u);
    for (std::size_t i = 0; i < scene.vertices.position_world.size(); ++i)
        ASSERT_EQ(scene.vertices.uv[0][i].x * 4, scene.vertices.position_world[i].x);
}

}  // namespace
}  // namespace zproof
