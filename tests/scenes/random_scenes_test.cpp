// What holds for every random scene, and what each kind is there for.
#include "scenes/random_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "math/sha256.h"
#include "scenes/judged_ranges.h"
#include "scenes/scene_error.h"
#include "scenes/scene_hash.h"
#include "scenes/view_document.h"

namespace zproof {
namespace {

constexpr std::uint64_t seed = 1;

std::vector<Loaded> some_of(std::string_view kind, std::uint64_t count) {
    std::vector<Loaded> scenes;
    for (std::uint64_t number = 0; number < count; ++number)
        scenes.push_back(generate(random_scene(kind, seed, number)));
    return scenes;
}

glm::dvec3 corner_of(const Scene& scene, std::size_t triangle, int corner) {
    return glm::dvec3(scene.vertices.position_world[scene.triangles[triangle][corner]]);
}

/// x and y in pixels, z the camera depth.
glm::dvec3 seen_at(const View& view, const glm::dvec3& p_world) {
    const Camera& c = view.camera;
    const glm::dvec3 from_eye = p_world - glm::dvec3(c.eye_world);
    const double depth = -glm::dot(from_eye, c.back);
    glm::dvec2 at(glm::dot(from_eye, c.right), glm::dot(from_eye, c.up));
    at = c.projection == Projection::perspective ? at / depth : at - depth * c.shear;
    const Window& w = c.window;
    return {(at.x - w.left) / (w.right - w.left) * view.width,
            (w.top - at.y) / (w.top - w.bottom) * view.height, depth};
}

using Corners = std::array<glm::dvec3, 3>;
using Asks = std::function<bool(const View&, const Corners& seen)>;

/// In how many of some scenes of the kind a triangle, as it is seen, is what is asked for.
int scenes_with(std::string_view kind, const Asks& asks) {
    const std::vector<Loaded> scenes = some_of(kind, 40);
    return int(std::ranges::count_if(scenes, [&](const Loaded& of) {
        for (std::size_t t = 0; t < of.scene.triangles.size(); ++t) {
            Corners seen;
            for (int i = 0; i < 3; ++i)
                seen[std::size_t(i)] = seen_at(of.views[0], corner_of(of.scene, t, i));
            if (asks(of.views[0], seen)) return true;
        }
        return false;
    }));
}

double area_of(const Corners& seen) {
    const glm::dvec2 a(seen[1] - seen[0]), b(seen[2] - seen[0]);
    return std::abs(a.x * b.y - a.y * b.x) / 2;
}

double longest_of(const Corners& seen) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, glm::length(glm::dvec2(seen[i] - seen[(i + 1) % 3])));
    return longest;
}

TEST(RandomScenes, AreSmallAndJudgedWhateverTheKind) {
    for (const RandomKind& kind : random_kinds())
        for (std::uint64_t number = 0; number < 200; ++number) {
            const RandomScene scene = random_scene(kind.name, seed, number);
            SCOPED_TRACE(word_of(scene));
            const auto [made, views] = generate(scene);
            EXPECT_EQ(made.name, word_of(scene));
            EXPECT_GE(made.triangles.size(), 1u);
            EXPECT_LE(made.triangles.size(), std::size_t(most_random_triangles));
            EXPECT_EQ(outside_judged_ranges(made), "");
            ASSERT_EQ(views.size(), 1u);
            EXPECT_NO_THROW(validate(views[0].camera));
            EXPECT_EQ(outside_judged_ranges(views[0]), "");
            EXPECT_GE(std::min(views[0].width, views[0].height), 1);
            EXPECT_LE(std::max(views[0].width, views[0].height), largest_random_side);
        }
}

/// Their bits, and those of their views.
std::string hash_of(std::uint64_t of_seed, std::uint64_t count) {
    std::string text;
    for (std::uint64_t number = 0; number < count; ++number) {
        const Loaded made = generate(random_scene(any_random_kind, of_seed, number));
        text += sha256_of(made.scene) + view_document("", made.views) + "\n";
    }
    return sha256_of(text);
}

TEST(RandomScenes, AreTheSameOnEveryMachine) {
    EXPECT_EQ(hash_of(1, 120), "b86a50dc6a546426619a820570972f13036c2704af387b8d14bf05b2c920dd32");
    EXPECT_NE(hash_of(2, 12), hash_of(1, 12));
}

TEST(RandomScenes, AreMeantByTheirWordAndAnyTakesTurns) {
    const std::size_t kinds = random_kinds().size();
    std::set<std::string> turns;
    for (std::uint64_t number = 0; number < kinds; ++number) {
        const RandomScene scene = random_scene_from("random:any:7:" + std::to_string(number)).value();
        turns.insert(scene.kind);
        EXPECT_EQ(word_of(random_scene_from(word_of(scene)).value()), word_of(scene));
    }
    EXPECT_EQ(turns.size(), kinds);
    EXPECT_FALSE(random_scene_from("room"));
    EXPECT_FALSE(random_scene_from("random"));
    for (const char* word :
         {"random:", "random:soup", "random:soup:1", "random:soup:1:", "random:soup:-1:2",
          "random:soup:1:2:3", "random:fog:1:2", "random:soup:1:2x", "random:soup:99999999999999999999:1"})
        EXPECT_THROW(random_scene_from(word), SceneError) << word;
    EXPECT_THROW(generate({.kind = "any"}), SceneError);
}

