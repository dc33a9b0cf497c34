/// What is adjudicated together is decided as each query by itself, among all triangles of the scene.
#include "compare/adjudicate/adjudicator.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "bisected.h"
#include "compare/adjudicate/triangle_search.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

std::vector<QueryResult> adjudicate(const Scene& scene, const View& view, std::span<const PixelQuery> queries,
                                    QueryDetail asked, const RuleOverride& override = nullptr) {
    std::vector<const ViewBounds*> renderers;
    for (const PixelQuery& query : queries) renderers.push_back(query.bounds);
    return Adjudicator(scene, view, renderers, asked, override).decide(queries);
}

RasterPrecision with_subpixel_bits(int bits) {
    return {.transform = Arithmetic::float64, .subpixel_bits = bits};
}

/// In the square of half-side 1/8 around the only place asked about, but farther from it than 1/12, two walls
/// meet in front of a third.
class ACoarseAnswerAmongFineOnes : public testing::TestWithParam<Projection> {
  protected:
    static constexpr double seam_x = 2.609375, front_depth = 1, back_depth = 4;
    static constexpr std::uint32_t back = 2;

    View view = pixel_view(GetParam(), 16, 16);
    Scene scene = scene_of(
        view, {wall_left_of(seam_x, front_depth), wall_right_of(seam_x, front_depth), wall(back_depth)});
    ViewBounds fine{view, with_subpixel_bits(8)}, coarse{view, with_subpixel_bits(2)};

    /// Of that triangle by the coarse renderer, after so many of the fine one in the same tile.
    QueryResult decided_after(std::size_t fine_ones, PrimitiveId answer) const {
        std::vector<PixelQuery> queries;
        for (std::size_t i = 0; i < fine_ones; ++i) queries.push_back({&fine, PrimitiveId(0), 0, int(i)});
        queries.push_back({&coarse, answer, 2, 2});
        return adjudicate(scene, view, queries, QueryDetail::displacement).back();
    }
};

