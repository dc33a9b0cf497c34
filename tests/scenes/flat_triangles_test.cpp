#include "scenes/flat_triangles.h"

#include <gtest/gtest.h>

#include <random>

namespace zproof {
namespace {

/// Seeded; on a grid of 3 x 3 x 3, so that many share a plane of the axes, and some have no area.
Positions on_a_grid(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> step(-1, 1);
    Positions positions;
    for (std::size_t i = 0; i < count; ++i) positions.emplace_back(step(random), step(random), step(random));
    return positions;
}

bool is_flat(const Positions& positions, const glm::uvec3& t) {
    const glm::dvec3 origin(positions[t.x]), a(positions[t.y]), b(positions[t.z]);
    return glm::cross(a - origin, b - origin) == glm::dvec3(0);
}

TEST(FlatTriangles, AreThoseWhoseCrossProductIsZero) {
    const Positions positions = on_a_grid(3000);
    std::vector<glm::uvec3> triangles;
    std::uint64_t flat = 0;
    for (std::uint32_t i = 0; i + 2 < positions.size(); ++i) {
        triangles.emplace_back(i, i + 1, i + 2);
        flat += is_flat(positions, triangles.back());
    }
    EXPECT_GT(flat, 100u);
    EXPECT_EQ(flat_among(triangles, positions), flat);
}

TEST(FlatTriangles, HaveNoLeastArea) {
    const Positions positions{{0, 0, 0}, {1, 0, 0}, {1e8f, 1e-30f, 0}, {2, 0, 0}};
    EXPECT_EQ(flat_among(std::vector<glm::uvec3>{{0, 1, 2}}, positions), 0u);
    EXPECT_EQ(flat_among(std::vector<glm::uvec3>{{0, 1, 3}, {0, 0, 2}}, positions), 2u);
    EXPECT_EQ(flat_among({}, positions), 0u);
}

}  // namespace
}  // namespace zproof
