// Faces whose fan overlaps: the ears that are cut instead, and what stays a fan.
#include "scenes/concave_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace zproof {
namespace {

using Points = std::vector<glm::dvec2>;
using Triangles = std::vector<glm::uvec3>;

/// The face with its corners at these places.
Scene face_at(Positions corners) {
    std::vector<std::uint32_t> all(corners.size());
    Scene scene;
    scene.vertices.position_world = std::move(corners);
    std::iota(all.begin(), all.end(), 0u);
    const TriangleRun fan = append_fan("a.obj", "", all, scene);
    cut_concave_faces(std::vector{fan}, scene);
    return scene;
}

/// The face in space, seen by nobody along an axis.
Scene face_of(const Points& corners) {
    Positions positions;
    for (const glm::dvec2& p : corners) positions.emplace_back(0.25 * p.x - p.y, p.x + 0.5 * p.y, p.x);
    return face_at(std::move(positions));
}

Triangles triangles_of(const Points& corners) {
    const Scene scene = face_of(corners);
    return {scene.triangles.begin(), scene.triangles.end()};
}

double area(const Points& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec2 &a = p[i], &b = p[(i + 1) % p.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum / 2;
}

/// Triangles that turn as the face does and have its area in all cover it once, and nothing beside it.
void expect_covered(const Points& corners, const Scene& scene) {
    ASSERT_EQ(scene.triangles.size(), corners.size() - 2);
    EXPECT_TRUE(scene.notes.empty()) << scene.notes[0];
    const double whole = area(corners);
    double sum = 0;
    for (const glm::uvec3& t : scene.triangles) {
        const double part = area({corners[t.x], corners[t.y], corners[t.z]});
        EXPECT_GE(part * whole, -1e-12) << t.x << " " << t.y << " " << t.z;
        sum += part;
    }
    EXPECT_NEAR(sum, whole, 1e-9);
}

void expect_covered(const Points& corners) { expect_covered(corners, face_of(corners)); }

void expect_covered_from_every_corner(Points corners) {
    for (int turned = 0; turned < 2; ++turned) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            expect_covered(corners);
            std::ranges::rotate(corners, corners.begin() + 1);
        }
        std::ranges::reverse(corners);
    }
}

TEST(ConcaveFaces, CutsTheFirstEarFromTheFirstCornerOn) {
    const Points dart{{0, 0}, {2, 1}, {4, 0}, {2, 4}};
    EXPECT_EQ(triangles_of(dart), (Triangles{{3, 0, 1}, {3, 1, 2}}));
    const Points l{{2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}};
    EXPECT_EQ(triangles_of(l), (Triangles{{5, 0, 1}, {1, 2, 3}, {1, 3, 4}, {5, 1, 4}}));
}

TEST(ConcaveFaces, LeavesAFanThatCoversTheFace) {
    EXPECT_EQ(triangles_of({{2, 1}, {4, 0}, {2, 4}, {0, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(triangles_of({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}),
              (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    EXPECT_EQ(triangles_of({{0, 0}, {1, 0}, {2, 0}, {3, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ConcaveFaces, CoversDartsStairsAndLettersFromEveryCorner) {
    expect_covered_from_every_corner({{0, 0}, {2, 1}, {4, 0}, {2, 4}});
    expect_covered_from_every_corner({{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 3}, {0, 3}});
    expect_covered_from_every_corner({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}});
    // A ring, cut open between (0, 0) and (1, 1): both corners stand twice.
    expect_covered_from_every_corner(
        {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
}

TEST(ConcaveFaces, CoversCombsAndRandomStars) {
    Points comb{{0, 0}, {100, 0}};
    for (int i = 100; i-- > 0;) comb.insert(comb.end(), {{i + 0.75, 5}, {i + 0.25, 0.1}});
    expect_covered(comb);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> radius(0.05, 1);
    for (int corners = 4; corners < 120; ++corners) {
        Points star;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners, r = radius(random);
            star.emplace_back(float(r * std::cos(angle)), float(r * std::sin(angle)));
        }
        expect_covered(star);
    }
}

/// Long teeth stand on a diagonal and lean along it: the box of each holds many corners on the line between
/// its feet, and of hardly any can double's products tell that. Where each tooth asked each corner, this took
/// 18 s.
TEST(ConcaveFaces, CutsThirtyThousandCornersOnADiagonal) {
    constexpr int teeth = 15000;
    Points corners;
    for (int i = teeth; i-- > 1;) {
        const double foot = float(std::exp2(20.0 * i / teeth - 20)), tip = double(i) / teeth;
        corners.insert(corners.end(), {{foot, foot}, {float(tip + 0.7), float(tip + 1.3)}});
    }
    corners.insert(corners.end(), {{0x1p-20, 0x1p-20}, {2, -2}});
    std::ranges::rotate(corners, corners.begin() + teeth / 2);
    Positions positions;
    for (const glm::dvec2& p : corners) positions.emplace_back(p.x, p.y, 0);
    expect_covered(corners, face_at(std::move(positions)));
}

/// One corner lies beside the line through its neighbours by less than double's products can tell.
TEST(ConcaveFaces, TellsExactlyOnWhichSideACornerLies) {
    const double far = 0x1p24 - 1, step = 0x1p-24;
    for (const double off : {-step, 0.0, step}) {
        const Scene scene = face_at({glm::vec3(-1, -1, 0), glm::vec3(step, float(step + off * 0x1p-20), 0),
                                     glm::vec3(float(far), float(far), 0), glm::vec3(-1, float(far), 0)});
        const glm::uvec3 first = off > 0 ? glm::uvec3(3, 0, 1) : glm::uvec3(0, 1, 2);
        EXPECT_EQ(scene.triangles[0], first) << off;
    }
}

/// Double's own sum of products has the other sign.
TEST(ConcaveFaces, TellsWhatDoubleTellsWrong) {
    const auto first_triangle = [](const glm::vec3& corner, const glm::vec3& end) {
        return face_at({-end, corner, end, glm::vec3(-end.x, end.y, 0)}).triangles[0];
    };
    EXPECT_EQ(first_triangle({0x1.bd95e4p-21f, 0x1.0c1c68p-21f, 0}, {13469749, 8104813, 0}),
              glm::uvec3(3, 0, 1));
    EXPECT_EQ(first_triangle({0x1.ea9b24p-23f, 0x1.8bb20cp-22f, 0}, {5253061, 8473653, 0}),
              glm::uvec3(0, 1, 2));
}

TEST(ConcaveFaces, LeavesAFaceThatCrossesItselfAndSaysSo) {
    const Scene scene = face_of({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    EXPECT_EQ(scene.triangles[1], glm::uvec3(0, 2, 3));
    EXPECT_EQ(scene.notes, (std::vector<std::string>{
                               "concave faces that cross themselves or are too large, left as fans that "
                               "overlap: 1"}));
}

}  // namespace
}  // namespace zproof
