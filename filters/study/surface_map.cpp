#include "filters/study/surface_map.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "filters/methods/lod.h"
#include "rasterizer/triangle_footprints.h"

namespace zproof::study {

namespace {

/// The footprints on the triangles of a row of pixels: a run of one triangle finds its map once.
class FootprintsOfRun {
  public:
    FootprintsOfRun(const Scene& scene, const View& view) : scene_(scene), view_(view) {}

    const std::optional<rasterizer::TriangleFootprints>& of(PrimitiveId id) {
        if (id != last_) seen_ = rasterizer::footprints_of(scene_, view_, std::uint32_t(id));
        last_ = id;
        return seen_;
    }

  private:
    const Scene& scene_;
    const View& view_;
    PrimitiveId last_ = PrimitiveId::none;
    std::optional<rasterizer::TriangleFootprints> seen_;
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

/// visit(x, id, footprint) for the pixels of a row that show a texture.
template <class Visit>
void each_textured(FootprintsOfRun& seen, const Frame& frame, int y, Visit visit) {
    for (int x = 0; x < frame.size().width; ++x) {
        const PrimitiveId id = frame.primitive.at(x, y);
        if (id == PrimitiveId::none) continue;
        if (const auto& footprints = seen.of(id))
            visit(x, id, footprints->at(x, y, texture::Derivatives::analytic));
    }
}

}  // namespace

Plane<Patch> surface_map(const Scene& scene, const View& view, const Frame& frame) {
    Plane<Patch> patches(frame.size());
    tbb::parallel_for(tbb::blocked_range<int>{0, frame.size().height}, [&](const auto& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) {
            FootprintsOfRun seen{scene, view};
            each_textured(seen, frame, y, [&](int x, PrimitiveId id, const texture::Footprint& footprint) {
                patches.at(x, y) = patch_of(footprint, image_of(scene, id));
            });
        }
    });
    return patches;
}

std::vector<Lookup> lookups(const Scene& scene, const View& view, const Frame& frame, std::size_t most) {
    std::vector<Lookup> all;
    FootprintsOfRun seen{scene, view};
    std::size_t textured = 0;
    for (int y = 0; y < frame.size().height; ++y)
        each_textured(seen, frame, y, [&](int, PrimitiveId, const auto&) { ++textured; });
    const std::size_t stride = std::max<std::size_t>(1, (textured + most - 1) / most);
    std::size_t index = 0;
    for (int y = 0; y < frame.size().height; ++y)
        each_textured(seen, frame, y, [&](int, PrimitiveId id, const texture::Footprint& footprint) {
            if (index++ % stride != 0) return;
            const Material& material = rasterizer::material_of(scene, std::uint32_t(id));
            all.push_back({int(&material - scene.materials.data()), footprint});
        });
    return all;
}

}  // namespace zproof::study
