#include "rasterizer/view_setup.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cassert>
#include <cmath>
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

/// Rounding may put a vertex of the guard band's border a hair outside.
bool is_in_guard_band(double coordinate_px, double guard_px) {
    return std::abs(coordinate_px) <= guard_px + 1;
}

}  // namespace

ViewSetup::ViewSetup(const View& view, const Rules& rules, const Tricks& tricks)
    : size{view.width, view.height},
      clip_from_world(view.camera),
      guard_px(guard_band_px(rules.subpixel_bits)),
      volume(volume_of(view, rules)),
      grid(grid_of(rules)),
      depth(depth_functional(view.camera.projection, rules)),
      fill(rules.fill),
      raster_y(rules.raster_y),
      facing(tricks.facing),
      hierarchical_z(tricks.hierarchical_z) {}

std::optional<SnappedVertex> ViewSetup::snap(const ClipVertex& v) const noexcept {
    const double x_ndc = v.x / v.w;
    const double y_ndc = v.y / v.w;
    const double x_raster = (x_ndc + 1) * (0.5 * size.width);
    const double y_raster = (raster_y == RasterY::down ? 1 - y_ndc : 1 + y_ndc) * (0.5 * size.height);
    if (!is_in_guard_band(x_raster, guard_px) || !is_in_guard_band(y_raster, guard_px)) return std::nullopt;
    return SnappedVertex{{grid.snap(x_raster), grid.snap(y_raster)}, depth.of_depth(v.depth)};
}

void ProjectedVertices::fill(const Vertices& vertices, const ViewSetup& setup) {
    const Range all{0, std::uint32_t(vertices.position_world.size())};
    fill(vertices, setup, std::span(&all, 1));
}

void ProjectedVertices::fill(const Vertices& vertices, const ViewSetup& setup,
                             std::span<const Range> ranges) {
    const std::size_t count = vertices.position_world.size();
    snapped.resize(count);
    outcode.resize(count);
    const auto project_one = [&](std::size_t i) {
        const ClipVertex v = setup.clip_from_world(vertices.position_world[i]);
        std::uint8_t code = outcode_of(v, setup.volume);
        if ((code & (outcode::needs_clip | outcode::not_finite)) == 0) {
            if (const auto vertex = setup.snap(v))
                snapped[i] = *vertex;
            else
                code = outcode::not_finite;
        }
        outcode[i] = code;
    };
    for (const Range& r : ranges)
        tbb::parallel_for(tbb::blocked_range<std::size_t>(r.begin, r.end, 1024), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) project_one(i);
        });
}

}  // namespace zproof::rasterizer