TEST_P(ACoarseAnswerAmongFineOnes, IsDecidedByAllThatItsOwnSquareReaches) {
    const QueryResult alone = decided_after(0, PrimitiveId(back));
    EXPECT_EQ(alone.decision.admissibility, Admissibility::hidden);
    EXPECT_GE(alone.decision.eps_px, 0.125);
    for (std::uint32_t triangle = 0; triangle < scene.triangles.size(); ++triangle) {
        SCOPED_TRACE(triangle);
        const QueryResult expected = decided_after(0, PrimitiveId(triangle));
        for (std::size_t fine_ones = 1; fine_ones < 5; ++fine_ones) {
            const QueryResult found = decided_after(fine_ones, PrimitiveId(triangle));
            EXPECT_EQ(found.decision.admissibility, expected.decision.admissibility);
            EXPECT_EQ(found.decision.eps_px, expected.decision.eps_px);
            EXPECT_EQ(found.displacement_over_eps, expected.displacement_over_eps);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Projections, ACoarseAnswerAmongFineOnes,
                         testing::Values(Projection::perspective, Projection::parallel));

/// Fine answers in every tile say that triangles need not be looked for far. In one, which no sample meets, a
/// coarse answer's edge passes through the centre; two walls that overlap right beside it leave only a crack
/// of its triangle, and only one of them comes as near as triangles are looked for.
TEST(Adjudicator, LooksAsFarAsEachQueryNeeds) {
    constexpr int tiles = 40, x = 20, y = 8;
    constexpr double centre_x = x + 0.5;
    const View view = pixel_view(Projection::parallel, tiles * 16, 16);
    const Scene scene = scene_of(view, {wall_right_of(centre_x, 8), wall_left_of(centre_x + 0x1p-11, 4),
                                        wall_right_of(centre_x + 0x1p-12, 4)});
    const ViewBounds fine(view, RayPrecision{.arithmetic = Arithmetic::float64}),
        coarse(view, with_subpixel_bits(-3));
    std::vector<PixelQuery> queries;
    for (int tile = 0; tile < tiles; ++tile)
        if (tile != x / 16)
            for (int row = 0; row < 16; ++row) queries.push_back({&fine, PrimitiveId(2), tile * 16, row});
    queries.push_back({&coarse, PrimitiveId(0), x, y});
    for (const QueryDetail asked : {QueryDetail::displacement, QueryDetail::admissibility})
        EXPECT_EQ(adjudicate(scene, view, queries, asked).back().decision.admissibility,
                  Admissibility::through_a_crack);
}

/// From tile to tile and back: each decision is its own query's.
TEST(Adjudicator, DecidesInTheOrderOfQueries) {
    constexpr double edge_x = 20;
    const View view = pixel_view(Projection::parallel, 64, 32);
    const Scene scene = scene_of(view, {wall_left_of(edge_x, 4)});
    const ViewBounds bounds(view, with_subpixel_bits(8));
    std::vector<PixelQuery> queries;
    for (int i = 0; i < 5000; ++i) queries.push_back({&bounds, PrimitiveId(0), i * 37 % 64, i * 11 % 32});
    const auto decided = adjudicate(scene, view, queries, QueryDetail::admissibility);
    ASSERT_EQ(decided.size(), queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
        ASSERT_EQ(decided[i].decision.admissibility,
                  queries[i].x >= edge_x ? Admissibility::outside : Admissibility::visible);
        ASSERT_FALSE(decided[i].displacement_over_eps) << "nobody asked";
    }
}

TEST(Adjudicator, IsAskedNothingByNoQueries) {
    const View view = pixel_view(Projection::parallel, 4, 4);
    EXPECT_TRUE(adjudicate(Scene{}, view, {}, QueryDetail::displacement).empty());
}

/// Pixels at which tiles meet, and any others.
int some_column(Rng& rng, int width) {
    constexpr std::array borders{0, 15, 16, 31, 32, 47};
    return rng.below(2) ? borders[std::size_t(rng.below(6))] : rng.below(width);
}

/// A crowd at a border of tiles and the queries of renderers of every kind around it.
struct Crowd {
    Rng rng;
    View view;
    Scene scene;
    std::array<ViewBounds, 4> renderers;
    std::vector<PixelQuery> queries;

    explicit Crowd(std::uint32_t seed)
        : rng(seed),
          view(larger_view(rng)),
          renderers{ViewBounds(view, raster_precision()), ViewBounds(view, ray_precision()),
                    ViewBounds(view, with_subpixel_bits(2)), ViewBounds(view, with_subpixel_bits(-1))} {
        const int x = some_column(rng, 48), y = some_column(rng, 48);
        scene = random_crowd(rng, view, x, y);
        for (int i = 0; i < 24; ++i) {
            const int t = rng.below(int(scene.triangles.size()) + 1);
            const PrimitiveId answer = t == 0 ? PrimitiveId::none : PrimitiveId(t - 1);
            const bool is_there = rng.below(2);
            queries.push_back({&renderers[std::size_t(rng.below(4))], answer,
                               is_there ? x : some_column(rng, 48), is_there ? y : some_column(rng, 48)});
        }
    }
    Crowd(const Crowd&) = delete;  // queries point into it
    Crowd& operator=(const Crowd&) = delete;

    static View larger_view(Rng& rng) {
        View view = random_view(rng);
        view.width = view.height = 48;
        return view;
    }
    /// Every triangle whose box comes within the square that counts.
    Neighbourhood around(const PixelQuery& q) const {
        const TriangleSearch search(scene, view, std::span(&q.bounds, 1));
        const double own_px = own_eps_px(scene, view, *q.bounds, {q.x, q.y}, q.answer);
        SearchPixel search_pixel{q.x, q.y, 2 * own_px, {}};
        while (true) {
            search_pixel.triangles.clear();
            for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
                if (PrimitiveId(t) == q.answer ||
                    search.box_of(t).meets(square_around(q.x, q.y, search_pixel.reach_px)))
                    search_pixel.triangles.push_back(t);
            Neighbourhood around = neighbourhood_of(scene, view, *q.bounds, search_pixel, own_px);
            if (around.eps_px <= search_pixel.reach_px) return around;
            search_pixel.reach_px = around.eps_px;
        }
    }
    /// Every triangle of the scene in a square of that half-side.
    Neighbourhood all_within(const PixelQuery& q, double eps_px) const {
        Neighbourhood around = surroundings(scene, view, *q.bounds, {q.x, q.y}, eps_px);
        around.eps_px = eps_px;
        return around;
    }
};

/// What stands too close to the eye to be seen cuts no plane for the judge, since nobody looks for it there.
Admissibility but_for_clipping(Admissibility word) {
    return word == Admissibility::clipped ? Admissibility::visible : word;
}

void expect_same(const QueryResult& found, const QueryResult& expected) {
    ASSERT_EQ(found.decision.admissibility, expected.decision.admissibility);
    ASSERT_EQ(found.decision.eps_px, expected.decision.eps_px);
    ASSERT_EQ(found.decision.exact, expected.decision.exact);
    ASSERT_EQ(found.displacement_over_eps, expected.displacement_over_eps);
}

/// Among them squares of up to a pixel and more, beyond what is searched at first.
TEST(Adjudicator, DecidesAsAmongAllTrianglesOfTheScene) {
    std::array<int, 7> said{};
    int large = 0, moved = 0;
    for (std::uint32_t seed = 0; seed < 250; ++seed) {
        SCOPED_TRACE(seed);
        const Crowd crowd(seed);
        const auto decided = adjudicate(crowd.scene, crowd.view, crowd.queries, QueryDetail::displacement);
        for (std::size_t i = 0; i < decided.size(); ++i) {
            const PixelQuery& query = crowd.queries[i];
            const Neighbourhood around = crowd.around(query);
            const Decision expected = decide(around, query.answer);
            ASSERT_EQ(decided[i].decision.admissibility, expected.admissibility) << i;
            ASSERT_EQ(decided[i].decision.eps_px, expected.eps_px) << i;
            const Neighbourhood all = crowd.all_within(query, expected.eps_px);
            const Admissibility among_all = decide(all, query.answer).admissibility;
            ASSERT_EQ(but_for_clipping(among_all), but_for_clipping(expected.admissibility)) << i;
            const bool is_visible = expected.admissibility == Admissibility::visible;
            ASSERT_EQ(decided[i].displacement_over_eps,
                      is_visible ? bisected_displacement(around, query.answer) : std::nullopt);
            ++said[std::size_t(expected.admissibility)], large += expected.eps_px > 1.0 / 16;
            moved += decided[i].displacement_over_eps.has_value();
        }
    }
    for (std::size_t word = 0; word < said.size(); ++word) {
        // crowds seldom abut; tests/compare/limits_test.cpp has walls that do
        const bool is_rare = Admissibility(word) == Admissibility::undecidable ||
                             Admissibility(word) == Admissibility::through_a_crack;
        const std::size_t least = is_rare ? 0 : 3;
        EXPECT_GE(said[word], least) << "word " << word;
    }
    EXPECT_GT(large, 500);
    EXPECT_GT(moved, 50);
}

TEST(Adjudicator, IsNotInfluencedByWhatElseIsAskedNorByTheOrderOfQueriesOrThreads) {
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        SCOPED_TRACE(seed);
        const Crowd crowd(seed);
        const auto together = tbb::task_arena(2).execute(
            [&] { return adjudicate(crowd.scene, crowd.view, crowd.queries, QueryDetail::displacement); });
        std::vector<PixelQuery> reversed(crowd.queries.rbegin(), crowd.queries.rend());
        const auto backwards = tbb::task_arena(1).execute(
            [&] { return adjudicate(crowd.scene, crowd.view, reversed, QueryDetail::displacement); });
        for (std::size_t i = 0; i < together.size(); ++i) {
            expect_same(backwards[together.size() - 1 - i], together[i]);
            const PixelQuery& query = crowd.queries[i];
            expect_same(
                adjudicate(crowd.scene, crowd.view, std::span(&query, 1), QueryDetail::displacement)[0],
                together[i]);
            if (HasFatalFailure()) return;
        }
    }
}

/// A corner so far away that float32 moves its triangle by a pixel: the square grows to what that may
/// uncover. Both walls are beyond what is searched at first.
TEST(Adjudicator, LooksAgainWhereTheSquareOutgrowsTheSearch) {
    const View view = pixel_view(Projection::perspective, 48, 48);
    const ViewBounds bounds(view, RasterPrecision{.transform = Arithmetic::float32, .subpixel_bits = 8});
    const Triangle swaying{{{24.5, -64, 4}, {24.5, 96, 4}, {-4e6, 24, 4}}};
    const Scene scene = scene_of(view, {swaying, wall_right_of(24.75, 8), wall_right_of(24.875, 2)});
    const auto decided = [&](std::uint32_t triangle) {
        const PixelQuery query{&bounds, PrimitiveId(triangle), 24, 24};
        return adjudicate(scene, view, std::span(&query, 1), QueryDetail::admissibility)[0].decision;
    };
    EXPECT_LT(own_eps_px(scene, view, bounds, {24, 24}, PrimitiveId(1)), 1.0 / 128);
    for (const std::uint32_t right : {1u, 2u}) {
        EXPECT_GT(decided(right).eps_px, 0.5);
        EXPECT_EQ(decided(right).admissibility, Admissibility::visible);
    }
}

TEST(RuleOverride, IsAppliedToEveryQueryBeforeItIsDecided) {
    const View view = pixel_view(Projection::parallel, 32, 32);
    const Scene scene = scene_of(view, {wall(4), wall(8)});
    const ViewBounds bounds(view, raster_precision());
    std::vector<PixelQuery> queries;
    for (int i = 0; i < 32; ++i) queries.push_back({&bounds, PrimitiveId(i % 2), i, 31 - i});
    const auto plainly = adjudicate(scene, view, queries, QueryDetail::admissibility);
    const auto all_but_the_answer_gone = [](Neighbourhood& around, PrimitiveId answer) {
        std::erase_if(around.neighbours,
                      [&](const Neighbour& n) { return PrimitiveId(n.triangle) != answer; });
    };
    const auto alone = adjudicate(scene, view, queries, QueryDetail::admissibility, all_but_the_answer_gone);
    const auto nothing_left = [](Neighbourhood& around, PrimitiveId) { around.neighbours.clear(); };
    const auto bare = adjudicate(scene, view, queries, QueryDetail::admissibility, nothing_left);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        EXPECT_EQ(plainly[i].decision.admissibility, i % 2 ? Admissibility::hidden : Admissibility::visible);
        EXPECT_EQ(alone[i].decision.admissibility, Admissibility::visible);
        EXPECT_EQ(bare[i].decision.admissibility, Admissibility::outside);
    }
}

/// Each pixel is done once, or once more for each time that it asks for a larger reach; it is given that.
TEST(Adjudicator, DoesEveryPixelUntilItIsContent) {
    const View view = pixel_view(Projection::parallel, 48, 48);
    const Scene scene = scene_of(view, {wall(4)});
    std::vector<PixelCoord> pixels;
    for (int i = 0; i < 500; ++i) pixels.push_back({i * 37 % 48, i * 11 % 48});
    std::vector<int> times(pixels.size());
    Adjudicator(scene, view, {}, QueryDetail::admissibility)
        .for_each_pixel(pixels, [&](TileWork&, std::size_t i, double searched_px) {
            const int time = ++times[i], enough = 1 + int(i % 3);
            EXPECT_TRUE(time == 1 || searched_px == time) << i;
            return time == enough ? 0.0 : time + 1.0;
        });
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(times[i], 1 + int(i % 3)) << i;
}

}  // namespace
}  // namespace zproof
