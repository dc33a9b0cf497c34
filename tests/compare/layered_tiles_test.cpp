/// Findings written for whole tiles must be those of one pixel after the other.
#include "compare/layers/layered_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <iterator>

#include "compare/first_pass/agreement.h"
#include "compare/hearing/adjudication.h"
#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

constexpr int width = 40, height = 24;

/// Walls in nearly one plane, and two frames in which any of them may show, at its true depth or beside it.
struct Case {
    View view;
    Scene scene;
    Frame candidate{{width, height}}, reference{{width, height}};

    explicit Case(Dice& dice)
        : view(pixel_view(dice.below(2) ? Projection::perspective : Projection::parallel, width, height)),
          scene(random_walls(dice, view)) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                show(candidate, dice, x, y);
                show(reference, dice, x, y);
            }
    }

  private:
    void show(Frame& frame, Dice& dice, int x, int y) const {
        const auto triangle = std::uint32_t(dice.below(int(scene.triangles.size())));
        const auto image = image_of(Sight<double>(view, x, y), corners<double>(corners_of(scene, triangle)));
        if (!image) return;
        const double n = image->nearness.c;
        const double depth = view.camera.projection == Projection::perspective ? 1 / n : -n;
        answer(frame, x, y, triangle, dice.below(30) == 0 ? depth * 1.01 : depth);
    }
};

OpenTiles opened(const Scene& scene, const View& view, const Witness& ours, const Witness& theirs) {
    OpenTiles open(view);
    compare_frames(scene, ours, theirs, {}, open);
    open.number();
    return open;
}

ClassMap open_map() {
    ClassMap classes({width, height});
    const Tiles tiles(classes.size());
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) classes.open(column, row);
    return classes;
}

void expect_same(const Finding& a, const Finding& b) {
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, b.y);
    EXPECT_EQ(name_of(a.verdict), name_of(b.verdict));
    EXPECT_EQ(a.candidate.primitive, b.candidate.primitive);
    EXPECT_EQ(a.candidate.camera_depth, b.candidate.camera_depth);
    EXPECT_EQ(a.reference.primitive, b.reference.primitive);
    EXPECT_EQ(a.reference.camera_depth, b.reference.camera_depth);
    EXPECT_EQ(a.eps_px, b.eps_px);
    EXPECT_EQ(a.candidate_depth.low, b.candidate_depth.low);
    EXPECT_EQ(a.candidate_depth.truth, b.candidate_depth.truth);
    EXPECT_EQ(a.candidate_depth.high, b.candidate_depth.high);
    EXPECT_EQ(a.error_over_bound, b.error_over_bound);
}

TEST(LayeredTiles, AreSettledAsOnePixelAfterTheOther) {
    ClassCounts settled{};
    std::size_t left = 0;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const Case c(dice);
        const Witness ours(c.scene, c.view, {c.candidate, raster_precision()}),
            theirs(c.scene, c.view, {c.reference, ray_precision()});
        OpenTiles tiles = opened(c.scene, c.view, ours, theirs), others = tiles;
        const Bulk<PixelPlace> open = tiles.left();
        ClassMap classes = open_map(), alone = classes;
        std::vector<Finding> findings(open.size());
        const Comparands comparands{c.scene, c.view, ours, theirs};
        const ClassCounts layered = settle_layers(comparands, tiles, classes, findings);
        EXPECT_EQ(settle_layers(comparands, others, alone, {}), layered);
        const Bulk<PixelPlace> still_open = tiles.left();
        EXPECT_EQ(others.left(), still_open);
        EXPECT_TRUE(std::ranges::equal(alone.plane().pixels(), classes.plane().pixels()));
        const Rulings rulings = rule_on(c.scene, c.view, ours, theirs, open);
        PixelLook look(c.scene, ours, theirs);
        left += still_open.size();
        ClassCounts counts{};
        std::size_t next = 0;  // of what is still open
        for (std::uint32_t i = 0; i < open.size(); ++i) {
            if (next < still_open.size() && open[i] == still_open[next]) {
                ++next;
                continue;
            }
            OpenPixel pixel = look.at(open[i].x, open[i].y);
            pixel.finding.verdict = class_of(pixel, rulings[i]);
            pixel.finding.eps_px = rulings[i].candidate.eps_px;
            ++counts[std::size_t(pixel.finding.verdict)];
            expect_same(findings[tiles.number_of(open[i])], pixel.finding);
            EXPECT_EQ(classes.at(open[i].x, open[i].y), pixel.finding.verdict);
            if (testing::Test::HasFailure()) return;
        }
        EXPECT_EQ(next, still_open.size());
        EXPECT_EQ(counts, layered);
        for (std::size_t k = 0; k < counts.size(); ++k) settled[k] += counts[k];
    }
    EXPECT_GT(settled[std::size_t(PixelClass::depth_tie)], 3000u);
    EXPECT_GT(left, 500u);
}

