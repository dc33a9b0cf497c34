/// decide() asks intervals first: its word must be that of exact rationals throughout.
#include <gtest/gtest.h>

#include <cmath>

#include "brute_force.h"
#include "compare/admissible/conservative.h"
#include "math/lazy_rational.h"
#include "random_surroundings.h"
#include "test_scene.h"
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
        ASSERT_EQ(bare.admissibility, word_for(set, count, std::nullopt));
        ++said[std::size_t(bare.admissibility)];
        for (std::size_t i = 0; i < count; ++i) {
            const Decision decision = decide(s.around, PrimitiveId(s.around.neighbours[i].triangle));
            ASSERT_EQ(decision.admissibility, word_for(set, count, i)) << i;
            ++said[std::size_t(decision.admissibility)];
            exact += decision.exact;
        }
    }
    for (std::size_t word = 0; word < said.size(); ++word) {
        const std::size_t least = Admissibility(word) == Admissibility::undecidable ? 0 : 4;
        EXPECT_GE(said[word], least) << "word " << word;
    }
    EXPECT_GT(exact, 100);
}

/// Two triangles on one side of an edge that they share, which passes within eps of the centre; sometimes a
/// wall behind them, in front of them or between them.
std::vector<Triangle> random_silhouette(Rng& rng) {
    constexpr double eps_px = 1.0 / 512, far = 64;
    const double x = 1.5 + rng.between(-1, 1) * eps_px, slope = rng.between(-2, 2);
    const Corner up{x - slope * far, 1.5 - far, rng.between(3, 6)},
        down{x + slope * far, 1.5 + far, rng.between(3, 6)};
    const auto third = [&] { return Corner{rng.between(-900, -300), rng.between(-9, 9), rng.between(3, 6)}; };
    std::vector<Triangle> triangles{{up, third(), down}, {up, third(), down}};
    if (rng.below(3) == 0) triangles.push_back(wall(rng.between(2, 7)));
    return triangles;
}

TEST(Decide, ASilhouetteIsDecidedAsRationalsDecideHardlyEverByThem) {
    std::array<int, 7> said{};
    int exact = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        const View view = pixel_view(rng.below(2) ? Projection::perspective : Projection::parallel, 4, 4);
        const Scene scene = scene_of(view, random_silhouette(rng));
        const ViewBounds bounds(view, rng.below(2) ? raster_precision() : ray_precision());
        const Neighbourhood around = surroundings(scene, view, bounds, {1, 1}, 0);
        AdmissibleSet<Rational> set(around);
        for (std::size_t i = 0; i < around.neighbours.size(); ++i) {
            const Decision decision = decide(around, PrimitiveId(std::uint32_t(i)));
            ASSERT_EQ(decision.admissibility, word_for(set, around.neighbours.size(), i)) << i;
            exact += decision.exact;
            ++said[std::size_t(decision.admissibility)];
        }
    }
    EXPECT_GT(said[std::size_t(Admissibility::visible)], 300);
    EXPECT_GT(said[std::size_t(Admissibility::tied)], 100);
    EXPECT_GT(said[std::size_t(Admissibility::hidden)], 100);
    EXPECT_LT(exact, 40) << "where the planes' difference is worked out, 321";
}

/// What was found of one answer is not taken for another's.
TEST(Decide, OneSetIsAskedAboutAllAnswers) {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const std::size_t count = s.around.neighbours.size();
        AdmissibleSet<Rational> by_arithmetic(s.around);
        AdmissibleSet<LazyRational> set(s.around);
        for (std::size_t i = 0; i < count; ++i)
            ASSERT_EQ(word_for(set, count, i), word_for(by_arithmetic, count, i)) << i;
        ASSERT_EQ(word_for(set, count, std::nullopt), word_for(by_arithmetic, count, std::nullopt));
    }
}

TEST(Decide, WhatDoubleTellsOfWallsIsWhatRationalsTell) {
    using Finding = ConservativeTest::Finding;
    std::array<int, 2> said{};
    int certain = 0, others = 0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        const View view = pixel_view(rng.below(2) ? Projection::perspective : Projection::parallel, 4, 4);
        const Scene scene = random_walls(rng, view);
        const ViewBounds bounds(view, rng.below(2) ? raster_precision() : ray_precision());
        const Neighbourhood around = surroundings(scene, view, bounds, {1, 1}, 0);
        AdmissibleSet<Rational> set(around);
        for (std::size_t i = 0; i < around.neighbours.size(); ++i) {
            const Finding finding = ConservativeTest(around, PrimitiveId(std::uint32_t(i))).finding();
            ++(finding == Finding::undecided ? others : certain);
            if (finding == Finding::undecided) continue;
            const auto word = finding == Finding::tied ? Admissibility::tied : Admissibility::visible;
            ASSERT_EQ(word, word_for(set, around.neighbours.size(), i)) << i;
            ++said[finding == Finding::tied];
        }
    }
    EXPECT_GT(said[0], 300) << "visible";
    EXPECT_GT(said[1], 300) << "tied";
    EXPECT_GT(certain, others / 2);
}

TEST(Decide, ATriangleThatIsNoNeighbourIsOutside) {
    const Surroundings s = random_surroundings(0);
    EXPECT_EQ(decide(s.around, PrimitiveId(99)).admissibility, Admissibility::outside);
}

TEST(ClassOf, TheCandidatesDefectComesFirstThenTheReferencesThenTheLessPlainAdmissibility) {
    EXPECT_EQ(class_of(Admissibility::hole, Admissibility::hidden), PixelClass::hole);
    EXPECT_EQ(class_of(Admissibility::outside, Admissibility::visible), PixelClass::outside);
    EXPECT_EQ(class_of(Admissibility::hidden, Admissibility::hole), PixelClass::hidden);
    for (const Admissibility wrong : {Admissibility::hole, Admissibility::outside, Admissibility::hidden})
        EXPECT_EQ(class_of(Admissibility::tied, wrong), PixelClass::reference_wrong);
    EXPECT_EQ(class_of(Admissibility::visible, Admissibility::visible), PixelClass::edge);
    EXPECT_EQ(class_of(Admissibility::clipped, Admissibility::visible), PixelClass::clip);
    EXPECT_EQ(class_of(Admissibility::visible, Admissibility::clipped), PixelClass::clip);
    EXPECT_EQ(class_of(Admissibility::tied, Admissibility::clipped), PixelClass::depth_tie);
    EXPECT_EQ(class_of(Admissibility::tied, Admissibility::through_a_crack), PixelClass::abutting_edges);
}

}  // namespace
}  // namespace zproof
