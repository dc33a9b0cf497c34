/// What double precision says for certain exact rationals must say as well.
#include "compare/admissible/conservative.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bisected.h"
#include "compare/admissible/admissibility.h"
#include "math/rational.h"
#include "random_surroundings.h"
#include "test_scene.h"
#include "word_for.h"

namespace zproof {
namespace {

/// One pixel of a scene, with every triangle around it.
class OnePixel {
  public:
    OnePixel(const Scene& scene, const View& view, const Precision& precision, int x, int y)
        : scene_(scene), view_(view), bounds_(view, precision), x_(x), y_(y) {}

    Neighbourhood around(PrimitiveId answer) const {
        return surroundings(scene_, view_, bounds_, {x_, y_},
                            own_eps_px(scene_, view_, bounds_, {x_, y_}, answer));
    }

  private:
    const Scene& scene_;
    const View& view_;
    ViewBounds bounds_;
    int x_, y_;
};

/// Counts by word; fails where what is certain in double is not what rationals say.
class Comparison {
  public:
    explicit Comparison(std::uint32_t seed = 0) : rng_(seed) {}

    void ask(const OnePixel& pixel, PrimitiveId answer) {
        const Neighbourhood around = pixel.around(answer);
        const ConservativeTest test(around, answer);
        const auto index = around.index_of(answer);
        ASSERT_TRUE(index || answer == PrimitiveId::none);
        AdmissibleSet<Rational> set(around);
        ask_for_word(test, word_for(set, around.neighbours.size(), index));
        ask_whether_seen(test, set, around.eps_px, index);
        ask_for_displacement(around, answer);
    }
    void ask_about_all(const Scene& scene, const OnePixel& pixel) {
        ask(pixel, PrimitiveId::none);
        for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) ask(pixel, PrimitiveId(t));
    }

    std::array<int, 7> said{};
    int decided = 0, left = 0, moved = 0, seen = 0, unseen = 0;

  private:
    void ask_for_word(const ConservativeTest& test, Admissibility word) {
        const ConservativeTest::Finding finding = test.finding();
        const bool is_certain = finding != ConservativeTest::Finding::undecided;
        ++(is_certain ? decided : left);
        if (!is_certain) return;
        const bool is_tied = finding == ConservativeTest::Finding::tied;
        ASSERT_EQ(is_tied ? Admissibility::tied : Admissibility::visible, word);
        ++said[std::size_t(word)];
    }
    /// In squares of a few sizes.
    void ask_whether_seen(const ConservativeTest& test, AdmissibleSet<Rational>& set, double eps_px,
                          std::optional<std::size_t> index) {
        for (const double half_side_px : {least_px(eps_px), rng_.between(0, 1) * eps_px, eps_px}) {
            const ConservativeTest::Visibility certain = test.seen_within(half_side_px);
            if (certain == ConservativeTest::Visibility::undecided) continue;
            set.set_half_side(half_side_px);
            const bool is_seen = index ? set.is_seen(*index) : set.holds_background(EdgeRule::watertight);
            ASSERT_EQ(certain == ConservativeTest::Visibility::yes, is_seen) << half_side_px / eps_px;
            ++(is_seen ? seen : unseen);
        }
    }
    void ask_for_displacement(const Neighbourhood& around, PrimitiveId answer) {
        if (decide(around, answer).admissibility != Admissibility::visible) return;
        const auto displacement = displacement_of(around, answer).over_eps;
        ASSERT_EQ(displacement, bisected_displacement(around, answer));
        moved += displacement.has_value();
    }

