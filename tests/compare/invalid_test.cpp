/// Answers that are none: whatever the scene holds, they are the candidate's defect.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "compare/bounds/triangle_depth.h"
#include "test_scene.h"

namespace zproof {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t none = std::uint32_t(PrimitiveId::none);

struct Odd {
    const char* name;
    std::uint32_t triangle;
    double depth;
    PixelClass expected;
};

class OddAnswer : public testing::TestWithParam<Odd> {};

INSTANTIATE_TEST_SUITE_P(Answers, OddAnswer,
                         testing::Values(Odd{"NanDepth", 0, std::numeric_limits<double>::quiet_NaN(),
                                             PixelClass::invalid},
                                         Odd{"NegativeDepth", 0, -4, PixelClass::invalid},
                                         Odd{"MinusInfinity", 0, -infinity, PixelClass::invalid},
                                         Odd{"IdOnePastTheLast", 1, 4, PixelClass::invalid},
                                         Odd{"IdFarOut", none - 1, 4, PixelClass::invalid},
                                         Odd{"BackgroundWithADepth", none, 4, PixelClass::invalid},
                                         Odd{"BackgroundWithNan", none,
                                             std::numeric_limits<double>::quiet_NaN(), PixelClass::invalid},
                                         Odd{"ATriangleInfinitelyFar", 0, infinity, PixelClass::wrong_depth},
                                         Odd{"ATriangleAtZero", 0, 0, PixelClass::wrong_depth}),
                         [](const auto& odd) { return odd.param.name; });

TestScene agreed_scene() {
    TestScene t(Projection::perspective, 4, 4, {wall(4)});
    answer_everywhere(t.candidate, 0, 4);
    answer_everywhere(t.reference, 0, 4);
    return t;
}

TEST_P(OddAnswer, OfTheCandidateFailsTheGate) {
    TestScene t = agreed_scene();
    answer(t.candidate, 1, 1, GetParam().triangle, GetParam().depth);
    const Verdict verdict = t.verdict();
    EXPECT_EQ(verdict.classes.at(1, 1), GetParam().expected);
    EXPECT_EQ(defect_count(verdict), 1u);
    EXPECT_EQ(verdict.reference_defects, 0u);
}

TEST_P(OddAnswer, OfTheReferenceIsTheReferencesDefect) {
    TestScene t = agreed_scene();
    answer(t.reference, 1, 1, GetParam().triangle, GetParam().depth);
    const Verdict verdict = t.verdict();
    EXPECT_EQ(verdict.classes.at(1, 1), PixelClass::reference_wrong);
    EXPECT_EQ(defect_count(verdict), 0u);
    EXPECT_EQ(verdict.reference_defects, 1u);
}

TEST_P(OddAnswer, OfBothIsADefectOfBoth) {
    TestScene t = agreed_scene();
    answer(t.candidate, 1, 1, GetParam().triangle, GetParam().depth);
    answer(t.reference, 1, 1, GetParam().triangle, GetParam().depth);
    const Verdict verdict = t.verdict();
    EXPECT_EQ(verdict.classes.at(1, 1), GetParam().expected);
    EXPECT_EQ(verdict.reference_defects, 1u);
}

TEST(OddAnswers, TheLastTriangleAndDepthZeroBehindTheEyePlaneAreAnswers) {
    TestScene t(Projection::parallel, 1, 1, {wall(0)});
    t.view.camera.near_depth = -1;
    answer(t.candidate, 0, 0, 0, 0);
    answer(t.reference, 0, 0, 0, 0);
    EXPECT_EQ(t.class_at(0, 0), PixelClass::agree);
}

TEST(OddAnswers, NegativeDepthsAreAnswersOfViewsThatShowWhatIsBehindTheEye) {
    TestScene t(Projection::parallel, 1, 1, {wall(-0.5)});
    t.view.camera.near_depth = -1;
    answer(t.reference, 0, 0, 0, -0.5);
    for (const auto& [depth, expected] : {std::pair{-0.5, PixelClass::agree},
                                          {-0.51, PixelClass::wrong_depth},
                                          {-0.49, PixelClass::wrong_depth},
                                          {0.5, PixelClass::wrong_depth}}) {
        answer(t.candidate, 0, 0, 0, depth);
        EXPECT_EQ(t.class_at(0, 0), expected) << depth;
    }
}

/// A wall near the eye, beside a promise whose depths reach below 0.
TestScene near_the_eye(Projection projection) {
    TestScene t(projection, 2, 2, {wall(0.25)});
    t.candidate_precision = BoundedPrecision{.eps_px = 0.01, .depth_absolute = 0.5};
    answer_everywhere(t.candidate, 0, 0.25);
    answer_everywhere(t.reference, 0, 0.25);
    return t;
}

TEST(OddAnswers, ANegativeDepthIsOneWhereItsBoundAdmitsIt) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        TestScene t = near_the_eye(projection);
        for (const auto& [depth, expected] : {std::pair{-0.25f, PixelClass::agree},
                                              {std::nextafter(-0.25f, -1.f), PixelClass::invalid},
                                              {-0.2525f, PixelClass::invalid},
                                              {-float(infinity), PixelClass::invalid}}) {
            answer(t.candidate, 1, 1, 0, depth);
            EXPECT_EQ(t.class_at(1, 1), expected) << depth;
        }
    }
}

