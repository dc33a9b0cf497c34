#include "rasterizer/view_setup.h"

#include <cassert>
#include <limits>

namespace zproof::rasterizer {
namespace {

/// Just before the eye, where 1 / depth is still an ordinary float32.
double depth_before_the_eye(Projection projection) {
    return projection == Projection::perspective ? 0x1p-64 : -std::numeric_limits<double>::infinity();
}

/// x_raster = (x_ndc + 1) W / 2 stays within the guard band for |x_ndc| <= 2 guard_px / W - 1.
double guard_in_ndc(double guard_px, int pixels) {
    assert(pixels >= 1 && pixels <= 32768 && pixels <= guard_px);
    return 2 * guard_px / pixels - 1;
}

ClipVolume volume_of(const View& view, const Rules& rules) {
    const Camera& camera = view.camera;
    const double guard_px = guard_band_px(rules.subpixel_bits);
    const bool at_near_plane = rules.near_clip == NearClip::at_near_plane;
    return {.near_depth = at_near_plane ? camera.near_depth : depth_before_the_eye(camera.projection),
            .far_depth = camera.far_depth,
            .guard_x = guard_in_ndc(guard_px, view.width),
            .guard_y = guard_in_ndc(guard_px, view.height),
            .projection = camera.projection};
}

SubpixelGrid grid_of(const Rules& rules) {
    assert(rules.subpixel_bits >= 1 && rules.subpixel_bits <= 12);
    SubpixelGrid grid{.bits = rules.subpixel_bits, .snapping = rules.snap};
    grid.sample_offset = grid.snap(rules.sample_offset_px);
    return grid;
}

/// The sample lies on the grid, or the rules are no declared renderer's.
SnappedPoint sample_of(const View& view, const SubpixelGrid& grid) {
    const glm::dvec2 steps = view.sample.offset_px * double(grid.steps_per_pixel());
    assert(steps == glm::floor(steps));
    return {std::int32_t(steps.x), std::int32_t(steps.y)};
}

}  // namespace

ViewSetup::ViewSetup(const View& view, const Rules& rules, const Optimizations& optimizations)
    : size{view.width, view.height},
      clip_from_world(view.camera),
      guard_px(guard_band_px(rules.subpixel_bits)),
      volume(volume_of(view, rules)),
      grid(grid_of(rules)),
      sample(sample_of(view, grid)),
      depth(depth_functional(view.camera.projection, rules)),
      fill(rules.fill),
      raster_y(rules.raster_y),
      facing(optimizations.facing),
      hierarchical_z(optimizations.hierarchical_z) {}

std::optional<SnappedVertex> ViewSetup::snap(const ClipVertex& v) const noexcept {
    const GuardedVertex guarded = land(v);
    return guarded.in_guard_band ? std::optional{guarded.vertex} : std::nullopt;
}

}  // namespace zproof::rasterizer
