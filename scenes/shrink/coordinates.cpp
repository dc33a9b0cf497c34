#include <algorithm>
#include <cmath>

#include "scenes/shrink/attempts.h"
#include "scenes/shrink/digits.h"

namespace zproof::shrinking {
namespace {

float shortened(float value, int digits) {
    return digits_of(value) <= digits ? value : float(rounded_to(value, digits));
}

/// All of them at once, to as few digits as will do.
void shorten_all(Attempts& attempts) {
    for (const int digits : digit_counts) {
        if (digits == 0) continue;
        SceneAndView shorter = attempts.least();
        bool differs = false;
        for (glm::vec3& p : shorter.scene.vertices.position_world)
            for (int axis = 0; axis < 3; ++axis) {
                const float value = shortened(p[axis], digits);
                differs |= value != p[axis];
                p[axis] = value;
            }
        if (differs && attempts.keep(std::move(shorter))) return;
    }
}

void shorten_one(Attempts& attempts, std::size_t vertex, int axis) {
    const float value = attempts.least().scene.vertices.position_world[vertex][axis];
    for (const int digits : digit_counts) {
        if (digits >= digits_of(value)) return;
        SceneAndView shorter = attempts.least();
        shorter.scene.vertices.position_world[vertex][axis] = shortened(value, digits);
        if (attempts.keep(std::move(shorter))) return;
    }
}

}  // namespace

void shorten_coordinates(Attempts& attempts) {
    shorten_all(attempts);
    const std::size_t count = attempts.least().scene.vertices.position_world.size();
    for (std::size_t vertex = 0; vertex < count; ++vertex)
        for (int axis = 0; axis < 3 && !attempts.are_over(); ++axis) shorten_one(attempts, vertex, axis);
}

}  // namespace zproof::shrinking