    Rng rng_;
};

TEST(ConservativeTest, SaysWhatExactRationalsSayOrNothing) {
    Comparison comparison;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const Precision precision = seed % 2 ? raster_precision() : ray_precision();
        const OnePixel pixel(s.scene, s.view, precision, s.x, s.y);
        comparison.ask_about_all(s.scene, pixel);
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(comparison.decided, 600);
    EXPECT_GT(comparison.said[std::size_t(Admissibility::visible)], 500);
}

/// Another rule of drawing says by a range that a triangle hides what lies before its plane (diagnosis).
TEST(ConservativeTest, TakesNothingForSeenThatARangeHides) {
    const View view = pixel_view(Projection::parallel, 1, 1);
    const Scene scene = scene_of(view, {wall(4), wall(8)});
    const PrimitiveId answer{0};
    Neighbourhood around = OnePixel(scene, view, raster_precision(), 0, 0).around(answer);
    EXPECT_EQ(ConservativeTest(around, answer).finding(), ConservativeTest::Finding::visible);
    around.neighbours[1].least_inverse_depth = around.neighbours[1].greatest_inverse_depth = 0;
    EXPECT_NE(ConservativeTest(around, answer).finding(), ConservativeTest::Finding::visible);
    EXPECT_EQ(decide(around, answer).admissibility, Admissibility::hidden);
}

TEST(ConservativeTest, TellsTiesOfWallsAsRationalsDo) {
    Comparison comparison;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        const View view = pixel_view(rng.below(2) ? Projection::perspective : Projection::parallel, 4, 4);
        const Scene scene = random_walls(rng, view);
        const OnePixel pixel(scene, view, rng.below(2) ? raster_precision() : ray_precision(), 1, 1);
        for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) comparison.ask(pixel, PrimitiveId(t));
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(comparison.said[std::size_t(Admissibility::visible)], 300);
    EXPECT_GT(comparison.said[std::size_t(Admissibility::tied)], 300);
}

/// Two walls that meet within eps of the centre, at any slope, in front of a third or of nothing; or four
/// that meet in one point.
std::vector<Triangle> random_seams(Rng& rng) {
    constexpr double eps_px = 1.0 / 512;
    const double x = 1.5 + rng.between(-1, 1) * eps_px, y = 1.5 + rng.between(-1, 1) * eps_px;
    const double slope = rng.between(-2, 2), far = 64;
    const Corner up{x - slope * far, y - far, 4}, down{x + slope * far, y + far, 4};
    const Corner left{-512, y, 4}, right{512, y, 4}, middle{x, y, 4};
    std::vector<Triangle> walls;
    if (rng.below(2)) {
        walls = {{up, left, down}, {up, down, right}};
    } else {
        walls = {{middle, left, up}, {middle, up, right}, {middle, right, down}, {middle, down, left}};
    }
    if (rng.below(3) == 0) walls.pop_back();
    if (rng.below(2)) walls.push_back(wall(8));
    return walls;
}

/// Asks about background and every wall, of so many views.
Comparison asked(std::vector<Triangle> (*random)(Rng&), std::uint32_t views = 1000) {
    Comparison comparison;
    for (std::uint32_t seed = 0; seed < views; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        const View view = pixel_view(rng.below(2) ? Projection::perspective : Projection::parallel, 4, 4);
        const Scene scene = scene_of(view, random(rng));
        const OnePixel pixel(scene, view, rng.below(4) ? raster_precision() : ray_precision(), 1, 1);
        comparison.ask_about_all(scene, pixel);
        if (testing::Test::HasFatalFailure()) break;
    }
    return comparison;
}

TEST(ConservativeTest, TellsSeamsAndHowFarTheyMovedAsTheLongWayDoes) {
    const Comparison comparison = asked(random_seams);
    EXPECT_GT(comparison.said[std::size_t(Admissibility::visible)], 1000);
    EXPECT_GT(comparison.moved, 300);
}

/// A wall, and others in its plane or nearly so whose edges pass within eps of the centre; sometimes one that
/// is in front for certain covers a part of them.
std::vector<Triangle> random_torn_walls(Rng& rng) {
    constexpr double eps_px = 1.0 / 512, far = 64;
    std::vector<Triangle> walls{wall(4)};
    for (int count = 1 + rng.below(3); count > 0; --count) {
        const double depth =
            rng.below(5) == 0 ? 2 : 4 + (rng.below(3) == 0 ? std::ldexp(1.0, -rng.below(40)) : 0);
        const double x = 1.5 + rng.between(-1, 1) * eps_px, slope = rng.between(-2, 2);
        const Corner up{x - slope * far, 1.5 - far, depth}, down{x + slope * far, 1.5 + far, depth};
        walls.push_back(rng.below(2) ? Triangle{up, Corner{-512, 1.5, depth}, down}
                                     : Triangle{up, down, Corner{512, 1.5, depth}});
    }
    return walls;
}

TEST(ConservativeTest, TellsTiesWithinWhichEdgesPassAsRationalsDo) {
    const Comparison comparison = asked(random_torn_walls);
    EXPECT_GT(comparison.said[std::size_t(Admissibility::tied)], 1000);
    EXPECT_GT(comparison.left, 1000) << "hidden ones, for one";
}

