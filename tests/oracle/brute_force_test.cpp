#include "brute_force.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "oracle/embree.h"
#include "oracle/povray.h"
#include "scenes_at_random.h"

namespace zproof::oracle {
namespace {

class AgreesWith : public testing::TestWithParam<ProjectionKind> {};

TEST_P(AgreesWith, Embree) {
    const auto cast = [](const Scene& scene, const View& view) { return Embree(scene).trace(view); };
    expect_agreement({.cast = cast, .scenes = 40, .depth_error = nullptr}, GetParam());
}

/// Its depths are right to a rounding of float32 and half a step of their code.
TEST_P(AgreesWith, PovRay) {
    const auto cast = [](const Scene& scene, const View& view) { return PovRay(scene).render(view); };
    const auto depth_error = [](const View& view, double depth) {
        const Camera& c = view.camera;
        const double range = c.projection == Projection::parallel ? c.far_depth - c.near_depth : 0;
        return std::abs(depth) * 0x1.01p-23 + range * 0x1.01p-29;
    };
    expect_agreement({.cast = cast, .scenes = 4, .depth_error = depth_error}, GetParam());
}

std::string name_of(const testing::TestParamInfo<ProjectionKind>& projection_kind) {
    constexpr std::array names{"InPerspective", "OffAxis", "InOrthographicViews", "InObliqueViews"};
    return names[std::size_t(projection_kind.param)];
}

INSTANTIATE_TEST_SUITE_P(BruteForce, AgreesWith,
                         testing::Values(ProjectionKind::perspective, ProjectionKind::off_axis,
                                         ProjectionKind::orthographic, ProjectionKind::oblique),
                         name_of);

}  // namespace
}  // namespace zproof::oracle
