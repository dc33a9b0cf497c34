#include "oracle/block_rays.h"

#include <algorithm>

namespace zproof::oracle {
namespace {

constexpr int side = BlockRays::side, lanes = BlockRays::lanes;

/// Where the lines of sight of a block meet the camera's window.
struct OnWindow {
    double u[lanes], v[lanes];
};

[[gnu::always_inline]] inline OnWindow on_window(const View& view, int left, int top) {
    const Window& w = view.camera.window;
    OnWindow at;
    for (int i = 0; i < side; ++i) {
        const double u = w.left + (w.right - w.left) * ((left + i + 0.5) / view.width);
        const double v = w.top - (w.top - w.bottom) * ((top + i + 0.5) / view.height);
        for (int k = 0; k < side; ++k) {
            at.u[k * side + i] = u;
            at.v[i * side + k] = v;
        }
    }
    return at;
}

}  // namespace

BlockRays::BlockRays(const View& view)
    : view_(view),
      any_(primary_ray(view, 0, 0)),
      perspective_(view.camera.projection == Projection::perspective) {
    const Camera& c = view.camera;
    const glm::dvec3 direction = c.shear.x * c.right + c.shear.y * c.up - c.back;
    for (int i = 0; i < 3; ++i)
        varying_[i] = {.first = perspective_ ? 0 : double{c.eye_world[i]},
                       .right = c.right[i],
                       .up = c.up[i],
                       .last = perspective_ ? -c.back[i] : any_.origin_depth * direction[i]};
}

/// Compiled once per instruction set; no bit depends on which runs.
[[gnu::target_clones("default", "avx2", "avx512f")]] void BlockRays::aim(int left, int top,
                                                                         RTCRay16& rays) const {
    const OnWindow at = on_window(view_, left, top);
    float* const origin[] = {rays.org_x, rays.org_y, rays.org_z};
    float* const direction[] = {rays.dir_x, rays.dir_y, rays.dir_z};
    for (int i = 0; i < 3; ++i) {
        const Coordinate along = varying_[i];
        if (perspective_) {
            for (int l = 0; l < lanes; ++l)
                direction[i][l] = float((at.u[l] * along.right + at.v[l] * along.up) + along.last);
            std::fill_n(origin[i], lanes, any_.origin[i]);
        } else {
            for (int l = 0; l < lanes; ++l)
                origin[i][l] =
                    float(((along.first + at.u[l] * along.right) + at.v[l] * along.up) + along.last);
            std::fill_n(direction[i], lanes, any_.direction[i]);
        }
    }
    std::fill_n(rays.tnear, lanes, any_.t_near);
    std::fill_n(rays.tfar, lanes, any_.t_far);
    std::fill_n(rays.time, lanes, 0.0f);
    std::fill_n(rays.mask, lanes, ~0u);
    std::fill_n(rays.flags, lanes, 0u);
    for (int lane = 0; lane < lanes; ++lane) rays.id[lane] = unsigned(lane);
}

}  // namespace zproof::oracle
