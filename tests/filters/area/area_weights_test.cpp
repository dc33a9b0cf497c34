// The area integral's weights of texels: they must add up to what the integral itself gives.
#include "filters/area/area_weights.h"

#include <gtest/gtest.h>

#include "texture/linear_image.h"
#include "textured_plane.h"

namespace zproof::oracle {
namespace {

constexpr int columns = 37, rows = 23;

/// Noise seen to the horizon, with texels both smaller and larger than pixels.
Scene noisy_ground() {
    return textured_plane(
        64, {.image = noise(columns, rows, 5), .per_unit = 0.11, .phi_degrees = 25, .offset = {0.3, 0.71}});
}

class WeightsOfEveryReconstruction : public testing::TestWithParam<NamedReconstruction> {};
INSTANTIATE_TEST_SUITE_P(AreaWeights, WeightsOfEveryReconstruction, testing::ValuesIn(reconstructions));

int inside(std::int64_t index, int size) { return int(((index % size) + size) % size); }

glm::dvec3 weighted(const std::vector<TexelWeight>& weights, const texture::LinearImage& image) {
    glm::dvec3 sum{0};
    for (const TexelWeight& w : weights)
        sum += w.weight * glm::dvec3{glm::vec3{image.at(inside(w.column, columns), inside(w.row, rows))}};
    return sum;
}

TEST_P(WeightsOfEveryReconstruction, WeightsOfTexelsAddUpToTheMean) {
    const Scene scene = noisy_ground();
    const View view = ground_view(24, 20, 20);
    const AreaTruth truth = area_truth(scene, view, GetParam().reconstruction);
    const AreaWeights weights(scene, view, GetParam().reconstruction);
    const texture::LinearImage image = texture::linear_image({columns, rows, scene.images[0].texels});
    int compared = 0, sampled = 0;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const auto found = weights.at(x, y);
            ASSERT_EQ(found.has_value(), truth.kind.at(x, y) != TruthKind::sampled) << x << "," << y;
            sampled += !found;
            if (!found || truth.kind.at(x, y) == TruthKind::background) continue;
            EXPECT_LT(glm::length(weighted(*found, image) - truth.mean.at(x, y)), 1e-12) << x << "," << y;
            ++compared;
        }
    EXPECT_GT(compared, 200);
    EXPECT_LT(sampled, 100);
}

TEST(AreaWeights, OfAPixelWithinATexelAreThatTexelAlone) {
    const Scene scene =
        textured_plane(64, {.image = noise(columns, rows, 5), .per_unit = 0.0001, .offset = {0.5, 0.5}});
    const AreaWeights weights(scene, ground_view(9, 9, 60), Reconstruction::nearest);
    const auto found = weights.at(4, 4);
    ASSERT_TRUE(found);
    double sum = 0;
    for (const TexelWeight& w : *found) {
        EXPECT_EQ(w.column, found->front().column);
        EXPECT_EQ(w.row, found->front().row);
        sum += w.weight;
    }
    EXPECT_NEAR(sum, 1, 1e-14);
}

}  // namespace
}  // namespace zproof::oracle
