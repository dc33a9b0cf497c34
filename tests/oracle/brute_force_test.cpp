#include "brute_force.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/embree.h"
#include "scenes_at_random.h"

namespace zproof::oracle {
namespace {

struct Tally {
    int pixels = 0, certain = 0, certain_and_covered = 0;
};

std::string story(const View& view, int x, int y) {
    return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") of " + std::to_string(view.width) +
           " x " + std::to_string(view.height);
}

void expect_certain_answers(const Scene& scene, const View& view, Tally& tally) {
    const Frame frame = Embree(scene).trace(view);
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            ++tally.pixels;
            const auto expected = certain_answer(scene, view, x, y);
            if (!expected) continue;
            ++tally.certain;
            ASSERT_EQ(frame.primitive.at(x, y), expected->primitive) << story(view, x, y);
            const float depth = frame.camera_depth.at(x, y);
            if (expected->primitive == PrimitiveId::none) {
                ASSERT_EQ(depth, background_depth) << story(view, x, y);
                continue;
            }
            ++tally.certain_and_covered;
            ASSERT_LE(std::abs(depth - expected->depth), expected->depth_error) << story(view, x, y);
        }
    }
}

/// 40 scenes: where float32 cannot be mistaken, Embree is not.
void expect_agreement(Lens lens) {
    Tally tally;
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Dice dice(seed);
        const View view = random_view(dice, lens);
        expect_certain_answers(random_soup(dice, view.camera, 40), view, tally);
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(tally.certain, tally.pixels * 99 / 100) << "the bounds have become too loose to say anything";
    EXPECT_GT(tally.certain_and_covered, tally.pixels / 3)
        << "the scenes have become too empty to say anything";
}

TEST(BruteForce, AgreesWithEmbreeInPerspective) { expect_agreement(Lens::perspective); }
TEST(BruteForce, AgreesWithEmbreeOffAxis) { expect_agreement(Lens::off_axis); }
TEST(BruteForce, AgreesWithEmbreeInOrthographicViews) { expect_agreement(Lens::orthographic); }
TEST(BruteForce, AgreesWithEmbreeInObliqueViews) { expect_agreement(Lens::oblique); }

}  // namespace
}  // namespace zproof::oracle
