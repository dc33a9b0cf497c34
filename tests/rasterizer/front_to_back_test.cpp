#include "rasterizer/front_to_back.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawing.h"

namespace zproof::rasterizer {
namespace {

/// The bins of triangles around the eye, some of them cut by the near plane.
class FrontToBackOfBins : public testing::Test {
  protected:
    FrontToBackOfBins() {
        std::mt19937 random(3);
        scene_ = scene_of(random_triangles(random, 2000, {-5, -4, -9}, {5, 4, 1}));
        projected_.fill(scene_.vertices, setup_);
        bins_.fill(scene_, projected_, setup_);
        front_to_back_.fill(bins_);
    }

    float nearest(std::uint32_t place) const {
        const Triangles& t = bins_.triangles();
        place &= ~turned;
        if (place < t.length) {
            const glm::uvec3 v = t.corners[place];
            return nearest_pixel(t.vertices[v.x].inverse_depth, t.vertices[v.y].inverse_depth,
                                 t.vertices[v.z].inverse_depth);
        }
        const SnappedVertex(&v)[3] = t.pieces[place - t.length].vertex;
        return nearest_pixel(v[0].inverse_depth, v[1].inverse_depth, v[2].inverse_depth);
    }

    const View view_{.name = "around", .camera = {}, .width = 150, .height = 100};
    const ViewSetup setup_{view_, correct_rules};
    Scene scene_;
    ProjectedVertices projected_;
    TileBins bins_;
    FrontToBack front_to_back_;
};

TEST_F(FrontToBackOfBins, PutsEveryPlaceInOrderOnce) {
    ASSERT_FALSE(bins_.pieces().empty());
    for (std::size_t tile = 0; tile < bins_.tiles().count(); ++tile) {
        const std::span<const std::uint32_t> expected = bins_.entries_in(tile);
        const std::span<const std::uint32_t> ordered = front_to_back_.ordered(expected).entries;
        EXPECT_TRUE(std::ranges::is_permutation(expected, ordered));
        // A step is at most 2^-3 of a number, as 256 of them reach over 32 binades or less.
        for (std::size_t i = 0; i + 1 < ordered.size(); ++i)
            EXPECT_GE(nearest(ordered[i]) * 1.125f, nearest(ordered[i + 1]));
    }
}

TEST_F(FrontToBackOfBins, KnowsTheNearestOfWhatIsLeft) {
    for (std::size_t tile = 0; tile < bins_.tiles().count(); ++tile) {
        const TileEntries ordered = front_to_back_.ordered(bins_.entries_in(tile));
        EXPECT_EQ(ordered.ties, Ties::least_id);
        for (std::size_t first = 0; first < ordered.entries.size(); first += batch_size) {
            float most = nothing_seen;
            for (const std::uint32_t place : ordered.entries.subspan(first))
                most = std::max(most, nearest(place));
            EXPECT_EQ(ordered.nearest_left[first / batch_size], most);
        }
    }
}

TEST_F(FrontToBackOfBins, OfNoPlacesIsNone) { EXPECT_TRUE(front_to_back_.ordered({}).entries.empty()); }

}  // namespace
}  // namespace zproof::rasterizer
