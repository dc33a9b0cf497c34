/// What is seen at a glance is seen, whatever the renderer, and right at the centre.
#include "compare/hearing/glance.h"

#include <gtest/gtest.h>

#include "compare/hearing/hearing.h"
#include "compare/search/between_planes.h"
#include "compare/truth/displacement.h"
#include "math/rational.h"
#include "random_surroundings.h"
#include "stage.h"
#include "word_for.h"

namespace zproof {
namespace {

/// What exact rationals say of each answer that is seen at a glance.
class Witnessed {
  public:
    void look(const Scene& scene, const View& view, const PixelPlace& pixel, const Precision& precision) {
        const ViewBounds bounds(view, precision);
        std::vector<std::uint32_t> all;
        for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) all.push_back(t);
        Glance glance(scene, view);
        look(glance, all, bounds.background_eps_px(), {scene, view, pixel, bounds, PrimitiveId::none});
        for (const std::uint32_t t : all)
            look(glance, all, bounds.least_triangle_eps_px(), {scene, view, pixel, bounds, PrimitiveId(t)});
    }

    int seen = 0, others = 0;

  private:
    struct Case {
        const Scene& scene;
        const View& view;
        const PixelPlace& pixel;
        const ViewBounds& bounds;
        PrimitiveId answer;
    };
    void look(Glance& glance, std::span<const std::uint32_t> all, double least_eps_px, const Case& of) {
        glance.turn_to(all, 0.5 * least_px(least_eps_px));
        if (!glance.sees(of.answer, of.pixel)) {
            ++others;
            return;
        }
        ++seen;
        const double own_eps_px = zproof::own_eps_px(of.scene, of.view, of.bounds, of.pixel, of.answer);
        ASSERT_GE(own_eps_px, least_eps_px);
        const Site site{of.pixel.x, of.pixel.y, 1, {all.begin(), all.end()}};
        const Neighbourhood around = neighbourhood_of(of.scene, of.view, of.bounds, site, own_eps_px);
        CoplanarMemory memory(16);
        AdmissibleSet<Rational> set(around, memory);
        const auto index = around.index_of(of.answer);
        ASSERT_TRUE(index || of.answer == PrimitiveId::none);
        ASSERT_EQ(word_for(set, around.neighbours.size(), index), Standing::visible);
        Estimate estimate([&] { return around; }, memory);
        estimate.turn_to(of.answer);
        ASSERT_EQ(displacement_over_eps(estimate), std::nullopt);
    }
};

TEST(Glance, SeesWhatExactRationalsSee) {
    Witnessed witnessed;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        if (!lies_between_planes(s.scene, s.view)) continue;
        witnessed.look(s.scene, s.view, {s.x, s.y}, seed % 2 ? raster_precision() : ray_precision());
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(witnessed.seen, 300);
    EXPECT_GT(witnessed.others, 300);
}

/// Walls around a corner in which they meet, that lies at the centre, up to two steps of 1/1024 eps from it,
/// or anywhere within eps; behind each other or in one plane.
std::vector<Triangle> random_meeting(Dice& dice) {
    constexpr double eps_px = 1.0 / 512, step_px = eps_px / 1024;
    const auto near_centre = [&] {
        const double steps = 0.5 * dice.below(5) - 1, anywhere = dice.between(-1, 1) * eps_px;
        return 1.5 + (dice.below(4) == 0 ? anywhere : 2 * steps * step_px);
    };
    const Corner middle{near_centre(), near_centre(), 4};
    const double slope = dice.between(-2, 2), other_slope = dice.between(-2, 2), far = 64;
    const Corner up{middle.x - slope * far, middle.y - far, 4},
        down{middle.x + slope * far, middle.y + far, 4};
    const Corner left{-512, middle.y + other_slope * 512, 4}, right{512, middle.y - other_slope * 512, 4};
    std::vector<Triangle> walls{
        {middle, left, up}, {middle, up, right}, {middle, right, down}, {middle, down, left}};
    for (int gone = dice.below(3); gone > 0; --gone) walls.pop_back();
    if (dice.below(2)) walls.push_back(wall(dice.below(2) ? 8 : 4));
    return walls;
}

TEST(Glance, SeesWhatMeetsAtThePixelsCentre) {
    Witnessed witnessed;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view = pixel_view(dice.below(2) ? Projection::perspective : Projection::parallel, 4, 4);
        const Scene scene = scene_of(view, random_meeting(dice));
        ASSERT_TRUE(lies_between_planes(scene, view));
        witnessed.look(scene, view, {1, 1}, dice.below(2) ? raster_precision() : ray_precision());
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(witnessed.seen, 1000);
    EXPECT_GT(witnessed.others, 1000);
}

TEST(Glance, SaysNothingOfTrianglesThatAreNotNear) {
    const View view = pixel_view(Projection::perspective, 4, 4);
    const Scene scene = scene_of(view, {wall(4), wall(2)});
    Glance glance(scene, view);
    constexpr std::array<std::uint32_t, 1> near{0};
    glance.turn_to(near, 0x1p-20);
    EXPECT_TRUE(glance.sees(PrimitiveId(0), {1, 1}));
    EXPECT_FALSE(glance.sees(PrimitiveId(1), {1, 1}));
    EXPECT_FALSE(glance.sees(PrimitiveId::none, {1, 1}));
}

/// Without the square that an answer was judged in, all else is the same.
TEST(Glance, ChangesNothingButTheSquare) {
    int glanced = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view = pixel_view(dice.below(2) ? Projection::perspective : Projection::parallel, 4, 4);
        const Scene scene = scene_of(view, random_meeting(dice));
        const ViewBounds ours(view, raster_precision()), theirs(view, ray_precision());
        std::vector<const ViewBounds*> renderers{&ours};
        if (dice.below(2)) renderers.push_back(&theirs);
        Bulk<Plea> pleas;
        for (const ViewBounds* const bounds : renderers) {
            for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
                pleas.push_back({bounds, PrimitiveId(t), 1, 1});
            if (dice.below(2)) pleas.push_back({bounds, PrimitiveId::none, 1, 1});
        }
        const Bulk<Ruled> all = Hearing(scene, view).hear(pleas, Asked::standing_and_displacement),
                          without = Hearing(scene, view).hear(pleas, Asked::without_square);
        for (std::size_t i = 0; i < pleas.size(); ++i) {
            ASSERT_EQ(without[i].decision.standing, all[i].decision.standing);
            ASSERT_EQ(without[i].displacement_over_eps, all[i].displacement_over_eps);
            ASSERT_FALSE(std::isnan(all[i].eps_px));
            if (std::isnan(without[i].eps_px))
                ++glanced;
            else
                ASSERT_EQ(without[i].eps_px, all[i].eps_px);
        }
    }
    EXPECT_GT(glanced, 500);
}

