#include <cmath>
#include <limits>
#include <vector>

#include "scenes/shrink/attempts.h"
#include "scenes/shrink/digits.h"

namespace zproof::shrinking {
namespace {

void set_axes(Camera& camera, const glm::dmat3& axes) {
    camera.right = axes[0];
    camera.up = axes[1];
    camera.back = axes[2];
}

/// The scene as the camera sees it: the eye at the origin, the world's axes its own.
SceneAndView in_camera_space(SceneAndView at) {
    Camera& c = at.view.camera;
    for (glm::vec3& p : at.scene.vertices.position_world) {
        const glm::dvec3 from_eye = glm::dvec3(p) - glm::dvec3(c.eye_world);
        p = glm::vec3(glm::dot(from_eye, c.right), glm::dot(from_eye, c.up), glm::dot(from_eye, c.back));
    }
    c.eye_world = glm::vec3(0);
    set_axes(c, glm::dmat3(1));
    return at;
}

/// Moved as a whole, so that the eye is at the origin.
SceneAndView with_eye_at_origin(SceneAndView at) {
    for (glm::vec3& p : at.scene.vertices.position_world) p -= at.view.camera.eye_world;
    at.view.camera.eye_world = glm::vec3(0);
    return at;
}

/// Larger or smaller as a whole, by a power of two: near lies between 1 and 2. Of a perspective view.
SceneAndView with_near_at_one(SceneAndView at) {
    Camera& c = at.view.camera;
    const int exponent = -std::ilogb(c.near_depth);
    const auto scaled = [&](auto& value) { value = std::ldexp(value, exponent); };
    scaled(c.near_depth);
    scaled(c.far_depth);
    for (int axis = 0; axis < 3; ++axis) {
        scaled(c.eye_world[axis]);
        for (glm::vec3& p : at.scene.vertices.position_world) scaled(p[axis]);
    }
    return at;
}

template <class Change>
void try_camera(Attempts& attempts, const Change& change) {
    SceneAndView changed = attempts.least();
    change(changed.view);
    attempts.keep(std::move(changed));
}

void try_plain_facts(Attempts& attempts) {
    const Camera& c = attempts.least().view.camera;
    if (c.ndc_depth != NdcDepth::minus_one_to_one)
        try_camera(attempts, [](View& v) { v.camera.ndc_depth = NdcDepth::minus_one_to_one; });
    if (c.shear != glm::dvec2(0)) try_camera(attempts, [](View& v) { v.camera.shear = glm::dvec2(0); });
    if (c.projection == Projection::perspective && std::isfinite(c.far_depth))
        try_camera(attempts, [](View& v) { v.camera.far_depth = std::numeric_limits<double>::infinity(); });
}

void try_plain_pose(Attempts& attempts) {
    const auto is_plain = [&] {
        const Camera& c = attempts.least().view.camera;
        return c.eye_world == glm::vec3(0) && glm::dmat3(c.right, c.up, c.back) == glm::dmat3(1);
    };
    if (is_plain() || attempts.keep(in_camera_space(attempts.least()))) return;
    if (attempts.least().view.camera.eye_world != glm::vec3(0))
        attempts.keep(with_eye_at_origin(attempts.least()));
    try_camera(attempts, [](View& v) { set_axes(v.camera, glm::dmat3(1)); });
}

using NumberOf = double& (*)(Camera&);

constexpr NumberOf numbers_of_camera[] = {
    [](Camera& c) -> double& { return c.near_depth; },    [](Camera& c) -> double& { return c.far_depth; },
    [](Camera& c) -> double& { return c.window.left; },   [](Camera& c) -> double& { return c.window.right; },
    [](Camera& c) -> double& { return c.window.bottom; }, [](Camera& c) -> double& { return c.window.top; },
    [](Camera& c) -> double& { return c.shear.x; },       [](Camera& c) -> double& { return c.shear.y; }};

void shorten(Attempts& attempts, NumberOf number) {
    Camera camera = attempts.least().view.camera;
    const double value = number(camera);
    if (!std::isfinite(value)) return;
    for (const int digits : digit_counts) {
        if (digits >= digits_of(value)) return;
        SceneAndView shorter = attempts.least();
        number(shorter.view.camera) = rounded_to(value, digits);
        if (attempts.keep(std::move(shorter))) return;
    }
}

}  // namespace

void simplify_camera(Attempts& attempts) {
    try_plain_facts(attempts);
    try_plain_pose(attempts);
    const Camera& c = attempts.least().view.camera;
    if (c.projection == Projection::perspective && std::ilogb(c.near_depth) != 0)
        attempts.keep(with_near_at_one(attempts.least()));
    for (const NumberOf number : numbers_of_camera)
        if (!attempts.are_over()) shorten(attempts, number);
}

}  // namespace zproof::shrinking
