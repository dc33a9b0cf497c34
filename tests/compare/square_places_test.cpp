/// Four side by side say of a square what each triangle's filter says by itself.
#include "compare/hearing/square_places.h"

#include <gtest/gtest.h>

#include "random_surroundings.h"

namespace zproof {
namespace {

TEST(SquarePlaces, AreThoseOfEachFilter) {
    using Place = TriangleFilter::Place;
    constexpr std::array half_sides{0.001, 0.3, 5.0};
    SquarePlaces places;
    std::array<int, 3> met{};
    int unknown = 0;
    for (std::uint32_t seed = 0; seed < 900; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const double half_side = half_sides[seed % half_sides.size()];
        const TriangleFilters filters(s.view);
        places.turn_to(half_side);
        std::vector<TriangleFilter> all;
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
            const TriangleFilter& filter = all.emplace_back(filters.of(corners_of(s.scene, t)));
            filter.is_trusted ? places.add(filter, t % 7 == 0) : places.add_unknown();
        }
        for (int y = 0; y < s.view.height; ++y) {
            const int x = (s.x + y) % s.view.width;
            std::vector<std::size_t> covering{99}, cutting{99}, covers, cuts;
            places.sort(x, y, covering, cutting);
            for (std::size_t t = 0; t < all.size(); ++t) {
                const Around square{double(x), double(y), half_side, half_side};
                Place place = Place::unknown;
                if (all[t].is_trusted) place = t % 7 == 0 ? Place::covers : all[t].place_of(square);
                if (place == Place::covers) covers.push_back(t);
                if (place == Place::unknown) cuts.push_back(t);
                ++met[std::size_t(place)], unknown += !all[t].is_trusted;
            }
            ASSERT_EQ(covering, covers);
            ASSERT_EQ(cutting, cuts);
        }
    }
    for (const int count : met) EXPECT_GT(count, 1000);
    EXPECT_GT(unknown, 1000);
}

}  // namespace
}  // namespace zproof
