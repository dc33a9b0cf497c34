/// Adversarial honesty: whoever keeps its promise at the limits is proven.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "tests/attack/honest_modes.h"

namespace zproof::attack {
namespace {

/// With more, a frame takes too long for ten thousands of them.
constexpr std::size_t most_triangles = 150;

struct Count {
    std::uint64_t mode_views = 0, undecidable_views = 0, undecidable_pixels = 0, at_known_limit = 0;

    Count& operator+=(const Count& other) {
        mode_views += other.mode_views;
        undecidable_views += other.undecidable_views;
        undecidable_pixels += other.undecidable_pixels;
        at_known_limit += other.at_known_limit;
        return *this;
    }
};

bool tests_edges_before_the_divide(const Precision& precision) {
    const auto* raster = std::get_if<RasterPrecision>(&precision);
    return raster ? raster->edge_functions == EdgeFunctions::homogeneous
                  : std::holds_alternative<RayPrecision>(precision);
}

/// docs/truth.md, "Known limits": a triangle thinner than the rounding of its edge tests, met beyond its
/// ends.
bool is_at_known_limit(const Finding& finding, const Precision& precision, const ExactScene& truth) {
    if (finding.verdict != PixelClass::outside || !tests_edges_before_the_divide(precision)) return false;
    const Image<double>& image = truth.rounded(std::size_t(finding.candidate.primitive));
    double longest = 0;
    for (const auto& a : image)
        for (const auto& b : image) longest = std::max({longest, std::abs(a.x - b.x), std::abs(a.y - b.y)});
    return image.empty() || std::abs(twice_area(image)) <= 2 * finding.eps_px * longest;
}

/// Every mode on the scene.
Count hold(const AttackScene& scene, std::uint64_t seed) {
    Count count;
    const Trial trial(scene);
    for (const HonestMode& mode : honest_modes(scene.view, seed)) {
        const Verdict verdict = trial.judge_of(mode.draw(trial), mode.precision);
        const auto known = std::uint64_t(std::ranges::count_if(verdict.findings, [&](const Finding& f) {
            return is_at_known_limit(f, mode.precision, trial.truth());
        }));
        EXPECT_EQ(defect_count(verdict), known)
            << scene.name << ", " << mode.name << ": " << first_defect(verdict);
        count.at_known_limit += known;
        ++count.mode_views;
        count.undecidable_views += undecidable_count(verdict) > 0 ? 1 : 0;
        count.undecidable_pixels += undecidable_count(verdict);
    }
    return count;
}

void report(const Count& count) {
    std::cout << count.mode_views << " mode-views; undecidable: " << count.undecidable_pixels << " pixels of "
              << count.undecidable_views << "; beyond the ends of needles: " << count.at_known_limit << "\n";
}

constexpr std::size_t slices = 4;

class AdversarialHonesty : public testing::TestWithParam<std::size_t> {};

TEST_P(AdversarialHonesty, IsProvenInHandMadeScenes) {
    Count count;
    const std::vector<AttackScene> scenes = hand_made_scenes();
    for (std::size_t i = GetParam(); i < scenes.size(); i += slices) count += hold(scenes[i], i);
    report(count);
}

TEST_P(AdversarialHonesty, IsProvenInRandomScenes) {
    Count count;
    for (std::uint64_t n = GetParam(); n < 12; n += slices) {
        const AttackScene scene = random_attack_scene(60, n);
        if (scene.scene.triangles.size() <= most_triangles) count += hold(scene, n);
    }
    report(count);
}

INSTANTIATE_TEST_SUITE_P(Sample, AdversarialHonesty, testing::Range<std::size_t>(0, slices));

/// A place beyond two edges by their weights' tolerance, the depth of a mean with rounded weights, corners
/// that the promise moves by much of the triangle's height, a triangle that lies on near but for rounding,
/// diagonals of what is left where a corner lies between two places of near or far.
TEST(FoundByTheAttack, IsProvenWhereAnEpsByItselfDoesNotTell) {
    Count count;
    for (const auto& [seed, number] :
         {std::pair{100, 90}, {100, 11}, {101, 59}, {100, 93}, {106, 12}, {103, 84}, {107, 85}})
        count += hold(random_attack_scene(std::uint64_t(seed), std::uint64_t(number)), std::uint64_t(number));
    report(count);
}

/// 12 500 mode-views each.
class AdversarialHonestyAtScale : public testing::TestWithParam<std::uint64_t> {};

TEST_P(AdversarialHonestyAtScale, IsProven) {
    Count count;
    const std::vector<AttackScene> suite = small_suite_scenes(most_triangles);
    for (std::size_t i = GetParam(); i < suite.size(); i += 8) count += hold(suite[i], i);
    for (std::uint64_t n = 0; count.mode_views < 12'500; ++n) {
        const AttackScene scene = random_attack_scene(100 + GetParam(), n);
        if (scene.scene.triangles.size() <= most_triangles) count += hold(scene, n);
    }
    report(count);
}

INSTANTIATE_TEST_SUITE_P(Slow, AdversarialHonestyAtScale, testing::Range<std::uint64_t>(0, 8));

}  // namespace
}  // namespace zproof::attack
