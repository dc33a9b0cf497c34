/// What the pixels that show one triangle cover of its texture.
#pragma once

#include <optional>

#include "rasterizer/ray_cones.h"
#include "rasterizer/texel_map.h"

namespace zproof::rasterizer {

class TriangleFootprints {
  public:
    TriangleFootprints(const Homography<double>& texels_from_raster, const RayCones& cones)
        : map_{texels_from_raster}, cones_{cones} {}

    /// The footprint of pixel (x, y), with the cone of its ray.
    texture::Footprint at(int x, int y, texture::Derivatives derivatives) const {
        texture::Footprint seen = texture::footprint(map_, x, y, derivatives);
        seen.cone = cones_.at(seen.centre_raster);
        return seen;
    }

  private:
    Homography<double> map_;
    RayCones cones_;
};

/// By perspective; none where there is no texels_from_raster(). The id must be a triangle of the scene.
inline std::optional<TriangleFootprints> footprints_of(const Scene& scene, const View& view,
                                                       std::uint32_t triangle) {
    const auto map = texels_from_raster(scene, view, triangle);
    if (!map) return {};
    return TriangleFootprints{*map, RayCones{view, *textured_corners(scene, view, triangle)}};
}

}  // namespace zproof::rasterizer