TEST(LayeredTiles, KnowWhereIdsDiffer) {
    std::size_t same = 0;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        Dice dice(seed);
        const Case c(dice);
        const Witness ours(c.scene, c.view, {c.candidate, raster_precision()}),
            theirs(c.scene, c.view, {c.reference, ray_precision()});
        const OpenTiles open = opened(c.scene, c.view, ours, theirs);
        for (int row = 0; row < open.tiles().rows; ++row)
            for (const OpenTiles::Tile& tile : open.of_row(row))
                for_each_row(tile.pixels, [&](int y, ColumnMask columns) {
                    for (; columns != 0; columns &= columns - 1) {
                        const int column = std::countr_zero(columns);
                        const int at_x = tile.column * Tiles::side_px + column,
                                  at_y = row * Tiles::side_px + y;
                        const bool differ =
                            c.candidate.primitive.at(at_x, at_y) != c.reference.primitive.at(at_x, at_y);
                        ASSERT_EQ((tile.differ.row(y) >> column & 1) != 0, differ);
                        same += differ ? 0 : 1;
                    }
                });
    }
    EXPECT_GT(same, 100u);
}

/// Some depths are wrong, some answers hidden whose depths are right.
TEST(LayeredTiles, ThatFailAreListedAsInFull) {
    std::size_t hidden = 0, others = 0;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const Case c(dice);
        const RenderedFrame ours{c.candidate, raster_precision()}, theirs{c.reference, ray_precision()};
        const Verdict verdict = judge(c.scene, c.view, ours, theirs);
        std::vector<Finding> failing;
        std::ranges::copy_if(judge_in_full(c.scene, c.view, ours, theirs).verdict.findings,
                             std::back_inserter(failing),
                             [](const Finding& f) { return !passes(f.verdict); });
        ASSERT_EQ(verdict.findings.size(), failing.size());
        for (std::size_t i = 0; i < failing.size(); ++i) {
            expect_same(verdict.findings[i], failing[i]);
            ++(failing[i].verdict == PixelClass::hidden ? hidden : others);
        }
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(hidden, 100u);
    EXPECT_GT(others, 100u);
}

TEST(LayeredTiles, LeaveSquaresThatReachBeyondTheSearch) {
    const Trial walls(Projection::perspective, width, height, {wall(4), wall(4)});
    Frame ours = walls.candidate, theirs = walls.reference;
    answer_everywhere(ours, 0, 4);
    answer_everywhere(theirs, 1, 4);
    for (const int subpixel_bits : {8, -3}) {
        const Witness candidate(walls.scene, walls.view,
                                {ours, RasterPrecision{.subpixel_bits = subpixel_bits}}),
            reference(walls.scene, walls.view, {theirs, ray_precision()});
        OpenTiles open = opened(walls.scene, walls.view, candidate, reference);
        ClassMap classes = open_map();
        settle_layers({walls.scene, walls.view, candidate, reference}, open, classes, {});
        EXPECT_EQ(open.left().size(), subpixel_bits == 8 ? 0 : open.count());
    }
}

TEST(LayeredTiles, LeaveWhatIsHidden) {
    Trial trial(Projection::perspective, width, height, {wall(4), wall(8)});
    answer_everywhere(trial.candidate, 1, 8);
    answer_everywhere(trial.reference, 0, 4);
    EXPECT_EQ(trial.verdict().counts[std::size_t(PixelClass::hidden)], std::uint64_t(width * height));
}

TEST(LayeredTiles, LeavePixelsThatNoTriangleOfTheirsCovers) {
    Trial trial(Projection::perspective, width, height, {wall(4), wall_left_of(20, 4)});
    answer_everywhere(trial.candidate, 1, 4);
    answer_everywhere(trial.reference, 0, 4);
    const Verdict verdict = trial.verdict();
    EXPECT_EQ(verdict.counts[std::size_t(PixelClass::depth_tie)], std::uint64_t(20 * height));
    EXPECT_EQ(verdict.counts[std::size_t(PixelClass::outside)], std::uint64_t(20 * height));
}

}  // namespace
}  // namespace zproof