/// A wall or two, and before or behind them triangles that are seen edge-on: across the centre, within eps of
/// it or beside the square, some of which end near the centre.
std::vector<Triangle> random_walls_edge_on(Rng& rng) {
    constexpr double eps_px = 1.0 / 512, far = 64;
    std::vector<Triangle> walls{rng.below(2) ? wall(8) : wall_left_of(1.5 + rng.between(-1, 1) * eps_px, 8)};
    for (int count = 1 + rng.below(3); count > 0; --count) {
        const double x = 1.5 + rng.below(5) * eps_px / 2 - eps_px, slope = rng.below(5) - 2;
        const double end = rng.below(3) ? far : (rng.below(5) - 2) * eps_px / 2;
        const auto along = [&](double y, double depth) { return Corner{x + slope * y, 1.5 + y, depth}; };
        walls.push_back({along(-far, 2), along(end, 4), along(rng.below(2) ? end : -far / 2, 16)});
    }
    return walls;
}

TEST(ConservativeTest, TellsWhatIsSeenBesideTrianglesEdgeOnAsRationalsDo) {
    const Comparison comparison = asked(random_walls_edge_on);
    EXPECT_GT(comparison.said[std::size_t(Admissibility::visible)], 500);
    EXPECT_GT(comparison.left, 1000) << "those that are edge-on themselves, for one";
}

/// A wall that covers the pixel, as it would stand if double did not know its side, or had it wrong.
TEST(ConservativeTest, LeavesATriangleOfUncertainSideUndecided) {
    const View view = pixel_view(Projection::parallel, 4, 4);
    const Scene scene = scene_of(view, {wall(8)});
    const OnePixel pixel(scene, view, raster_precision(), 1, 1);
    for (const PrimitiveId answer : {PrimitiveId::none, PrimitiveId(0)}) {
        Neighbourhood around = pixel.around(answer);
        Neighbour& n = around.neighbours.front();
        n.is_trusted = false;
        if (answer == PrimitiveId::none)
            for (Affine<double>& edge : n.edges) edge = -edge;
        EXPECT_EQ(ConservativeTest(around, answer).finding(), ConservativeTest::Finding::undecided);
    }
}

/// Walls on either side of an edge that passes within eps of the centre, in one plane with each other or in
/// planes that meet there; several of them on the same side, whose third corners are the same or not.
std::vector<Triangle> random_walls_along_an_edge(Rng& rng) {
    constexpr double eps_px = 1.0 / 512, far = 64;
    const double x = 1.5 + rng.between(-1, 1) * eps_px, slope = rng.between(-2, 2);
    const Corner up{x - slope * far, 1.5 - far, 4}, down{x + slope * far, 1.5 + far, 4};
    std::vector<Triangle> walls;
    for (int count = 2 + rng.below(3); count > 0; --count) {
        const bool to_the_left = rng.below(3) == 0;
        const double depth = rng.below(3) == 0 ? 4 + std::ldexp(1.0, -rng.below(30)) : 4;
        const Corner third{to_the_left ? -512.0 : 512.0, rng.below(2) ? 1.5 : 40, depth};
        walls.push_back(to_the_left ? Triangle{up, third, down} : Triangle{up, down, third});
    }
    return walls;
}

TEST(ConservativeTest, TellsWhatSharesAnEdgeAsRationalsDo) {
    const Comparison comparison = asked(random_walls_along_an_edge);
    EXPECT_GT(comparison.said[std::size_t(Admissibility::tied)], 1000);
    EXPECT_GT(comparison.said[std::size_t(Admissibility::visible)], 1000);
    EXPECT_GT(comparison.moved, 100);
}

/// Walls close to the near or the far plane, some so close that it may cut them: those hide nothing, and tie
/// with nothing.
std::vector<Triangle> random_walls_next_to_a_plane(Rng& rng) {
    const Camera& c = pixel_view(Projection::perspective, 4, 4).camera;
    const bool near = rng.below(2) != 0;
    const double plane = near ? c.near_depth : c.far_depth;
    std::vector<Triangle> walls;
    for (int count = 2 + rng.below(2); count > 0; --count) {
        const double share = std::exp2(rng.between(-24, -14));
        walls.push_back(wall(plane * (near ? 1 + share : 1 - share)));
    }
    return walls;
}