/// Any triangle of four that meet in all four pixels, at its depth or beside it.
Frame random_frame(Dice& dice, const View& view) {
    Frame frame({view.width, view.height});
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x)
            answer(frame, x, y, std::uint32_t(dice.below(4)), dice.below(3) == 0 ? 4.01 : 4);
    return frame;
}

/// What fails is listed with its square, which a glance does not know.
TEST(Glance, LeavesNoSquareOfAFindingOut) {
    std::size_t failing = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view = pixel_view(dice.below(2) ? Projection::perspective : Projection::parallel, 4, 4);
        const Scene scene = scene_of(view, {wall_left_of(1.5, 4, -64, 1.5), wall_right_of(1.5, 4, -64, 1.5),
                                            wall_left_of(1.5, 4, 1.5, 64), wall_right_of(1.5, 4, 1.5, 64)});
        const Frame ours = random_frame(dice, view), theirs = random_frame(dice, view);
        const RenderedFrame candidate{ours, raster_precision()}, reference{theirs, ray_precision()};
        Bulk<Finding> all = judge_in_full(scene, view, candidate, reference).verdict.findings;
        std::erase_if(all, [](const Finding& f) { return passes(f.verdict); });
        const Bulk<Finding> listed = judge(scene, view, candidate, reference).findings;
        ASSERT_EQ(listed.size(), all.size());
        failing += listed.size();
        for (std::size_t i = 0; i < all.size(); ++i) {
            ASSERT_EQ(listed[i].x, all[i].x);
            ASSERT_EQ(listed[i].y, all[i].y);
            ASSERT_EQ(listed[i].verdict, all[i].verdict);
            ASSERT_EQ(listed[i].eps_px, all[i].eps_px);
        }
    }
    EXPECT_GT(failing, 1000u);
}

/// A plane that cuts a triangle of the scene may be within the square of any answer.
TEST(Glance, IsNotTakenWhereAPlaneMayCut) {
    const View view = pixel_view(Projection::perspective, 4, 4);
    const Scene scene = scene_of(view, {wall(4), wall(view.camera.far_depth)});
    const ViewBounds bounds(view, raster_precision());
    const Bulk<Plea> pleas{{&bounds, PrimitiveId(0), 1, 1}};
    EXPECT_GT(Hearing(scene, view).hear(pleas, Asked::without_square)[0].eps_px, 0);
}

TEST(BetweenPlanes, IsEveryVertexOrNone) {
    View view = pixel_view(Projection::parallel, 4, 4);
    const double near = view.camera.near_depth, far = view.camera.far_depth;
    EXPECT_TRUE(lies_between_planes(scene_of(view, {wall(near + 1), wall(far - 1)}), view));
    EXPECT_FALSE(lies_between_planes(scene_of(view, {wall(near + 1), wall(far)}), view));
    EXPECT_FALSE(lies_between_planes(scene_of(view, {wall(near), wall(far - 1)}), view));
    Scene scene = scene_of(view, std::vector<Triangle>(3000, wall(near + 1)));
    EXPECT_TRUE(lies_between_planes(scene, view));
    scene.vertices.position_world[7000].z = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(lies_between_planes(scene, view));
    EXPECT_TRUE(lies_between_planes(Scene{}, view));
}

}  // namespace
}  // namespace zproof
