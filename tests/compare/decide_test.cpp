/// decide() asks intervals first: its word must be that of exact rationals throughout.
#include <gtest/gtest.h>

#include <cmath>

#include "brute_force.h"
#include "compare/plain_case.h"
#include "random_surroundings.h"
#include "stage.h"
#include "word_for.h"

namespace zproof {
namespace {

TEST(Decide, SaysWhatExactRationalsSayForEveryAnswer) {
    std::array<int, 7> said{};
    int exact = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        AdmissibleSet<Rational> set(s.around);
        const std::size_t count = s.around.neighbours.size();
        const Decision bare = decide(s.around, PrimitiveId::none);
        ASSERT_EQ(bare.standing, word_for(set, count, std::nullopt));
        ++said[std::size_t(bare.standing)];
        for (std::size_t i = 0; i < count; ++i) {
            const Decision decision = decide(s.around, PrimitiveId(s.around.neighbours[i].triangle));
            ASSERT_EQ(decision.standing, word_for(set, count, i)) << i;
            ++said[std::size_t(decision.standing)];
            exact += decision.exact;
        }
    }
    for (std::size_t word = 0; word < said.size(); ++word) EXPECT_GT(said[word], 3) << "word " << word;
    EXPECT_GT(exact, 100);
}

TEST(Decide, APlainCaseIsDecidedAsRationalsDecide) {
    std::array<int, 2> said{};
    int plain_cases = 0, others = 0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view = pixel_view(dice.below(2) ? Projection::perspective : Projection::parallel, 4, 4);
        const Scene scene = random_walls(dice, view);
        const ViewBounds bounds(view, dice.below(2) ? raster_precision() : ray_precision());
        const Neighbourhood around = surroundings(scene, view, bounds, {1, 1}, 0);
        AdmissibleSet<Rational> set(around);
        CoplanarMemory memory(8);
        for (std::size_t i = 0; i < around.neighbours.size(); ++i) {
            const auto plain = standing_without_edges(around, PrimitiveId(std::uint32_t(i)), memory);
            ++(plain ? plain_cases : others);
            if (!plain) continue;
            ASSERT_EQ(*plain, word_for(set, around.neighbours.size(), i)) << i;
            ++said[*plain == Standing::tied];
        }
    }
    EXPECT_GT(said[0], 300) << "visible";
    EXPECT_GT(said[1], 300) << "tied";
    EXPECT_GT(plain_cases, others / 2);
}

TEST(Decide, ATriangleThatIsNoNeighbourIsOutside) {
    const Surroundings s = random_surroundings(0);
    EXPECT_EQ(decide(s.around, PrimitiveId(99)).standing, Standing::outside);
}

TEST(ClassOf, TheCandidatesDefectComesFirstThenTheReferencesThenTheLessPlainLawfulWord) {
    EXPECT_EQ(class_of(Standing::hole, Standing::hidden), PixelClass::hole);
    EXPECT_EQ(class_of(Standing::outside, Standing::visible), PixelClass::outside);
    EXPECT_EQ(class_of(Standing::hidden, Standing::hole), PixelClass::hidden);
    for (const Standing wrong : {Standing::hole, Standing::outside, Standing::hidden})
        EXPECT_EQ(class_of(Standing::tied, wrong), PixelClass::reference_wrong);
    EXPECT_EQ(class_of(Standing::visible, Standing::visible), PixelClass::edge);
    EXPECT_EQ(class_of(Standing::clipped, Standing::visible), PixelClass::clip);
    EXPECT_EQ(class_of(Standing::visible, Standing::clipped), PixelClass::clip);
    EXPECT_EQ(class_of(Standing::tied, Standing::clipped), PixelClass::depth_tie);
    EXPECT_EQ(class_of(Standing::tied, Standing::through_a_crack), PixelClass::abutting_edges);
}

}  // namespace
}  // namespace zproof
