/// What is decided summarily must be decided as the long way decides it, to the last bit.
#include "compare/hearing/summary.h"

#include <gtest/gtest.h>

#include "compare/layers/layers.h"
#include "compare/truth/displacement.h"
#include "math/rational.h"
#include "random_surroundings.h"
#include "stage.h"
#include "word_for.h"

namespace zproof {
namespace {

/// One pixel of a scene heard summarily, beside the neighbourhood that the long way is given.
class OnePixel {
  public:
    OnePixel(const Scene& scene, const View& view, const Precision& precision, int x, int y)
        : scene_(scene), view_(view), bounds_(view, precision), x_(x), y_(y) {
        for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) all_.push_back(t);
    }

    double own_eps_px(PrimitiveId answer) const { return own_eps_px(answer, x_); }
    Neighbourhood around(PrimitiveId answer) const { return around(answer, x_); }
    /// As a pixel of a tile whose centres reach that far from its own; in all others than its own after the
    /// pixel beside it.
    std::optional<Ruled> summarily(PrimitiveId answer, double tile_px) const {
        const Sights<double> sights(view_);
        Acquaintance acquaintance(scene_, view_);
        CoplanarMemory coplanar(16);
        const std::array<const ViewBounds*, 1> renderers{&bounds_};
        Summary summary({view_, sights, acquaintance, coplanar});
        look_elsewhere(summary, answer);
        summary.turn_to({double(x_), double(y_), tile_px, tile_px}, all_, renderers);
        std::optional<Ruled> latest;
        for (const int x : {x_ - 1, x_}) {
            if (x != x_ && tile_px == 0) continue;
            summary.look_at(x, y_);
            const double own = own_eps_px(answer, x);
            Estimate estimate([&] { return around(answer, x); }, coplanar);
            estimate.turn_to(answer);
            latest = summary.rule({&bounds_, answer, own, 2 * own, zproof::Asked::standing_and_displacement},
                                  estimate);
        }
        return latest;
    }

    /// In the same tile, as one of a row.
    std::optional<Ruled> in_its_row(PrimitiveId answer, double tile_px) const {
        const Sights<double> sights(view_);
        Acquaintance acquaintance(scene_, view_);
        CoplanarMemory coplanar(16);
        const std::array<const ViewBounds*, 1> renderers{&bounds_};
        const int column = int(tile_px), row = 3;
        Layers layers({sights, acquaintance, coplanar});
        layers.turn_to({x_ - column, y_ - row}, {double(x_), double(y_), tile_px, tile_px}, all_, renderers);
        if (!layers.are_known()) return std::nullopt;
        TileMask pixel;
        pixel.add(row, ColumnMask{1} << column);
        const TileMask uncut = layers.uncut(pixel);
        if (uncut.is_none()) return std::nullopt;
        const auto [tied, visible] = layers.standings(0, std::uint32_t(answer), uncut);
        const double eps_px = layers.eps_px(0, row)[std::size_t(column)];
        if ((tied | visible).is_none() || eps_px > 2 * own_eps_px(answer)) return std::nullopt;
        return Ruled{{tied.is_none() ? Standing::visible : Standing::tied, false}, eps_px, std::nullopt};
    }

  private:
    /// At a pixel of a tile that has fewer triangles, by another renderer's bounds as well.
    void look_elsewhere(Summary& summary, PrimitiveId answer) const {
        const ViewBounds wide(view_, RasterPrecision{.subpixel_bits = 2});
        const std::array<const ViewBounds*, 2> renderers{&wide, &bounds_};
        summary.turn_to({double(x_), double(y_ + 1), 0, 0}, std::span(all_).first(all_.size() / 2),
                        renderers);
        summary.look_at(x_, y_ + 1);
        CoplanarMemory coplanar(16);
        Estimate estimate([&] { return around(answer, x_); }, coplanar);
        estimate.turn_to(answer);
        summary.rule({&wide, answer, wide.background_eps_px(), 2}, estimate);
    }
    double own_eps_px(PrimitiveId answer, int x) const {
        return zproof::own_eps_px(scene_, view_, bounds_, {x, y_}, answer);
    }
    Neighbourhood around(PrimitiveId answer, int x) const {
        Site site{x, y_, 2 * own_eps_px(answer, x), {}};
        const TriangleFilters filters(view_);
        for (const std::uint32_t t : all_)
            if (filters.of(corners_of(scene_, t)).is_near(x, y_, site.reach_px)) site.triangles.push_back(t);
        return neighbourhood_of(scene_, view_, bounds_, site, own_eps_px(answer, x));
    }

