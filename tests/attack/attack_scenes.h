/// What the attack draws: small pictures of few triangles, of every kind that has ever been hard to judge.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::attack {

struct AttackScene {
    std::string name;  ///< a word of docs/random.md where there is one
    Scene scene;
    View view;
};

/// Made by hand, each for one difficulty.
std::vector<AttackScene> hand_made_scenes();

/// Every view of the suite's scenes of up to `most_triangles`, at 36 x 20 pixels.
std::vector<AttackScene> small_suite_scenes(std::size_t most_triangles);

/// The scene of that number of all kinds of `random:`, kinds taking turns; not larger than 48 x 48 pixels.
AttackScene random_attack_scene(std::uint64_t seed, std::uint64_t number);

}  // namespace zproof::attack