TEST(RandomViews, AskWhatTheSuiteDoesNot) {
    std::map<std::string, int> met;
    for (const Loaded& of : some_of(any_random_kind, 1200)) {
        const View& view = of.views[0];
        const Camera& c = view.camera;
        const Window& w = c.window;
        const bool perspective = c.projection == Projection::perspective;
        const double across = (w.right - w.left) / view.width, down = (w.top - w.bottom) / view.height;
        met["perspective"] += perspective;
        met["orthographic"] += !perspective && c.shear == glm::dvec2(0);
        met["oblique"] += !perspective && c.shear != glm::dvec2(0);
        met["near behind the eye"] += c.near_depth < 0;
        met["no far plane"] += std::isinf(c.far_depth);
        met["far / near above 10^7"] += perspective && c.far_depth > 1e7 * c.near_depth;
        met["near below 10^-5"] += perspective && c.near_depth < 1e-5;
        met["an eye far away"] += glm::length(glm::dvec3(c.eye_world)) > 9e5;
        met["rolled"] += c.up.y < 0.99 && c.right.y != 0;
        met["a narrow field"] += perspective && w.top - w.bottom < 1e-3;
        met["a wide field"] += perspective && w.top > 50;
        met["beside the axis"] += w.left > 0 || w.right < 0;
        met["pixels that are not square"] += std::abs(across / down - 1) > 0.1;
        met["one pixel wide"] += view.width == 1;
        met["one pixel high"] += view.height == 1;
        met["large"] += view.width == largest_random_side;
    }
    for (const auto& [what, count] : met) EXPECT_GE(count, 5) << what;
}

TEST(RandomKinds, ClippedTrianglesHaveCornersBeyondEveryPlane) {
    const auto is_behind = [](const Corners& seen) {
        return std::ranges::any_of(seen, [](const glm::dvec3& p) { return p.z <= 0; });
    };
    EXPECT_GT(scenes_with("clipped", [&](const View&, const Corners& seen) { return is_behind(seen); }), 10);
    EXPECT_GT(scenes_with("clipped",
                          [](const View& view, const Corners& seen) {
                              return std::ranges::any_of(
                                  seen, [&](const glm::dvec3& p) { return p.z > view.camera.far_depth; });
                          }),
              10);
    EXPECT_GT(scenes_with("clipped",
                          [&](const View& view, const Corners& seen) {
                              return !is_behind(seen) && longest_of(seen) > 4 * view.width;
                          }),
              10);
}

TEST(RandomKinds, AlignedCornersLieExactlyAtPixelCentres) {
    const auto is_centre = [](double at) { return at - std::floor(at) == 0.5; };
    EXPECT_GT(scenes_with("aligned",
                          [&](const View&, const Corners& seen) {
                              return std::ranges::all_of(seen, [&](const glm::dvec3& p) {
                                  return is_centre(p.x) && is_centre(p.y);
                              });
                          }),
              10);
}

TEST(RandomKinds, TinySliversAndDegenerateTrianglesAreSmallThinAndWithoutArea) {
    EXPECT_EQ(scenes_with("tiny", [](const View&, const Corners& seen) { return longest_of(seen) < 4; }), 40);
    EXPECT_GT(scenes_with("slivers",
                          [](const View&, const Corners& seen) {
                              return longest_of(seen) > 4 && area_of(seen) < 0.25 * longest_of(seen);
                          }),
              35);
    EXPECT_GT(scenes_with("degenerate", [](const View&, const Corners& seen) { return area_of(seen) == 0; }),
              20);
}

/// How many of some scenes of the kind are as asked.
int count_of(std::string_view kind, const std::function<bool(const Scene&)>& asks) {
    const std::vector<Loaded> scenes = some_of(kind, 40);
    return int(std::ranges::count_if(scenes, [&](const Loaded& of) { return asks(of.scene); }));
}

/// Do all lie in the plane of the first, exactly?
bool is_one_plane(const Scene& scene) {
    const glm::dvec3 p = corner_of(scene, 0, 0);
    const glm::dvec3 normal = glm::cross(corner_of(scene, 0, 1) - p, corner_of(scene, 0, 2) - p);
    for (std::size_t t = 0; t < scene.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i)
            if (glm::dot(normal, corner_of(scene, t, i) - p) != 0) return false;
    return true;
}

TEST(RandomKinds, CoplanarTrianglesShareAPlaneExactly) {
    EXPECT_GT(count_of("coplanar", [](const Scene& s) { return s.triangles.size() > 3 && is_one_plane(s); }),
              8);
}

TEST(RandomKinds, StackedTrianglesAreCopies) {
    EXPECT_GT(count_of("stacked",
                       [](const Scene& s) {
                           const glm::dvec3 first = corner_of(s, 0, 0);
                           std::size_t there = 0;
                           for (std::size_t t = 0; t < s.triangles.size(); ++t)
                               for (int i = 0; i < 3; ++i) there += corner_of(s, t, i) == first;
                           return s.triangles.size() > 1 && there == s.triangles.size();
                       }),
              5);
}

TEST(RandomKinds, PrimitivesAreManyPartsAndSurfacesShareVertices) {
    EXPECT_GT(count_of("primitives", [](const Scene& s) { return s.parts.size() > 256; }), 0);
    EXPECT_EQ(count_of("primitives", [](const Scene& s) { return 3 * s.parts.size() < s.triangles.size(); }),
              0);
    EXPECT_GT(
        count_of("surface",
                 [](const Scene& s) { return s.vertices.position_world.size() < 2 * s.triangles.size(); }),
        20);
}

}  // namespace
}  // namespace zproof
