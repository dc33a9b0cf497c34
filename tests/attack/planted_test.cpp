/// Tight beyond: a pixel that needs a hundredth more than was promised is a defect.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "tests/attack/planting.h"

namespace zproof::attack {
namespace {

/// What was planted of one kind, and the worst that passed.
struct Tally {
    std::uint64_t planted = 0, passed = 0, undecidable = 0;
    double worst = 0;
};
using Tallies = std::map<std::string, Tally>;  ///< by class and promise

void hold(const PlantedFrame& planted, const Verdict& verdict, const std::string& what,
          const std::string& promise, Tallies& tallies) {
    for (const PlantedPixel& p : planted.pixels) {
        Tally& tally = tallies[std::string(name_of(p.kind)) + ", " + promise];
        ++tally.planted;
        const PixelClass said = verdict.classes.at(p.x, p.y);
        if (is_defect(said)) continue;
        if (said == PixelClass::undecidable) {
            ++tally.undecidable;
            continue;
        }
        ++tally.passed;
        tally.worst = std::max(tally.worst, p.factor);
        if (tally.passed <= 3)
            ADD_FAILURE() << what << " (" << p.x << ", " << p.y << "): " << name_of(p.kind) << " by "
                          << p.factor << " times the promise is called " << name_of(said) << ": triangle "
                          << int(planted.frame.primitive.at(p.x, p.y)) << " depth "
                          << planted.frame.camera_depth.at(p.x, p.y);
    }
}

void print(const Tallies& tallies) {
    for (const auto& [kind, t] : tallies)
        std::printf("%s: %lu planted, %lu passed, %lu undecidable, worst %g\n", kind.c_str(), t.planted,
                    t.passed, t.undecidable, t.worst);
}

std::string depth_words(const BoundedPrecision& p) {
    std::ostringstream text;
    text << "eps_px=" << p.eps_px << ",depth_relative=" << p.depth_relative
         << ",depth_absolute=" << p.depth_absolute;
    return text.str();
}

void plant(const AttackScene& scene, Tallies& tallies) {
    const Trial trial(scene);
    constexpr double share = 1e-6;
    for (const Sharing sharing : {Sharing::alike, Sharing::apart}) {
        const WrongPlaces wrong(trial, share, sharing);
        const std::vector<double> needs = wrong.needs();
        if (needs.empty()) continue;
        for (const double factor : {1.01, 1.1, 2.0})
            for (const std::size_t of_all : {2, 4, 8}) {
                const double eps_px = needs[needs.size() / of_all] / factor;
                if (eps_px < 0x1p-18) continue;
                const BoundedPrecision promise{
                    .eps_px = eps_px, .depth_relative = share, .watertight = sharing == Sharing::alike};
                const PlantedFrame planted = wrong.planted(eps_px, factor);
                hold(planted, trial.judge_of(planted.frame, promise),
                     scene.name + " eps_px=" + std::to_string(eps_px),
                     promise.watertight ? "displacement" : "displacement, apart", tallies);
            }
    }
    for (const double factor : {1.01, 1.1, 2.0})
        for (const BoundedPrecision& promise : {BoundedPrecision{.eps_px = 1e-5, .depth_relative = 1e-5},
                                                BoundedPrecision{.eps_px = 0.01, .depth_relative = 1e-4},
                                                BoundedPrecision{.eps_px = 1e-5, .depth_absolute = 0.01},
                                                BoundedPrecision{.eps_px = 0.1, .depth_relative = 0.5}})
            for (const DepthFrom from : {DepthFrom::square, DepthFrom::own_part}) {
                const PlantedFrame planted = with_wrong_depths(trial, promise, from, factor);
                hold(planted, trial.judge_of(planted.frame, promise), scene.name,
                     depth_words(promise) + (from == DepthFrom::own_part ? ", own part" : ""), tallies);
            }
}

TEST(TightBeyond, InHandMadeScenes) {
    Tallies tallies;
    for (const AttackScene& scene : hand_made_scenes()) plant(scene, tallies);
    print(tallies);
}

TEST(TightBeyond, InRandomScenes) {
    Tallies tallies;
    for (std::uint64_t n = 0; n < 36; ++n) {
        const AttackScene scene = random_attack_scene(61, n);
        if (scene.scene.triangles.size() > 60) continue;
        plant(scene, tallies);
    }
    print(tallies);
}

}  // namespace
}  // namespace zproof::attack