TEST(OddAnswers, ANegativeDepthWithinItsBoundIsNoDefectOfTheReference) {
    TestScene t = near_the_eye(Projection::perspective);
    std::swap(t.candidate_precision, t.reference_precision);
    answer(t.reference, 1, 1, 0, -0.25);
    EXPECT_EQ(t.verdict().reference_defects, 0u);
    answer(t.reference, 1, 1, 0, -0.26);
    EXPECT_EQ(t.verdict().reference_defects, 1u);
}

TEST(OddAnswers, ANegativeDepthIsNoneWhereNothingBoundsIt) {
    TestScene t(Projection::perspective, 4, 4, {{{{1, 1, 4}, {2, 2, 4}, {3, 3, 8}}}});
    answer_everywhere(t.candidate, 0, -4);
    answer_everywhere(t.reference, 0, 4);
    t.candidate_precision = ray_precision();
    EXPECT_EQ(t.class_at(1, 1), PixelClass::invalid) << "a triangle seen edge-on";
}

/// Standard z of 16 bits before an infinite far plane: beyond some depth, z may round to 1.
struct FarAway : TestScene {
    explicit FarAway(double depth) : TestScene(Projection::perspective, 2, 2, {wall(depth)}) {
        view.camera.near_depth = 1.0 / 1024;
        view.camera.far_depth = infinity;
        candidate_precision = RasterPrecision{.depth_buffer = DepthBuffer::standard_z,
                                              .depth_format = DepthFormat::unorm16,
                                              .matrix_far = MatrixFar::infinite};
        answer_everywhere(candidate, 0, depth);
        answer_everywhere(reference, 0, depth);
        answer(candidate, 1, 1, 0, infinity);
    }
};

TEST(OddAnswers, ATriangleIsInfinitelyFarWhereItsBoundHasNoEnd) {
    int admitted = 0, refused = 0;
    for (double depth = 1; depth < 4096; depth *= 1.25) {
        const FarAway t(depth);
        const Verdict verdict = t.verdict();
        const ViewBounds bounds(t.view, t.candidate_precision);
        const TriangleInView triangle(t.view, bounds, corners_of(t.scene, 0));
        const bool is_endless = std::isinf(TriangleDepth(triangle, bounds).at(1, 1).high);
        EXPECT_EQ(verdict.classes.at(1, 1), is_endless ? PixelClass::agree : PixelClass::wrong_depth)
            << depth;
        EXPECT_EQ(verdict.classes.at(0, 0), PixelClass::agree);
        EXPECT_EQ(std::isinf(verdict.candidate_depth.max_error_over_bound), !is_endless) << depth;
        ++(is_endless ? admitted : refused);
    }
    EXPECT_GT(admitted, 5);
    EXPECT_GT(refused, 5);
}

TEST(OddAnswers, BackgroundAndMinusInfinityAreNeverATriangleFarAway) {
    FarAway t(2048);
    for (const double depth : {-infinity, -1e30}) {
        answer(t.candidate, 1, 1, 0, depth);
        EXPECT_EQ(t.class_at(1, 1), PixelClass::invalid) << depth;
    }
    answer_background(t.candidate, 1, 1);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::hole);
}

}  // namespace
}  // namespace zproof
