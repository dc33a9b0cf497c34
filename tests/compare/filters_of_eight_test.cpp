/// Eight side by side have the bits that each triangle's filter has by itself.
#include "compare/hearing/filters_of_eight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/search/triangle_filter.h"
#include "random_surroundings.h"

namespace zproof {
namespace {

constexpr std::size_t lanes = 8;

std::array<double, 3> edge_at(const strips::EdgesOfEight& edges, std::size_t lane) {
    return {edges.a[lane], edges.b[lane], edges.c[lane]};
}
std::array<double, 3> parts(const Affine<double>& f) { return {f.a, f.b, f.c}; }

TEST(FiltersByEights, HaveTheBitsOfEachFilter) {
    int trusted = 0, others = 0, left_over = 0;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const TriangleFilters alone(s.view);
        // in any order, some of them twice: numbers of triangles that leave lanes over
        std::vector<std::uint32_t> triangles;
        for (std::uint32_t i = 0; i < seed % 19; ++i)
            triangles.push_back((i * 5 + seed) % std::uint32_t(s.scene.triangles.size()));
        std::vector<FiltersOfEight> eights(seed % 3);
        FiltersByEights(s.scene, s.view).make(triangles, eights);
        ASSERT_EQ(eights.size(), (triangles.size() + lanes - 1) / lanes);
        for (std::size_t i = 0; i < eights.size() * lanes; ++i) {
            const auto& [points, nearness] = eights[i / lanes];
            const std::size_t lane = i % lanes;
            if (i >= triangles.size()) {
                ++left_over;
                for (const strips::EdgesOfEight& edges : points.edges) {
                    ASSERT_EQ(edge_at(edges, lane), (std::array{0.0, 0.0, 0.0}));
                    ASSERT_EQ(edges.reach[lane], -unlimited);
                }
                continue;
            }
            const TriangleFilter filter = alone.of(corners_of(s.scene, triangles[i]));
            ++(filter.is_trusted ? trusted : others);
            for (std::size_t k = 0; k < 3; ++k) {
                const strips::EdgesOfEight& edges = points.edges[k];
                ASSERT_EQ(edges.reach[lane], filter.is_trusted ? filter.edge_error[k] : unlimited);
                if (!filter.is_trusted) continue;
                ASSERT_EQ(edge_at(edges, lane), parts(filter.edge[k]));
            }
            ASSERT_EQ(nearness.error[lane], filter.is_trusted ? filter.nearness_error : unlimited);
            if (!filter.is_trusted) continue;
            ASSERT_EQ((std::array{nearness.a[lane], nearness.b[lane], nearness.c[lane]}),
                      parts(filter.nearness));
        }
    }
    EXPECT_GT(trusted, 1000);
    EXPECT_GT(others, 100);
    EXPECT_GT(left_over, 1000);
}

}  // namespace
}  // namespace zproof