TEST(ConservativeTest, TellsTiesNextToAPlaneAsRationalsDo) {
    const Comparison comparison = asked(random_walls_next_to_a_plane, 3000);
    EXPECT_GT(comparison.said[std::size_t(Admissibility::tied)], 300);
    EXPECT_GT(comparison.left, 300) << "a plane may cut them";
}

/// A wall, and others that pass through it along upright lines, so slowly that they are tied with it for some
/// pixels to either side.
std::vector<Triangle> random_crossing_walls(Rng& rng) {
    std::vector<Triangle> walls{wall(4)};
    for (int count = 1 + rng.below(2); count > 0; --count) {
        const double line_x = rng.between(-4, 7),
                     per_px = std::ldexp(rng.between(-1, 1), -12 - rng.below(16));
        const auto corner = [&](double x, double y) { return Corner{x, y, 4 + per_px * (x - line_x)}; };
        walls.push_back({corner(-1000, -1000), corner(3000, -1000), corner(-1000, 3000)});
    }
    return walls;
}

TEST(ConservativeTest, TellsTiesOfCrossingWallsAsRationalsDo) {
    const Comparison comparison = asked(random_crossing_walls, 2000);
    EXPECT_GT(comparison.said[std::size_t(Admissibility::visible)], 1000);
    EXPECT_GT(comparison.said[std::size_t(Admissibility::tied)], 300);
}

/// Half-sides of squares whose corner an edge meets, but for next to nothing.
std::vector<double> halves_that_just_touch(const Neighbourhood& around, Rng& rng) {
    std::vector<double> halves;
    for (const Neighbour& n : around.neighbours) {
        const auto image =
            image_of(ViewRay<Rational>(around.view, around.x, around.y), corners<Rational>(n.p_world));
        for (std::size_t i = 0; image && i < 3; ++i) {
            const Affine<Rational>& e = image->edge[i];
            const Rational slope = abs(e.a) + abs(e.b);
            if (slope == 0) continue;
            const double half = double(Rational(abs(e.c) / slope));
            const double beside = half * (1 + std::ldexp(rng.between(-1, 1), -2 - rng.below(46)));
            if (beside > 0 && beside <= around.eps_px) halves.push_back(beside);
        }
    }
    return halves;
}

void ask_where_edges_just_touch(const Neighbourhood& around, Rng& rng, std::array<int, 2>& said) {
    std::vector<PrimitiveId> answers{PrimitiveId::none};
    for (const Neighbour& n : around.neighbours) answers.push_back(PrimitiveId(n.triangle));
    AdmissibleSet<Rational> set(around);
    for (const double half_side_px : halves_that_just_touch(around, rng))
        for (const PrimitiveId answer : answers) {
            const auto certain = ConservativeTest(around, answer).seen_within(half_side_px);
            if (certain == ConservativeTest::Visibility::undecided) continue;
            set.set_half_side(half_side_px);
            const bool is_seen = answer == PrimitiveId::none ? set.holds_background(EdgeRule::watertight)
                                                             : set.is_seen(*around.index_of(answer));
            ASSERT_EQ(certain == ConservativeTest::Visibility::yes, is_seen)
                << int(answer) << " within " << half_side_px;
            ++said[is_seen];
        }
}

TEST(ConservativeTest, IsRightWhereEdgesJustTouchTheSquare) {
    std::array<int, 2> said{};
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Rng rng(seed);
        ask_where_edges_just_touch(s.around, rng, said);
        if (HasFatalFailure()) return;
    }
    for (const int count : said) EXPECT_GT(count, 100);
}

/// The origin of the view ray is a small difference of large numbers there: its rounding counts.
TEST(ConservativeTest, IsRightWhereParallelRaysStartFarAway) {
    std::array<int, 2> said{};
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        const View view = view_from_far_away(rng);
        const PixelCoord place{rng.below(16), rng.below(16)};
        const Scene scene = random_crowd(rng, view, place.x, place.y);
        const ViewBounds bounds(view, RasterPrecision{.transform = Arithmetic::float64});
        ask_where_edges_just_touch(surroundings(scene, view, bounds, place, 0x1p-9), rng, said);
        if (HasFatalFailure()) return;
    }
    for (const int count : said) EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace zproof
