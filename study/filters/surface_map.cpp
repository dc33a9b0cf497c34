#include "study/filters/surface_map.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "rasterizer/texel_map.h"
#include "texture/lod.h"

namespace zproof::study {

namespace {

/// The maps of the triangles of a row of pixels: a run of one triangle finds its map once.
class MapOfRun {
  public:
    MapOfRun(const Scene& scene, const View& view) : scene_(scene), view_(view) {}

    const std::optional<Homography<double>>& at(PrimitiveId id) {
        if (id != last_) map_ = rasterizer::texels_from_raster(scene_, view_, std::uint32_t(id));
        last_ = id;
        return map_;
    }

  private:
    const Scene& scene_;
    const View& view_;
    PrimitiveId last_ = PrimitiveId::none;
    std::optional<Homography<double>> map_;
};

Patch patch_of(const texture::Footprint& footprint, const Image& image) {
    const texture::Ellipse ellipse = texture::ellipse(footprint);
    const glm::dvec2 along = glm::abs(ellipse.major_direction);
    return {.major = ellipse.major,
            .minor = ellipse.minor,
            .angle_degrees = std::atan2(along.y, along.x) * 180 / std::numbers::pi,
            .longest_side = std::max(image.width, image.height),
            .lod = texture::lod_gl_maximum(footprint),
            .centre = footprint.centre,
            .per_x = footprint.per_x,
            .per_y = footprint.per_y};
}

const Image& image_of(const Scene& scene, PrimitiveId id) {
    return scene.images[std::size_t(rasterizer::material_of(scene, std::uint32_t(id)).base_color.image)];
}

/// visit(x, y, id, map) for the pixels of a row that show a texture.
template <class Visit>
void each_textured(MapOfRun& maps, const Frame& frame, int y, Visit visit) {
    for (int x = 0; x < frame.size().width; ++x) {
        const PrimitiveId id = frame.primitive.at(x, y);
        if (id == PrimitiveId::none) continue;
        if (const auto& map = maps.at(id)) visit(x, id, *map);
    }
}

}  // namespace

Plane<Patch> surface_map(const Scene& scene, const View& view, const Frame& frame) {
    Plane<Patch> patches(frame.size());
    tbb::parallel_for(tbb::blocked_range<int>{0, frame.size().height}, [&](const auto& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) {
            MapOfRun maps{scene, view};
            each_textured(maps, frame, y, [&](int x, PrimitiveId id, const Homography<double>& map) {
                patches.at(x, y) = patch_of(texture::footprint(map, x, y, texture::Derivatives::analytic),
                                            image_of(scene, id));
            });
        }
    });
    return patches;
}

std::vector<Lookup> lookups(const Scene& scene, const View& view, const Frame& frame, std::size_t most) {
    std::vector<Lookup> all;
    MapOfRun maps{scene, view};
    std::size_t textured = 0;
    for (int y = 0; y < frame.size().height; ++y)
        each_textured(maps, frame, y, [&](int, PrimitiveId, const auto&) { ++textured; });
    const std::size_t stride = std::max<std::size_t>(1, (textured + most - 1) / most);
    std::size_t index = 0;
    for (int y = 0; y < frame.size().height; ++y)
        each_textured(maps, frame, y, [&](int x, PrimitiveId id, const Homography<double>& map) {
            if (index++ % stride != 0) return;
            const Material& material = rasterizer::material_of(scene, std::uint32_t(id));
            all.push_back({int(&material - scene.materials.data()),
                           texture::footprint(map, x, y, texture::Derivatives::analytic)});
        });
    return all;
}

}  // namespace zproof::study
