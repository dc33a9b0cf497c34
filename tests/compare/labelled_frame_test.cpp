/// Frames of labels: what is named passes exactly where some triangle of the label is admissible.
#include "compare/labels/labelled_frame.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "compare/adjudicate/adjudicator.h"
#include "compare/admissible/admissible_set.h"
#include "compare/admissible/depth_rule.h"
#include "math/rational.h"
#include "random_surroundings.h"
#include "test_scene.h"
#include "word_for.h"

namespace zproof {
namespace {

TriangleLabels depth_alone(const Scene& scene) {
    return {
        .ids = "none", .of_triangle = std::vector<std::uint32_t>(scene.triangles.size()), .are_absent = true};
}

TriangleLabels labels(std::vector<std::uint32_t> of_triangle) {
    return {.ids = "material", .of_triangle = std::move(of_triangle)};
}

/// A renderer's frame of labels at one pixel of a random scene; the reference knows nothing.
struct RandomPixel {
    View view;
    Scene scene;
    PixelCoord pixel;
    Precision precision;
    TriangleLabels labels;
    Frame frame, reference;

    explicit RandomPixel(std::uint32_t seed) : RandomPixel(Rng(seed)) {}
    std::uint32_t label() const { return std::uint32_t(frame.primitive.at(pixel.x, pixel.y)); }
    float depth() const { return frame.camera_depth.at(pixel.x, pixel.y); }

    bool holds_depth(const ViewBounds& bounds, std::uint32_t t) const {
        const CornersWorld p_world = corners_of(scene, t);
        const TriangleDepth of_triangle(TriangleInView(view, bounds, p_world), bounds);
        return check_depth(view, bounds, p_world, of_triangle, pixel, depth()).is_admissible;
    }
    /// As the judge decides each triangle of the scene, and as rationals do among all triangles.
    bool is_right(const ViewBounds& bounds, std::uint32_t t) const {
        const PixelQuery query{&bounds, PrimitiveId(t), pixel.x, pixel.y, AskedReason::the_first, depth()};
        const Adjudicator adjudicator(scene, view, {&bounds}, QueryDetail::admissibility);
        const auto [decision, displacement, farthest] = adjudicator.decide(std::span(&query, 1)).front();
        EXPECT_EQ(is_admissible(decision.admissibility), is_admissible_in_rationals(bounds, t, decision));
        return holds_depth(bounds, t) && is_admissible(decision.admissibility) && !(depth() > farthest);
    }

  private:
    bool is_admissible_in_rationals(const ViewBounds& bounds, std::uint32_t t,
                                    const Decision& decision) const {
        Neighbourhood around = surroundings(scene, view, bounds, pixel, 0);
        around.eps_px = decision.eps_px;
        AdmissibleSet<Rational> set(around);
        return is_admissible(word_for(set, around.neighbours.size(), t));
    }
    explicit RandomPixel(Rng rng)
        : view(random_view(rng)), frame({view.width, view.height}), reference({view.width, view.height}) {
        pixel = {rng.below(view.width), rng.below(view.height)};
        scene = random_crowd(rng, view, pixel.x, pixel.y);
        precision = rng.below(3) ? Precision(RasterPrecision{.subpixel_bits = rng.below(9)})
                                 : Precision(RayPrecision{});
        const auto count = int(scene.triangles.size());
        const int label_count = 1 + rng.below(3);
        labels.ids = "material";
        for (int t = 0; t < count; ++t) labels.of_triangle.push_back(std::uint32_t(rng.below(label_count)));
        const ViewBounds bounds(view, precision);
        const CornersWorld p_world = corners_of(scene, std::uint32_t(rng.below(count)));
        const DepthBound bound =
            TriangleDepth(TriangleInView(view, bounds, p_world), bounds).at(pixel.x, pixel.y);
        const double factor = rng.below(4) ? 1 : rng.between(0.9, 1.1);
        frame.camera_depth.at(pixel.x, pixel.y) = float(std::clamp(bound.truth * factor, 0.0, 1e30));
        frame.primitive.at(pixel.x, pixel.y) = PrimitiveId(labels.of_triangle[std::size_t(rng.below(count))]);
    }
};

TEST(ALabel, PassesExactlyWhereSomeTriangleOfItIsAdmissibleAtThatDepth) {
    int right = 0, wrong = 0, wide = 0;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        const RandomPixel p(seed);
        const ViewBounds bounds(p.view, p.precision);
        const Frame frame =
            with_triangles(p.scene, p.view, {p.frame, p.precision}, p.labels, {p.reference, p.precision});
        const auto named = std::uint32_t(frame.primitive.at(p.pixel.x, p.pixel.y));
        ASSERT_LT(named, p.scene.triangles.size());
        ASSERT_EQ(p.labels.of_triangle[named], p.label());
        bool any = false;
        for (std::uint32_t t = 0; t < p.scene.triangles.size(); ++t)
            any = any || (p.labels.of_triangle[t] == p.label() && p.is_right(bounds, t));
        ASSERT_EQ(p.is_right(bounds, named), any) << named;
        ++(any ? right : wrong);
        wide += own_eps_px(p.scene, p.view, bounds, p.pixel, PrimitiveId(named)) > 1.0 / 16;
    }
    EXPECT_GT(right, 200);
    EXPECT_GT(wrong, 200);
    EXPECT_GT(wide, 100);
}

/// A wall in front of a wall, and what a frame says of pixel (1, 1).
class TwoWalls : public testing::TestWithParam<Projection> {
  protected:
    static constexpr std::uint32_t front = 0, back = 2;  // 1 stands beside
    TestScene t{GetParam(), 4, 4, {wall_left_of(3.5, 4), wall_right_of(20, 2), wall(8)}};

