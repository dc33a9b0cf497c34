#include "scenes/shrink.h"

#include <utility>

#include "scenes/judged_ranges.h"
#include "scenes/scene_error.h"
#include "scenes/shrink/attempts.h"

namespace zproof {
namespace {

bool is_judged(const SceneAndView& of) {
    try {
        validate(of.view.camera);
    } catch (const SceneError&) {
        return false;
    }
    return outside_judged_ranges(of.scene).empty() && outside_judged_ranges(of.view).empty();
}

SceneAndView of_positions_alone(SceneAndView full) {
    Vertices positions;
    positions.position_world = std::move(full.scene.vertices.position_world);
    full.scene.vertices = std::move(positions);
    full.scene.images.clear();
    full.scene.notes.clear();
    for (Material& material : full.scene.materials) material.base_color = {};
    return full;
}

}  // namespace

bool shrinking::Attempts::keep(SceneAndView smaller) {
    for (glm::vec3& p : smaller.scene.vertices.position_world) p += glm::vec3(0);  // of -0 makes 0
    if (are_over() || !is_judged(smaller)) return false;
    ++tries_;
    if (!still_fails_(smaller) || limits_.is_stopped()) return false;
    least_ = std::move(smaller);
    ++kept_;
    return true;
}

Shrunk shrink(const SceneAndView& failing, const StillFails& still_fails, const ShrinkLimits& limits) {
    shrinking::Attempts attempts(failing, still_fails, limits);
    attempts.keep(of_positions_alone(failing));
    int before = 0;
    do {
        before = attempts.kept();
        drop_triangles(attempts);
        crop_picture(attempts);
        simplify_camera(attempts);
        shorten_coordinates(attempts);
    } while (attempts.kept() > before && !attempts.are_over());
    return {attempts.least(), attempts.tries()};
}

}  // namespace zproof
