#include "compare/adjudicate/triangle_cache.h"

#include <gtest/gtest.h>

#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

TEST(TriangleCache, KnowsTheTrianglesThatAreNear) {
    const View view = pixel_view(Projection::parallel, 4, 4);
    const Scene scene = scene_of(view, {wall(4), wall_left_of(1, 4), wall_right_of(2, 4)});
    const TriangleSearch search(scene, view, {});
    const std::uint32_t near[] = {1, 2};
    const TriangleCache cache(scene, view, search, near);
    EXPECT_EQ(cache.count(), 2u);
    for (std::size_t place = 0; place < 2; ++place) {
        EXPECT_EQ(cache.triangle(place), near[place]);
        EXPECT_EQ(cache.widest_box(place).left, search.box_of(near[place]).left);
        EXPECT_EQ(cache.widest_box(place).right, search.box_of(near[place]).right);
    }
}

/// Asked in turn about renderers and triangles, each is that triangle's by that renderer's bounds.
TEST(TriangleCache, KeepsRenderersApart) {
    const View view = pixel_view(Projection::perspective, 4, 4);
    const Scene scene = scene_of(view, {wall(2), wall(4), wall(8)});
    const std::uint32_t near[] = {0, 1, 2};
    const std::vector<ViewBounds> renderers{ViewBounds(view, raster_precision()),
                                            ViewBounds(view, ray_precision()),
                                            ViewBounds(view, RasterPrecision{.subpixel_bits = 2})};
    const TriangleSearch search(scene, view, {});
    TriangleCache cache(scene, view, search, near);
    Rng rng(1);
    for (int i = 0; i < 60; ++i) {
        const auto place = std::size_t(rng.below(3));
        const ViewBounds& bounds = renderers[std::size_t(rng.below(3))];
        const BoundedTriangle found = cache.of(place, bounds),
                              expected(bounds, corners_of(scene, near[place]));
        EXPECT_EQ(found.p_world, expected.p_world);
        EXPECT_EQ(found.bounds.eps_base_px, expected.bounds.eps_base_px);
        EXPECT_EQ(found.bounds.eps_per_inverse_depth, expected.bounds.eps_per_inverse_depth);
        EXPECT_EQ(found.bounds.depth_factor, expected.bounds.depth_factor);
        EXPECT_EQ(found.keeps_to_corners, expected.keeps_to_corners);
    }
}

}  // namespace
}  // namespace zproof
