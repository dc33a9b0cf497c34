// The lessons' stages: what they promise, held in exact arithmetic over random frusta.
#include <gtest/gtest.h>

#include "lessons/projection/conformance.h"
#include "lessons/projection/matrices.h"
#include "lessons/projection/routes.h"
#include "lessons/projection/stages.h"
#include "lessons/projection/worked_example.h"
#include "tests/lessons/projection/random_frusta.h"

namespace zproof::study::projection {
namespace {

using test::exact;
using test::RandomFrusta;

constexpr unsigned frusta = 60;

bool are_in_line(const Vector3<Rational>& a, const Vector3<Rational>& b, const Vector3<Rational>& c) {
    const Vector3<Rational> n = cross(b - a, c - a);
    return n.x == 0 && n.y == 0 && n.z == 0;
}

bool is_in_box(const Vector3<Rational>& p) {
    return magnitude(p.x) <= 1 && magnitude(p.y) <= 1 && magnitude(p.z) <= 1;
}

/// By the view ray of scenes/camera.h alone: between near and far, and through the window.
bool is_in_frustum(const NumericCamera<Rational>& camera, const Vector3<Rational>& p) {
    const Rational t = -p.z;
    const bool is_perspective = camera.projection == Projection::perspective;
    if (t < camera.near || (camera.has_far && t > camera.far)) return false;
    const Rational u = p.x - (is_perspective ? Rational(0) : t * camera.shear.x),
                   v = p.y - (is_perspective ? Rational(0) : t * camera.shear.y),
                   scale = is_perspective ? t : Rational(1);
    const Canvas<Rational>& c = camera.canvas;
    return scale * c.left <= u && u <= scale * c.right && scale * c.bottom <= v && v <= scale * c.top;
}

/// A point of camera space at this depth, near or in the window.
Vector3<Rational> point_at(RandomFrusta& random, const NumericCamera<Rational>& camera,
                           const Rational& depth) {
    const Rational u = camera.canvas.left +
                       (camera.canvas.right - camera.canvas.left) * Rational(random.number(-0.5, 1.5)),
                   v = camera.canvas.bottom +
                       (camera.canvas.top - camera.canvas.bottom) * Rational(random.number(-0.5, 1.5));
    if (camera.projection == Projection::parallel)
        return {u + depth * camera.shear.x, v + depth * camera.shear.y, -depth};
    return {u * depth, v * depth, -depth};
}

Rational some_depth(RandomFrusta& random, const NumericCamera<Rational>& camera) {
    const Rational span = camera.has_far ? Rational(camera.far - camera.near) : Rational(100);
    const Rational depth = camera.near + span * Rational(random.number(-0.3, 1.3));
    return camera.projection == Projection::perspective && depth <= 0 ? Rational(camera.near / 2) : depth;
}

class EveryProjection : public testing::TestWithParam<Projection> {
  protected:
    NumericCamera<Rational> camera(RandomFrusta& random) const {
        return camera_of<Rational>(GetParam() == Projection::perspective ? random.perspective()
                                                                         : random.parallel());
    }
};

TEST_P(EveryProjection, LinesBecomeLines) {
    for (unsigned seed = 0; seed < frusta; ++seed) {
        SCOPED_TRACE(seed);
        RandomFrusta random{seed};
        const NumericCamera<Rational> camera = this->camera(random);
        const Vector3<Rational> a = point_at(random, camera, some_depth(random, camera)),
                                b = point_at(random, camera, some_depth(random, camera));
        const Vector3<Rational> c = a + Rational(random.number(0, 1)) * (b - a);
        EXPECT_TRUE(
            are_in_line(camera_to_box(camera, a), camera_to_box(camera, b), camera_to_box(camera, c)));
    }
}

TEST_P(EveryProjection, APointIsInTheFrustumIffItIsInTheBox) {
    int inside = 0;
    for (unsigned seed = 0; seed < frusta; ++seed) {
        SCOPED_TRACE(seed);
        RandomFrusta random{seed};
        const NumericCamera<Rational> camera = this->camera(random);
        for (int i = 0; i < 20; ++i) {
            const Vector3<Rational> p = point_at(random, camera, some_depth(random, camera));
            const bool is_inside = is_in_frustum(camera, p);
            inside += is_inside ? 1 : 0;
            ASSERT_EQ(is_in_box(camera_to_box(camera, p)), is_inside);
        }
    }
    EXPECT_GT(inside, 100);  // both answers were asked for
    EXPECT_LT(inside, 800);
}

TEST_P(EveryProjection, NearAndFarAreTheBoxsEnds) {
    for (unsigned seed = 0; seed < frusta; ++seed) {
        RandomFrusta random{seed};
        const NumericCamera<Rational> camera = this->camera(random);
        EXPECT_EQ(depth_to_ndc(camera, camera.near), -1);
        if (camera.has_far) {
            EXPECT_EQ(depth_to_ndc(camera, camera.far), 1);
        }
    }
}

TEST_P(EveryProjection, AllRoutesReachTheSamePlaceExactlyAndItIsTheViewRays) {
    for (unsigned seed = 0; seed < frusta; ++seed) {
        SCOPED_TRACE(seed);
        RandomFrusta random{seed};
        const View view = GetParam() == Projection::perspective ? random.perspective() : random.parallel();
        const NumericCamera<Rational> camera = camera_of<Rational>(view);
        const Vector3<Rational> p_camera = point_at(random, camera, some_depth(random, camera));
        const auto axis = [](const glm::dvec3& v) { return exactly<Rational>(v); };
        const Camera& c = view.camera;
        const Vector3<Rational> p_world =
            camera.eye + p_camera.x * axis(c.right) + p_camera.y * axis(c.up) + p_camera.z * axis(c.back);
        for (const Route<Rational>& route : routes(camera)) {
            if (route.card.kind == RouteKind::slip) continue;
            const Travel<Rational> end = arrival(route, departure(p_world));
            const Rational u = camera.canvas.left +
                               (camera.canvas.right - camera.canvas.left) * end.at[0] / view.width,
                           v = camera.canvas.top -
                               (camera.canvas.top - camera.canvas.bottom) * end.at[1] / view.height,
                           t = -p_camera.z;
            const bool is_perspective = GetParam() == Projection::perspective;
            EXPECT_EQ(is_perspective ? Rational(t * u) : Rational(u + t * camera.shear.x), p_camera.x)
                << route.card.name;
            EXPECT_EQ(is_perspective ? Rational(t * v) : Rational(v + t * camera.shear.y), p_camera.y)
                << route.card.name;
        }
    }
}

TEST_P(EveryProjection, TheMatrixMapsDepthAsTheStageDoes) {
    for (unsigned seed = 0; seed < frusta; ++seed) {
        RandomFrusta random{seed};
        const NumericCamera<Rational> camera = this->camera(random);
        const Vector3<Rational> p = point_at(random, camera, some_depth(random, camera));
        const Point4<Rational> clip =
            projection_matrix(camera) * Point4<Rational>{p.x, p.y, p.z, Rational(1)};
        EXPECT_EQ(clip[2] / clip[3], camera_to_box(camera, p).z);
    }
}

INSTANTIATE_TEST_SUITE_P(Stages, EveryProjection,
                         testing::Values(Projection::perspective, Projection::parallel), [](const auto& one) {
                             return one.param == Projection::parallel ? "parallel" : "perspective";
                         });

/// The image of q + t v is off the image of the direction v by a constant over its depth: as t grows, all
/// lines along v come to one point.
TEST(Perspective, ParallelLinesMeetInTheirVanishingPoint) {
    for (unsigned seed = 0; seed < frusta; ++seed) {
        SCOPED_TRACE(seed);
        RandomFrusta random{seed};
        const NumericCamera<Rational> camera = camera_of<Rational>(random.perspective());
        const Vector3<Rational> along{Rational(random.number(-1, 1)), Rational(random.number(-1, 1)),
                                      Rational(-random.number(0.1, 1))};
        const Vector3<Rational> vanishing = camera_to_box(camera, along);
        const Vector3<Rational> q = exact(random.point(3)) - Vector3<Rational>{0, 0, 4};
        const auto off_times_depth = [&](const Rational& t) {
            const Vector3<Rational> p = q + t * along, image = camera_to_box(camera, p);
            return Point2<Rational>{(image.x - vanishing.x) * -p.z, (image.y - vanishing.y) * -p.z};
        };
        EXPECT_EQ(off_times_depth(0), off_times_depth(1));
        EXPECT_EQ(off_times_depth(0), off_times_depth(1'000'000));
    }
}

TEST(Perspective, LinesAlongTheCanvasHaveNoVanishingPoint) {
    RandomFrusta random{3};
    const NumericCamera<Rational> camera = camera_of<Rational>(random.perspective());
    const Vector3<Rational> along{1, Rational(1) / 3, 0}, q{0, 0, -2};
    const Vector3<Rational> a = camera_to_box(camera, q), b = camera_to_box(camera, q + along),
                            c = camera_to_box(camera, q + Rational(7) * along);
    EXPECT_EQ(c.x - a.x, 7 * (b.x - a.x));  // ratios are kept: the image is affine
    EXPECT_EQ(c.y - a.y, 7 * (b.y - a.y));
}

TEST(Parallel, ParallelLinesStayParallelAndRatiosAreKept) {
    for (unsigned seed = 0; seed < frusta; ++seed) {
        RandomFrusta random{seed};
        const NumericCamera<Rational> camera = camera_of<Rational>(random.parallel());
        const Vector3<Rational> along = exact(random.point(1)), q = exact(random.point(3)),
                                r = exact(random.point(3));
        const Vector3<Rational> at_q = camera_to_box(camera, q + along) - camera_to_box(camera, q),
                                at_r =
                                    camera_to_box(camera, r + Rational(5) * along) - camera_to_box(camera, r);
        EXPECT_EQ(at_r.x, 5 * at_q.x);
        EXPECT_EQ(at_r.y, 5 * at_q.y);
        EXPECT_EQ(at_r.z, 5 * at_q.z);
    }
}

/// Directions of projection: of an oblique camera (shear, -1), of an orthographic one the view axis.
TEST(Parallel, APointMovesUnseenAlongTheDirectionOfProjection) {
    RandomFrusta random{1};
    for (int i = 0; i < 40; ++i) {
        const NumericCamera<Rational> camera = camera_of<Rational>(random.parallel());
        const Vector3<Rational> p = exact(random.point(3)), direction{camera.shear.x, camera.shear.y, -1};
        const Vector3<Rational> a = camera_to_box(camera, p), b = camera_to_box(camera, p + direction);
        EXPECT_EQ(a.x, b.x);
        EXPECT_EQ(a.y, b.y);
        EXPECT_LT(a.z, b.z);
    }
}

TEST(Conventions, UnitNdcIsNdcBroughtToZeroAndOne) {
    RandomFrusta random{2};
    for (int i = 0; i < 40; ++i) {
        const NumericCamera<Rational> camera = camera_of<Rational>(random.perspective());
        const Vector3<Rational> p = exact(random.point(3));
        const Vector3<Rational> ndc = screen_to_ndc(camera.on_near, p),
                                unit = screen_to_unit_ndc(camera.on_near, p);
        EXPECT_EQ(unit.x, (ndc.x + 1) / 2);
        EXPECT_EQ(unit.y, (ndc.y + 1) / 2);
        EXPECT_EQ(unit_ndc_to_raster(camera, unit).y, ndc_to_raster(camera, ndc).y);
    }
}

/// Routes are made of the operations of the stages: machine numbers come out bit by bit the same.
TEST(Routes, GiveTheBitsOfTheNamedStages) {
    RandomFrusta random{4};
    for (int i = 0; i < 200; ++i) {
        const View view = i % 2 == 0 ? random.perspective() : random.parallel();
        const NumericCamera<float> camera = camera_of<float>(view);
        const glm::vec3 p{random.point(4)};
        const Vector3<float> p_world{p.x, p.y, p.z};
        const Vector3<float> p_screen = camera_to_screen(camera, world_to_camera(camera, p_world));
        const Vector3<float> p_raster = ndc_to_raster(camera, screen_to_ndc(camera.on_near, p_screen));
        const Vector3<float> p_unit =
            unit_ndc_to_raster(camera, screen_to_unit_ndc(camera.on_near, p_screen));
        const std::vector<Route<float>> all = routes(camera);
        ASSERT_EQ(all[0].card.name, "stages");
        ASSERT_EQ(all[1].card.name, "stages-unit");
        const Travel<float> end = arrival(all[0], departure(p_world)),
                            unit = arrival(all[1], departure(p_world));
        EXPECT_EQ(end.at[0], p_raster.x);
        EXPECT_EQ(end.at[1], p_raster.y);
        EXPECT_EQ(end.at[2], p_raster.z);
        EXPECT_EQ(unit.at[0], p_unit.x);
        EXPECT_EQ(unit.at[1], p_unit.y);
    }
}

TEST(WorkedExample, PrintsWhatTheLessonPrints) {
    const auto steps = worked_example();
    EXPECT_EQ(steps[0].what + steps[0].numbers, "local to worldfloat32");
    EXPECT_EQ(steps[0].printed, steps[0].lesson);
    for (std::size_t i = 2; i < steps.size(); i += 4)
        EXPECT_EQ(steps[i].printed, steps[i].lesson) << steps[i].numbers;
}

/// y is 1.448905, half way between two printed numbers: float32 lies below and prints 1.4489.
TEST(WorkedExample, TheExactWorldPlaceIsATieOfTheSixthDigit) {
    const auto steps = worked_example();
    EXPECT_EQ(steps[8].what + steps[8].numbers, "local to worldexact");
    EXPECT_DOUBLE_EQ(steps[8].result[1], 1.448905);
    EXPECT_LT(steps[0].result[1], 1.448905);
}

TEST(WorkedExample, TheTextsOtherCornerIsAnotherPoint) {
    const auto steps = worked_example();
    EXPECT_TRUE(steps[1].what.starts_with("local to world, with z = +0.5"));
    EXPECT_GT(std::abs(steps[0].result[2] - steps[1].result[2]), 0.7);
}

TEST(WorkedExample, ThereAndBackIsExactWithoutRounding) {
    const auto steps = worked_example();
    EXPECT_EQ(steps.back().numbers, "exact");
    EXPECT_EQ(steps.back().result, (std::array{-0.5, 0.5, -0.5}));
}

}  // namespace
}  // namespace zproof::study::projection
