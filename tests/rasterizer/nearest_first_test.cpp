#include "rasterizer/nearest_first.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawing.h"

namespace zproof::rasterizer {
namespace {

/// The bins of triangles around the eye, some of them cut by the near plane.
class NearestFirstOfBins : public testing::Test {
  protected:
    NearestFirstOfBins() {
        std::mt19937 random(3);
        scene_ = scene_of(random_triangles(random, 2000, {-5, -4, -9}, {5, 4, 1}));
        projected_.fill(scene_.vertices, setup_);
        bins_.fill(scene_, projected_, setup_);
        nearest_first_.fill(bins_);
    }

    float nearest(std::uint32_t place) const {
        const Triangles& t = bins_.triangles();
        place &= ~turned;
        if (place < t.length) {
            const glm::uvec3 v = t.corners[place];
            return nearest_pixel(t.vertices[v.x].nearness, t.vertices[v.y].nearness,
                                 t.vertices[v.z].nearness);
        }
        const SnappedVertex(&v)[3] = t.pieces[place - t.length].vertex;
        return nearest_pixel(v[0].nearness, v[1].nearness, v[2].nearness);
    }

    const View view_{.name = "around", .camera = {}, .width = 150, .height = 100};
    const ViewSetup setup_{view_, lawful_rules};
    Scene scene_;
    ProjectedVertices projected_;
    TileBins bins_;
    NearestFirst nearest_first_;
};

TEST_F(NearestFirstOfBins, PutsEveryPlaceInOrderOnce) {
    ASSERT_FALSE(bins_.pieces().empty());
    for (std::size_t tile = 0; tile < bins_.tiles().count(); ++tile) {
        const std::span<const std::uint32_t> expected = bins_.places_in(tile);
        const std::span<const std::uint32_t> ordered = nearest_first_.ordered(expected).places;
        EXPECT_TRUE(std::ranges::is_permutation(expected, ordered));
        // A step is at most 2^-3 of a number, as 256 of them reach over 32 binades or less.
        for (std::size_t i = 0; i + 1 < ordered.size(); ++i)
            EXPECT_GE(nearest(ordered[i]) * 1.125f, nearest(ordered[i + 1]));
    }
}

TEST_F(NearestFirstOfBins, KnowsTheNearestOfWhatIsLeft) {
    for (std::size_t tile = 0; tile < bins_.tiles().count(); ++tile) {
        const TilePlaces ordered = nearest_first_.ordered(bins_.places_in(tile));
        EXPECT_EQ(ordered.ties, Ties::least_id);
        for (std::size_t first = 0; first < ordered.places.size(); first += batch_size) {
            float most = nothing_seen;
            for (const std::uint32_t place : ordered.places.subspan(first))
                most = std::max(most, nearest(place));
            EXPECT_EQ(ordered.nearest_left[first / batch_size], most);
        }
    }
}

TEST_F(NearestFirstOfBins, OfNoPlacesIsNone) { EXPECT_TRUE(nearest_first_.ordered({}).places.empty()); }

}  // namespace
}  // namespace zproof::rasterizer
