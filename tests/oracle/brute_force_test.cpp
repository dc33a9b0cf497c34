#include "brute_force.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "oracle/admissible_surfaces.h"
#include "oracle/embree.h"
#include "oracle/povray.h"
#include "scenes_at_random.h"

namespace zproof::oracle {
namespace {

struct Tally {
    int pixels = 0, certain = 0, certain_and_covered = 0;
};

std::string story(const View& view, int x, int y) {
    return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") of " + std::to_string(view.width) +
           " x " + std::to_string(view.height);
}

/// An oracle under test: what it sees, how many scenes it is shown, and whether its depths are better than
/// float32's own arithmetic.
struct Caster {
    std::function<Frame(const Scene&, const View&)> cast;
    std::uint32_t scenes;
    std::function<double(const View&, double depth)> depth_error;  ///< where empty, float32's own
};

void expect_certain_answers(const Caster& caster, const Scene& scene, const View& view, Tally& tally) {
    const Frame frame = caster.cast(scene, view);
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            ++tally.pixels;
            const auto expected = certain_answer(scene, view, x, y);
            if (!expected) continue;
            ++tally.certain;
            ASSERT_EQ(frame.primitive.at(x, y), expected->primitive) << story(view, x, y);
            const float depth = frame.camera_depth.at(x, y);
            if (expected->primitive == PrimitiveId::none) {
                ASSERT_EQ(depth, background_depth) << story(view, x, y);
                continue;
            }
            ++tally.certain_and_covered;
            const long double allowed = caster.depth_error ? caster.depth_error(view, double(expected->depth))
                                                           : expected->depth_error;
            ASSERT_LE(std::abs(depth - expected->depth), allowed) << story(view, x, y);
        }
    }
}

/// Where float32 cannot be mistaken, the caster is not.
void expect_agreement(const Caster& caster, ProjectionKind projection_kind) {
    Tally tally;
    for (std::uint32_t seed = 0; seed < caster.scenes; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Rng rng(seed);
        const View view = random_view(rng, projection_kind);
        expect_certain_answers(caster, random_soup(rng, view.camera, 40), view, tally);
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(tally.certain, tally.pixels * 99 / 100) << "the bounds have become too loose to say anything";
    EXPECT_GT(tally.certain_and_covered, tally.pixels / 3)
        << "the scenes have become too empty to say anything";
}

class AgreesWith : public testing::TestWithParam<ProjectionKind> {};

TEST_P(AgreesWith, Embree) {
    const auto cast = [](const Scene& scene, const View& view) { return Embree(scene).trace(view); };
    expect_agreement({.cast = cast, .scenes = 40, .depth_error = nullptr}, GetParam());
}

TEST_P(AgreesWith, ExactVisibility) {
    const auto one_rounding = [](const View&, double depth) { return std::abs(depth) * 0x1.01p-24; };
    expect_agreement({.cast = exact_visibility, .scenes = 40, .depth_error = one_rounding}, GetParam());
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
