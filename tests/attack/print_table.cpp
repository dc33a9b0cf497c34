// Prints the table of docs/attack.md as this build has it:
//
//     attack_table RANDOM_SCENES [SEED]
#include <cstdlib>
#include <iostream>

#include "tests/attack/tightness.h"

int main(int argc, char** argv) {
    using namespace zproof::attack;
    if (argc < 2) return 2;
    const int random_scenes = std::atoi(argv[1]);
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 61;
    Tightness tightness;
    for (const AttackScene& scene : hand_made_scenes()) tightness.plant_in(scene);
    for (int n = 0; n < random_scenes; ++n) {
        const AttackScene scene = random_attack_scene(seed, std::uint64_t(n));
        if (scene.scene.triangles.size() <= most_planted_triangles) tightness.plant_in(scene);
    }
    std::cout << "| wrong | promise | planted | passed | undecidable | passes up to | where |\n"
              << "|---|---|---|---|---|---|---|\n";
    for (const auto& [row, tally] : tightness.rows())
        std::cout << "| " << row.wrong << " | " << row.promise << " | " << tally.planted << " | "
                  << tally.passed << " | " << tally.undecidable << " | " << tally.farthest << " | "
                  << tally.where << " |\n";
}