    const Scene& scene_;
    const View& view_;
    ViewBounds bounds_;
    int x_, y_;
    std::vector<std::uint32_t> all_;
};

/// Counts by word; fails where the summary's word, eps or displacement is not the long way's.
class Comparison {
  public:
    void hear(const OnePixel& pixel, PrimitiveId answer) {
        for (const double tile_px : {0, 7}) {
            hear(pixel, answer, pixel.summarily(answer, tile_px));
            if (answer != PrimitiveId::none) hear_row(pixel, answer, pixel.in_its_row(answer, tile_px));
        }
    }
    void hear_row(const OnePixel& pixel, PrimitiveId answer, const std::optional<Ruled>& ruled) {
        if (ruled) ++in_rows[std::size_t(ruled->decision.standing)];
        hear(pixel, answer, ruled);
    }
    void hear(const OnePixel& pixel, PrimitiveId answer, const std::optional<Ruled>& ruled) {
        ++(ruled ? decided : left);
        if (!ruled) return;
        const Neighbourhood around = pixel.around(answer);
        ASSERT_LE(around.eps_px, 2 * pixel.own_eps_px(answer));
        ASSERT_EQ(ruled->eps_px, around.eps_px);
        CoplanarMemory memory(16);
        AdmissibleSet<Rational> set(around, memory);
        const auto index = around.index_of(answer);
        ASSERT_TRUE(index || answer == PrimitiveId::none);
        ASSERT_EQ(ruled->decision.standing, word_for(set, around.neighbours.size(), index));
        Estimate estimate([&] { return around; }, memory);
        estimate.turn_to(answer);
        ASSERT_EQ(ruled->displacement_over_eps, ruled->decision.standing == Standing::visible
                                                    ? displacement_over_eps(estimate)
                                                    : std::nullopt);
        ++said[std::size_t(ruled->decision.standing)];
        moved += ruled->displacement_over_eps.has_value();
    }

    std::array<int, 7> said{}, in_rows{};
    int decided = 0, left = 0, moved = 0;
};

TEST(Summary, SaysWhatExactRationalsSayOrNothing) {
    Comparison comparison;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const Precision precision = seed % 2 ? raster_precision() : ray_precision();
        const OnePixel pixel(s.scene, s.view, precision, s.x, s.y);
        comparison.hear(pixel, PrimitiveId::none);
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) comparison.hear(pixel, PrimitiveId(t));
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(comparison.decided, 600);
    EXPECT_GT(comparison.said[std::size_t(Standing::visible)], 500);
}

TEST(Summary, TellsTiesOfWallsAsRationalsDo) {
    Comparison comparison;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view = pixel_view(dice.below(2) ? Projection::perspective : Projection::parallel, 4, 4);
        const Scene scene = random_walls(dice, view);
        const OnePixel pixel(scene, view, dice.below(2) ? raster_precision() : ray_precision(), 1, 1);
        for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) comparison.hear(pixel, PrimitiveId(t));
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(comparison.said[std::size_t(Standing::visible)], 300);
    EXPECT_GT(comparison.said[std::size_t(Standing::tied)], 300);
    EXPECT_GT(comparison.in_rows[std::size_t(Standing::visible)], 300);
    EXPECT_GT(comparison.in_rows[std::size_t(Standing::tied)], 300);
}