    PixelClass class_of(const TriangleLabels& labels, std::uint32_t label, float depth) {
        answer_everywhere(t.candidate, label, depth);
        answer_everywhere(t.reference, front, 4);
        t.candidate = with_triangles(t.scene, t.view, {t.candidate, t.candidate_precision}, labels,
                                     {t.reference, t.reference_precision});
        return t.class_at(1, 1);
    }
    PrimitiveId named() const { return t.candidate.primitive.at(1, 1); }
};

TEST_P(TwoWalls, AreToldApartByDepthAlone) {
    const TriangleLabels all = depth_alone(t.scene);
    EXPECT_EQ(class_of(all, 99, 4), PixelClass::agree);
    EXPECT_EQ(named(), PrimitiveId(front));
    EXPECT_EQ(class_of(all, 99, 8), PixelClass::hidden) << "the depth of the wall behind";
    EXPECT_EQ(named(), PrimitiveId(back));
    EXPECT_EQ(class_of(all, 99, 4.01f), PixelClass::wrong_depth);
    EXPECT_EQ(named(), PrimitiveId(front));
    EXPECT_EQ(class_of(all, 99, background_depth), PixelClass::hole);
    EXPECT_EQ(class_of(all, 99, std::nanf("")), PixelClass::invalid);
    EXPECT_EQ(class_of(all, 99, -1), PixelClass::invalid);
}

/// Of two triangles at one depth the reference names the one beyond an edge that it does not place as finely.
TEST_P(TwoWalls, AreNotNamedByAReferenceThatProvesNothing) {
    t.scene = scene_of(t.view, {wall_left_of(1.5 + 1e-3, 4), wall_right_of(1.5 + 1e-3, 4)});
    t.reference_precision = BoundedPrecision{.eps_px = 0.01, .depth_relative = 1e-6};
    t.candidate_precision = BoundedPrecision{.eps_px = 1e-4, .depth_relative = 1e-6};
    answer_everywhere(t.candidate, 99, 4);
    answer_everywhere(t.reference, 0, 4);
    answer(t.reference, 1, 1, 1, 4);
    t.candidate = with_triangles(t.scene, t.view, {t.candidate, t.candidate_precision}, depth_alone(t.scene),
                                 {t.reference, t.reference_precision});
    EXPECT_EQ(named(), PrimitiveId(0));
}

TEST_P(TwoWalls, AreToldApartByTheirLabels) {
    const TriangleLabels two = labels({7, 7, 5});
    EXPECT_EQ(class_of(two, 7, 4), PixelClass::agree);
    EXPECT_EQ(class_of(two, 5, 8), PixelClass::hidden);
    EXPECT_EQ(class_of(two, 5, 4), PixelClass::hidden) << "the right depth, another label";
    EXPECT_EQ(class_of(two, 7, 4.01f), PixelClass::wrong_depth);
    EXPECT_EQ(class_of(two, 7, 2), PixelClass::wrong_depth) << "the depth of one of them that is elsewhere";
    EXPECT_EQ(class_of(two, 6, 4), PixelClass::invalid) << "no triangle has this label";
    EXPECT_EQ(class_of(two, 0xFFFF'FFFF, background_depth), PixelClass::hole);
    EXPECT_EQ(class_of(two, 0xFFFF'FFFF, 4), PixelClass::invalid) << "background with a depth";
    EXPECT_EQ(class_of(labels({1, 2, 3}), 2, 2), PixelClass::outside);
}

TEST_P(TwoWalls, BackgroundMayHaveOtherIds) {
    TriangleLabels two = labels({7, 7, 5});
    two.background.push_back(0);
    EXPECT_EQ(class_of(two, 0, background_depth), PixelClass::hole);
}

TEST_P(TwoWalls, LabelsOfTrianglesComeBackAsTriangles) {
    const TriangleLabels two = labels({7, 7, 5});
    answer_everywhere(t.candidate, back, 8);
    answer(t.candidate, 1, 1, front, 4);
    answer_background(t.candidate, 2, 2);
    const Frame said = with_labels(t.candidate, two);
    EXPECT_EQ(said.primitive.at(0, 0), PrimitiveId(5));
    EXPECT_EQ(said.primitive.at(1, 1), PrimitiveId(7));
    EXPECT_EQ(said.primitive.at(2, 2), PrimitiveId::none);
    const Frame back_again = with_triangles(t.scene, t.view, {said, t.candidate_precision}, two,
                                            {t.reference, t.reference_precision});
    EXPECT_TRUE(std::ranges::equal(back_again.primitive.pixels(), t.candidate.primitive.pixels()));
}

TEST_P(TwoWalls, GiveTheSameFrameOnAnyNumberOfThreads) {
    answer_everywhere(t.candidate, 0, 8);
    const auto on = [&](int threads) {
        Frame frame;
        tbb::task_arena(threads).execute([&] {
            frame = with_triangles(t.scene, t.view, {t.candidate, t.candidate_precision},
                                   depth_alone(t.scene), {t.reference, t.reference_precision});
        });
        return frame;
    };
    const Frame one = on(1), four = on(4);
    EXPECT_TRUE(std::ranges::equal(one.primitive.pixels(), four.primitive.pixels()));
}

INSTANTIATE_TEST_SUITE_P(Projections, TwoWalls,
                         testing::Values(Projection::perspective, Projection::parallel));

TEST(ALabel, NamesTheTriangleWhoseBoundReachesANegativeDepth) {
    TestScene t(Projection::perspective, 2, 2, {wall(4), wall(0.25)});
    const RenderedFrame of_labels{t.candidate, BoundedPrecision{.eps_px = 0.01, .depth_absolute = 0.5}};
    answer_everywhere(t.candidate, 7, -0.25);
    answer_everywhere(t.reference, 0, 4);
    const Frame named =
        with_triangles(t.scene, t.view, of_labels, labels({7, 7}), {t.reference, t.reference_precision});
    EXPECT_EQ(named.primitive.at(1, 1), PrimitiveId(1));
}

PixelClass class_by(TestScene t, const TriangleLabels& said, int x, int y) {
    t.candidate = with_triangles(t.scene, t.view, {t.candidate, t.candidate_precision}, said,
                                 {t.reference, t.reference_precision});
    return t.class_at(x, y);
}

/// The pixel's centre lies 1 px beyond the tip of a needle; two weights of minus the tolerance lie 85 of it
/// in px there. The first triangle of the label is elsewhere.
TEST(ALabel, MayBeThatOfATriangleShownBeyondItsTip) {
    TestScene t(Projection::parallel, 8, 4,
                {{{{90, 90, 4}, {91, 90, 4}, {90, 91, 4}}}, {{{-40, 1.4, 4}, {2.5, 1.5, 4}, {-40, 1.6, 4}}}});
    answer(t.candidate, 3, 1, 7, 4);
    for (const double share : {1.01, 0.99}) {
        t.candidate_precision =
            RayPrecision{.arithmetic = Arithmetic::float64, .barycentric_tolerance = share / 85};
        EXPECT_EQ(class_by(t, labels({7, 7}), 3, 1), share > 1 ? PixelClass::edge : PixelClass::outside);
    }
}

/// All three edge functions err by more than the needle's width, 3 px beyond its tip.
TEST(ALabel, MayBeThatOfATriangleShownByRoundedEdges) {
    TestScene t(
        Projection::parallel, 8, 4,
        {{{{90, 90, 4}, {91, 90, 4}, {90, 91, 4}}}, {{{-40, 1.5, 4}, {2.5, 1.5, 4}, {-40, 1.5 + 1e-6, 4}}}});
    answer_everywhere(t.candidate, 7, 4);
    t.candidate_precision = RasterPrecision{.snap = Snap::none, .edge_functions = EdgeFunctions::from_corner};
    EXPECT_EQ(class_by(t, labels({7, 7}), 5, 1), PixelClass::edge);
    EXPECT_EQ(class_by(t, labels({7, 7}), 5, 2), PixelClass::outside) << "beside the line";
}

/// Two triangles of the label hold the depth. The one whose own depth is nearer is hidden at it by the wall
/// in front; the other one shares an edge with that, which hides nothing of it.
TEST(ALabel, NamesTheTriangleThatWinsAtItsDepth) {
    const double step = 64.0 * 64 / (0.25 * 65535), depth = 64 + 1.4 * step;
    const Triangle beside{{{-64, -64, 64}, {192, -64, 64}, {-64, 192, 64 + 3.2 * step}}};
    TestScene t(Projection::perspective, 4, 4, {wall(64), wall(64 + 1.5 * step), beside});
    t.candidate_precision = RasterPrecision{.transform = Arithmetic::float64,
                                            .depth_buffer = DepthBuffer::standard_z,
                                            .depth_format = DepthFormat::unorm16,
                                            .depth_interpolation = DepthInterpolation::barycentrics,
                                            .interpolation = Arithmetic::float64};
    answer_everywhere(t.candidate, 7, depth);
    answer_everywhere(t.reference, 0, 64);
    EXPECT_EQ(class_by(t, labels({5, 7, 7}), 1, 1), PixelClass::depth_tie);
    EXPECT_EQ(class_by(t, labels({5, 7, 5}), 1, 1), PixelClass::wrong_depth);
}

/// A wall at an inverse depth of that many errors of its z more than that of far. Its depth is told as
/// background.
PixelClass class_before_far(double far_depth, double errors, bool is_far_background) {
    TestScene t(Projection::perspective, 2, 2, {wall(std::min(far_depth, 0x1p21))});
    t.view.camera.far_depth = far_depth;
    const bool is_finite = std::isfinite(far_depth);
    const RasterPrecision precision{.transform = Arithmetic::float64,
                                    .depth_buffer = DepthBuffer::standard_z,
                                    .depth_format = is_finite ? DepthFormat::unorm16 : DepthFormat::float32,
                                    .matrix_far = is_finite ? MatrixFar::finite : MatrixFar::infinite,
                                    .depth_interpolation = DepthInterpolation::barycentrics};
    const double error = ViewBounds(t.view, precision).of(corners_of(t.scene, 0)).inverse_depth_error,
                 depth = 1 / (1 / far_depth + errors * error);
    t.scene = scene_of(t.view, {wall(depth)});
    t.candidate_precision = precision;
    answer_everywhere(t.candidate, 99, background_depth);
    answer_everywhere(t.reference, 0, depth);
    TriangleLabels none = depth_alone(t.scene);
    none.is_far_background = is_far_background;
    return class_by(t, none, 1, 1);
}

TEST(DepthAlone, IsNoHoleWhereZMayBeThatOfAnInfiniteFar) {
    EXPECT_EQ(class_before_far(HUGE_VAL, 0.99, false), PixelClass::agree);
    EXPECT_EQ(class_before_far(HUGE_VAL, 1.01, false), PixelClass::hole);
}

TEST(DepthAlone, IsNoHoleWhereADepthAtFarReadsAsBackground) {
    EXPECT_EQ(class_before_far(1024, 0.99, true), PixelClass::agree);
    EXPECT_EQ(class_before_far(1024, 1.01, true), PixelClass::hole);
    EXPECT_EQ(class_before_far(1024, 0.99, false), PixelClass::hole) << "its background is no depth";
}

/// No float32 lies within the bounds of what is never rounded.
TEST(IdsAlone, AreHeldToNoDepth) {
    TestScene t(Projection::perspective, 2, 2, {{{{-64, -64, 4}, {192, -64, 4.3}, {-64, 192, 4.7}}}});
    t.candidate_precision = BoundedPrecision{.eps_px = 1e-9};
    answer_everywhere(t.candidate, 0, 0);
    t.candidate = with_own_depths(t.scene, t.view, t.candidate.primitive, t.candidate_precision);
    answer_everywhere(t.reference, 0, t.candidate.camera_depth.at(1, 1));
    EXPECT_EQ(t.class_at(1, 1), PixelClass::wrong_depth);
    t.candidate_precision = with_any_depth(t.candidate_precision, t.view, t.candidate);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::agree);
}

TEST(ALabel, IsToldBesideTheFinding) {
    TriangleLabels two = labels({7, 5});
    two.names[7] = "Wood";
    EXPECT_EQ(label_sentence(two, PrimitiveId(7)), "; the frame says material 7 (Wood)");
    EXPECT_EQ(label_sentence(two, PrimitiveId(5)), "; the frame says material 5");
    EXPECT_EQ(label_sentence({.ids = "none", .of_triangle = {}, .are_absent = true}, PrimitiveId::none),
              "; the frame has no ids: this triangle stands for its depth");
}

}  // namespace
}  // namespace zproof
