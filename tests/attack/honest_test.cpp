/// Adversarial honesty: whoever keeps its promise at the limits is proven.
#include <gtest/gtest.h>

#include <map>

#include "tests/attack/honest_modes.h"

namespace zproof::attack {
namespace {

struct Count {
    std::uint64_t frames = 0, defects = 0, undecidable = 0;
};

/// Every mode on the scene.
Count hold(const AttackScene& scene, std::uint64_t seed) {
    Count count;
    const Trial trial(scene);
    for (const HonestMode& mode : honest_modes(scene.view, seed)) {
        const Verdict verdict = trial.judge_of(mode.draw(trial), mode.precision);
        ++count.frames;
        count.defects += defect_count(verdict);
        count.undecidable += undecidable_count(verdict);
        EXPECT_EQ(defect_count(verdict), 0u)
            << scene.name << ", " << mode.name << ": " << first_defect(verdict);
    }
    return count;
}

TEST(AdversarialHonesty, OfHandMadeScenes) {
    Count count;
    for (const AttackScene& scene : hand_made_scenes()) hold(scene, 1);
}

TEST(AdversarialHonesty, OfRandomScenes) {
    for (std::uint64_t n = 0; n < 36; ++n) {
        const AttackScene scene = random_attack_scene(60, n);
        if (scene.scene.triangles.size() > 150) continue;
        hold(scene, n);
    }
}

}  // namespace
}  // namespace zproof::attack