/// Two walls that meet within eps of the centre, at any slope, in front of a third or of nothing; or four
/// that meet in one point.
std::vector<Triangle> random_seams(Dice& dice) {
    constexpr double eps_px = 1.0 / 512;
    const double x = 1.5 + dice.between(-1, 1) * eps_px, y = 1.5 + dice.between(-1, 1) * eps_px;
    const double slope = dice.between(-2, 2), far = 64;
    const Corner up{x - slope * far, y - far, 4}, down{x + slope * far, y + far, 4};
    const Corner left{-512, y, 4}, right{512, y, 4}, middle{x, y, 4};
    std::vector<Triangle> walls;
    if (dice.below(2)) {
        walls = {{up, left, down}, {up, down, right}};
    } else {
        walls = {{middle, left, up}, {middle, up, right}, {middle, right, down}, {middle, down, left}};
    }
    if (dice.below(3) == 0) walls.pop_back();
    if (dice.below(2)) walls.push_back(wall(8));
    return walls;
}

/// Hears background and every wall, of a thousand views.
Comparison heard(std::vector<Triangle> (*random)(Dice&)) {
    Comparison comparison;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view = pixel_view(dice.below(2) ? Projection::perspective : Projection::parallel, 4, 4);
        const Scene scene = scene_of(view, random(dice));
        const OnePixel pixel(scene, view, dice.below(4) ? raster_precision() : ray_precision(), 1, 1);
        comparison.hear(pixel, PrimitiveId::none);
        for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) comparison.hear(pixel, PrimitiveId(t));
        if (testing::Test::HasFatalFailure()) break;
    }
    return comparison;
}

TEST(Summary, TellsSeamsAndHowFarTheyMovedAsTheLongWayDoes) {
    const Comparison comparison = heard(random_seams);
    EXPECT_GT(comparison.said[std::size_t(Standing::visible)], 1000);
    EXPECT_GT(comparison.moved, 300);
}

/// A wall, and others in its plane or nearly so whose edges pass within eps of the centre; sometimes one that
/// is in front for certain covers a part of them.
std::vector<Triangle> random_torn_walls(Dice& dice) {
    constexpr double eps_px = 1.0 / 512, far = 64;
    std::vector<Triangle> walls{wall(4)};
    for (int count = 1 + dice.below(3); count > 0; --count) {
        const double depth =
            dice.below(5) == 0 ? 2 : 4 + (dice.below(3) == 0 ? std::ldexp(1.0, -dice.below(40)) : 0);
        const double x = 1.5 + dice.between(-1, 1) * eps_px, slope = dice.between(-2, 2);
        const Corner up{x - slope * far, 1.5 - far, depth}, down{x + slope * far, 1.5 + far, depth};
        walls.push_back(dice.below(2) ? Triangle{up, Corner{-512, 1.5, depth}, down}
                                      : Triangle{up, down, Corner{512, 1.5, depth}});
    }
    return walls;
}

TEST(Summary, TellsTiesWithinWhichEdgesPassAsRationalsDo) {
    const Comparison comparison = heard(random_torn_walls);
    EXPECT_GT(comparison.said[std::size_t(Standing::tied)], 1000);
    EXPECT_GT(comparison.left, 1000) << "hidden ones, for one";
}

/// Walls on either side of an edge that passes within eps of the centre, in one plane with each other or in
/// planes that meet there; several of them on the same side, whose third corners are the same or not.
std::vector<Triangle> random_walls_along_an_edge(Dice& dice) {
    constexpr double eps_px = 1.0 / 512, far = 64;
    const double x = 1.5 + dice.between(-1, 1) * eps_px, slope = dice.between(-2, 2);
    const Corner up{x - slope * far, 1.5 - far, 4}, down{x + slope * far, 1.5 + far, 4};
    std::vector<Triangle> walls;
    for (int count = 2 + dice.below(3); count > 0; --count) {
        const bool to_the_left = dice.below(3) == 0;
        const double depth = dice.below(3) == 0 ? 4 + std::ldexp(1.0, -dice.below(30)) : 4;
        const Corner third{to_the_left ? -512.0 : 512.0, dice.below(2) ? 1.5 : 40, depth};
        walls.push_back(to_the_left ? Triangle{up, third, down} : Triangle{up, down, third});
    }
    return walls;
}

