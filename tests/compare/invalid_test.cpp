/// Answers that are none: whatever the scene holds, they are the candidate's defect.
#include <gtest/gtest.h>

#include <limits>

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

}  // namespace
}  // namespace zproof
