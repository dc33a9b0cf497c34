#include "rasterizer/triangle_footprints.h"

namespace zproof::rasterizer {

std::optional<TriangleFootprints> footprints_of(const Scene& scene, const View& view,
                                                std::uint32_t triangle) {
    const auto map = texels_from_raster(scene, view, triangle);
    if (!map) return {};
    return TriangleFootprints{*map, RayCones{view, *textured_corners(scene, view, triangle)}};
}

}  // namespace zproof::rasterizer
