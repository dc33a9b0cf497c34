/// All the ways in which the attack keeps a promise.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/attack/trial.h"

namespace zproof::attack {

/// A promise, and a renderer that keeps it.
struct HonestMode {
    std::string name;
    Precision precision;
    std::function<Frame(const Trial&)> draw;
};

/// Each form of precision, with each of its limits; `seed` chooses what is drawn by lot.
std::vector<HonestMode> honest_modes(const View& view, std::uint64_t seed);

}  // namespace zproof::attack
