#include "rasterizer/projection.h"

namespace zproof::rasterizer {
namespace {

struct Interval {
    double at_near, at_far;
};

Interval ndc_interval(NdcDepth range) {
    switch (range) {
        case NdcDepth::minus_one_to_one:
            return {-1, 1};
        case NdcDepth::zero_to_one:
            return {0, 1};
        case NdcDepth::zero_to_one_reversed:
            return {1, 0};
    }
    return {-1, 1};
}

/// z_ndc = A + B / depth with z_ndc(near) and z_ndc(far) given; n / f and B / f are 0 for an infinite far
/// plane.
void set_perspective_depth(glm::dmat4& clip, const Camera& camera) {
    const Interval ndc = ndc_interval(camera.ndc_depth);
    const double near = camera.near_depth, far = camera.far_depth;
    const double b = (ndc.at_near - ndc.at_far) * near / (1 - near / far);
    const double a = ndc.at_far - b / far;
    clip[2][2] = -a;
    clip[3][2] = b;
}

/// z_ndc is affine in depth.
void set_parallel_depth(glm::dmat4& clip, const Camera& camera) {
    const Interval ndc = ndc_interval(camera.ndc_depth);
    const double slope = (ndc.at_far - ndc.at_near) / (camera.far_depth - camera.near_depth);
    clip[2][2] = -slope;
    clip[3][2] = ndc.at_near - slope * camera.near_depth;
}

/// x_screen = x / -z and w = -z turn 2 x_screen / (r - l) - (r + l) / (r - l) into the rows below.
glm::dmat4 perspective(const Camera& camera) {
    const auto [l, r, b, t] = camera.window;
    glm::dmat4 clip{0.0};
    clip[0][0] = 2 / (r - l);
    clip[2][0] = (r + l) / (r - l);
    clip[1][1] = 2 / (t - b);
    clip[2][1] = (t + b) / (t - b);
    clip[2][3] = -1;
    set_perspective_depth(clip, camera);
    return clip;
}

/// A point of camera depth -z is seen at x_screen = x + shear.x z: the view ray through it meets the
/// plane through the eye there.
glm::dmat4 parallel(const Camera& camera) {
    const auto [l, r, b, t] = camera.window;
    glm::dmat4 clip{0.0};
    clip[0][0] = 2 / (r - l);
    clip[2][0] = camera.shear.x * 2 / (r - l);
    clip[3][0] = -(r + l) / (r - l);
    clip[1][1] = 2 / (t - b);
    clip[2][1] = camera.shear.y * 2 / (t - b);
    clip[3][1] = -(t + b) / (t - b);
    clip[3][3] = 1;
    set_parallel_depth(clip, camera);
    return clip;
}

Row row(const glm::dmat4& m, int i) { return {m[0][i], m[1][i], m[2][i], m[3][i]}; }

}  // namespace

glm::dmat4 camera_from_world(const Camera& camera) {
    const glm::dvec3 eye{camera.eye_world};
    glm::dmat4 m{1.0};
    const glm::dvec3 axes[] = {camera.right, camera.up, camera.back};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) m[k][i] = axes[i][k];
        m[3][i] = -((axes[i].x * eye.x + axes[i].y * eye.y) + axes[i].z * eye.z);
    }
    return m;
}

glm::dmat4 clip_from_camera(const Camera& camera) {
    return camera.projection == Projection::perspective ? perspective(camera) : parallel(camera);
}

ClipTransform::ClipTransform(const Camera& camera) : projection_(camera.projection) {
    const glm::dmat4 camera_matrix = camera_from_world(camera);
    const glm::dmat4 clip_from_world = clip_from_camera(camera) * camera_matrix;
    x_row_ = row(clip_from_world, 0);
    y_row_ = row(clip_from_world, 1);
    depth_row_ = row(-camera_matrix, 2);
}

}  // namespace zproof::rasterizer
