// The tool finds by itself which routes and tests of the lessons are wrong, and where.
#include <gtest/gtest.h>

#include <algorithm>

#include "lessons/projection/conformance.h"
#include "lessons/projection/stages.h"

namespace zproof::study::projection {
namespace {

RouteFinding finding_of(const std::string& name) {
    const auto all = route_findings();
    const auto found = std::ranges::find(all, name, [](const RouteFinding& f) { return f.card.name; });
    if (found == all.end()) throw std::runtime_error{name + ": no such route"};
    return *found;
}

TEST(RouteFindings, WhatTheLessonsMeanIsTheProjection) {
    int right = 0;
    for (const RouteFinding& f : route_findings()) {
        EXPECT_EQ(f.is_projection(), f.card.kind == RouteKind::lesson) << f.card.name;
        if (!f.is_projection()) continue;
        EXPECT_EQ(f.worst_px, 0) << f.card.name;
        EXPECT_EQ(f.cameras_kept, f.cameras) << f.card.name;
        ++right;
    }
    EXPECT_EQ(right, 5);
}

TEST(RouteFindings, RasterFromScreenIsWrongInItsLastStageAndUnseenOnTheLessonsOwnCanvas) {
    const RouteFinding f = finding_of("raster-from-screen");
    EXPECT_EQ(f.first_wrong_stage, "NDC to raster");
    EXPECT_EQ(f.space, "raster");
    EXPECT_EQ(f.camera, "canvas 2 x 2, near 1/10");  // not the first: there screen space is NDC space
    EXPECT_EQ(f.cameras_kept, 1);
    EXPECT_GT(f.worst_px, 100);
}

TEST(RouteFindings, DividingByZIsWrongInScreenSpace) {
    const RouteFinding f = finding_of("divided-by-z");
    EXPECT_EQ(f.first_wrong_stage, "camera to screen");
    EXPECT_EQ(f.operation, "divide by z");
    EXPECT_EQ(f.cameras_kept, 0);
}

TEST(RouteFindings, TheCanvasAboutTheAxisIsTriedWhereThereIsOne) {
    EXPECT_EQ(finding_of("canvas").cameras, 3);
    EXPECT_EQ(finding_of("stages").cameras, int(probe_cameras().size()));
}

/// Of an off-axis canvas its formula would be wrong: the check sees that.
TEST(ExactProjection, ACentredFormulaOffAxisMissesTheViewRay) {
    for (const ProbeCamera& probe : probe_cameras()) {
        if (probe.name != "off axis, near 1/2") continue;
        const Vector3<Rational> p = probe_points(probe.camera).front();
        const Vector3<Rational> p_screen = camera_to_screen(probe.camera, world_to_camera(probe.camera, p));
        const auto travel = [](const Vector3<Rational>& q) {
            return Travel<Rational>{{q.x, q.y, q.z, 1}, {}};
        };
        const Canvas<Rational>& c = probe.camera.on_near;
        EXPECT_TRUE(is_on_view_ray(Space::screen, probe.camera, p, travel(p_screen)));
        EXPECT_TRUE(
            is_on_view_ray(Space::unit_ndc, probe.camera, p, travel(screen_to_unit_ndc(c, p_screen))));
        EXPECT_FALSE(is_on_view_ray(Space::unit_ndc, probe.camera, p,
                                    travel(centred_screen_to_unit_ndc(c, p_screen))));
        return;
    }
    FAIL() << "no off-axis probe";
}

TEST(ExactProjection, EverySpaceNoticesAPointThatIsElsewhere) {
    for (const ProbeCamera& probe : probe_cameras())
        for (const Route<Rational>& route : routes(probe.camera)) {
            if (route.card.kind == RouteKind::slip) continue;
            const Vector3<Rational> p = probe_points(probe.camera)[1];
            Travel<Rational> travel = departure(p);
            for (const Operation<Rational>& operation : route.operations) {
                travel = operation.apply(travel);
                if (!operation.arrives) continue;
                EXPECT_TRUE(is_on_view_ray(*operation.arrives, probe.camera, p, travel)) << route.card.name;
                Travel<Rational> beside = travel;
                beside.at[1] += Rational(1) / 1'000'000'000;
                EXPECT_FALSE(is_on_view_ray(*operation.arrives, probe.camera, p, beside))
                    << in_words(*operation.arrives);
            }
        }
}

TEST(Visibility, OrAndTheWholeCanvasLetInWhatIsNotInThePicture) {
    const auto findings = visibility_findings();
    ASSERT_EQ(findings.size(), 3u);
    const int places = 25 * 25, on_canvas = 9 * 9;
    EXPECT_EQ(findings[0].shown_wrongly + findings[0].hidden_wrongly, 0);
    EXPECT_EQ(findings[1].shown_wrongly, 2 * 9 * 25 - 9 * 9 - on_canvas);  // a cross, less the canvas
    EXPECT_EQ(findings[2].shown_wrongly, 17 * 17 - on_canvas);  // twice the canvas, less the canvas
    for (const VisibilityFinding& f : findings) {
        EXPECT_EQ(f.points, places);
        EXPECT_EQ(f.hidden_wrongly, 0);
    }
    EXPECT_TRUE(findings[0].example.empty());
    EXPECT_FALSE(findings[2].example.empty());
}

}  // namespace
}  // namespace zproof::study::projection
