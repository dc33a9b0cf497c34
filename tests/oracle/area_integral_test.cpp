#include "oracle/area_integral.h"

#include <gtest/gtest.h>

#include "oracle/area/surfaces.h"
#include "tests/support/worked_setup.h"
#include "textured_plane.h"

namespace zproof::oracle {

namespace {

namespace worked = texture::worked;

/// The worked set-up as a scene: +z there is -z here, so v runs the other way.
Scene worked_scene() {
    Scene scene = textured_plane(256, {.image = checks(worked::texture_side, worked::check)});
    scene.materials[0].base_color.transform = {glm::dmat2(0.25, 0, 0, -0.25),
                                               glm::dvec2(3.37, 1.71) / double(worked::texture_side)};
    return scene;
}

TEST(AreaIntegral, AgreesWithAnotherProgramOnTheWorkedSetUp) {
    const AreaTruth truth =
        area_truth(worked_scene(), ground_view(worked::side, worked::side, 20), Reconstruction::nearest);
    const Homography<double> map = worked::texels_from_raster(0);
    double worst = 0;
    for (int y = worked::first_row; y < worked::side; ++y)
        for (int x = 0; x < worked::side; ++x) {
            ASSERT_EQ(truth.kind.at(x, y), TruthKind::interior) << x << " " << y;
            worst = std::max(worst, std::abs(truth.mean.at(x, y).r - worked::exact_mean(map, x, y)));
        }
    EXPECT_LT(worst, 1e-11);
}

}  // namespace

}  // namespace zproof::oracle
