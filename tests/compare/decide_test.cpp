/// decide() asks intervals first: its word must be that of exact rationals throughout.
#include <gtest/gtest.h>

#include "brute_force.h"
#include "compare/standing.h"
#include "random_surroundings.h"

namespace zproof {
namespace {

constexpr Rules by_place{DepthRule::strict, EdgeRule::watertight};
constexpr Rules by_depth{DepthRule::bounded, EdgeRule::watertight};
constexpr Rules by_crack{DepthRule::bounded, EdgeRule::separate};

/// The words of standing.h spelled out over any set of answers.
template <class Set>
Standing word_for(Set& set, std::size_t count, std::optional<std::size_t> index) {
    bool clipped = false;
    for (std::size_t i = 0; i < count; ++i) clipped = clipped || set.is_clipped(i);
    const Standing seen = clipped ? Standing::clipped : Standing::visible;
    if (!index) {
        if (set.holds_background(EdgeRule::watertight)) return seen;
        return set.holds_background(EdgeRule::separate) ? Standing::through_a_crack : Standing::hole;
    }
    if (!set.reaches(*index)) return Standing::outside;
    if (set.is_visible(*index) || set.holds(*index, by_place)) return seen;
    if (set.holds(*index, by_depth)) return Standing::tied;
    return set.holds(*index, by_crack) ? Standing::through_a_crack : Standing::hidden;
}

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