TEST(Summary, TellsWhatSharesAnEdgeAsRationalsDo) {
    const Comparison comparison = heard(random_walls_along_an_edge);
    EXPECT_GT(comparison.said[std::size_t(Standing::tied)], 1000);
    EXPECT_GT(comparison.said[std::size_t(Standing::visible)], 1000);
    EXPECT_GT(comparison.moved, 100);
}

/// Walls close to the near or the far plane, some so close that it may cut them: those hide nothing, and tie
/// with nothing.
std::vector<Triangle> random_walls_next_to_a_plane(Dice& dice) {
    const Camera& c = pixel_view(Projection::perspective, 4, 4).camera;
    const bool near = dice.below(2) != 0;
    const double plane = near ? c.near_depth : c.far_depth;
    std::vector<Triangle> walls;
    for (int count = 2 + dice.below(2); count > 0; --count) {
        const double share = std::exp2(dice.between(-24, -14));
        walls.push_back(wall(plane * (near ? 1 + share : 1 - share)));
    }
    return walls;
}

TEST(Summary, TellsTiesNextToAPlaneAsRationalsDo) {
    const Comparison comparison = heard(random_walls_next_to_a_plane);
    EXPECT_GT(comparison.said[std::size_t(Standing::tied)], 300);
    EXPECT_GT(comparison.left, 300) << "a plane may cut them";
}

/// A wall, and others that pass through it along upright lines, so slowly that they are tied with it for some
/// pixels to either side.
std::vector<Triangle> random_crossing_walls(Dice& dice) {
    std::vector<Triangle> walls{wall(4)};
    for (int count = 1 + dice.below(2); count > 0; --count) {
        const double line_x = dice.between(-4, 7),
                     per_px = std::ldexp(dice.between(-1, 1), -12 - dice.below(16));
        const auto corner = [&](double x, double y) { return Corner{x, y, 4 + per_px * (x - line_x)}; };
        walls.push_back({corner(-1000, -1000), corner(3000, -1000), corner(-1000, 3000)});
    }
    return walls;
}

TEST(Summary, TellsTiesOfCrossingWallsAsRationalsDo) {
    const Comparison comparison = heard(random_crossing_walls);
    EXPECT_GT(comparison.said[std::size_t(Standing::visible)], 1000);
    EXPECT_GT(comparison.said[std::size_t(Standing::tied)], 300);
}

TEST(ImageOfView, HasTheBitsOfImageOfAtEveryPixel) {
    int images = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Dice dice(seed);
        const ViewBounds bounds(s.view, RayPrecision{});
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
            const CornersWorld p = corners_of(s.scene, t);
            const Sight<double> sight(s.view, dice.below(16), dice.below(16));
            const ViewedTriangle seen(bounds, Sight<double>(s.view, s.x, s.y), p);
            const TriangleOfView triangle(bounds, seen);
            const auto image = seen.image.at(sight), expected = image_of(sight, corners<double>(p));
            ASSERT_EQ(image.has_value(), expected.has_value());
            ASSERT_EQ(triangle.eps_px(sight), neighbour_of(sight, bounds, p).bounds.eps_px);
            if (!image) continue;
            ++images;
            const auto parts = [](const Affine<double>& f) { return std::array{f.a, f.b, f.c}; };
            for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(parts(image->edge[i]), parts(expected->edge[i]));
            ASSERT_EQ(parts(image->nearness), parts(expected->nearness));
            const auto alone = nearness_of(sight, corners<double>(p));
            ASSERT_EQ(parts(*alone), parts(expected->nearness));
        }
    }
    EXPECT_GT(images, 500);
}

}  // namespace
}  // namespace zproof
