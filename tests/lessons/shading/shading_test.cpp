#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lessons/shading/study.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite/random.h"

namespace zproof::study::shading {
namespace {

constexpr double third = 1.0 / 3;

TEST(Reflection, IsTheFormula) {
    const LightSource light_source{LightSource::Kind::directional, {0, 0, 1}};
    const Finish finish{.ambient = 0.1, .diffuse = 0.5, .specular = 0.4, .exponent = 10};
    EXPECT_NEAR(intensity({{0, 0, 0}, {0, 0, 1}, {0, 0, 1}}, light_source, finish), 1, 1e-15);
    // The normal turned by 10 degrees: r . v is the cosine of 20, n . h that of 10.
    const double a = 10 * std::acos(-1.0) / 180;
    const SurfacePoint turned{{0, 0, 0}, {std::sin(a), 0, std::cos(a)}, {0, 0, 1}};
    EXPECT_NEAR(intensity(turned, light_source, finish),
                0.1 + 0.5 * std::cos(a) + 0.4 * std::pow(std::cos(2 * a), 10), 1e-15);
    Finish blinn = finish;
    blinn.highlight = Highlight::blinn_phong;
    EXPECT_NEAR(intensity(turned, light_source, blinn),
                0.1 + 0.5 * std::cos(a) + 0.4 * std::pow(std::cos(a), 10), 1e-15);
    EXPECT_EQ(intensity({{0, 0, 0}, {0, 0, -1}, {0, 0, 1}}, light_source, finish), 0.1) << "turned away";
    const LightSource point{LightSource::Kind::point, {0, 0, 5}};
    EXPECT_NEAR(intensity({{0, 0, 0}, {0, 0, 1}, {0, 0, 1}}, point, finish), 1, 1e-15);
}

TEST(Methods, AgreeAtCornersAndPartBetweenThem) {
    const Loaded loaded = sphere(1, 64);
    const View& view = loaded.views.front();
    const Lighting lighting = lighting_of(view, Highlight::phong);
    for (std::uint32_t t = 0; t < loaded.scene.triangles.size(); ++t) {
        const Facet facet = facet_of(loaded.scene, view, t);
        for (const Weights& corner : {Weights{1, 0, 0}, Weights{0, 1, 0}, Weights{0, 0, 1}})
            EXPECT_NEAR(shaded(facet, view, lighting, Method::gouraud, corner),
                        shaded(facet, view, lighting, Method::phong, corner), 1e-12);
        EXPECT_EQ(shaded(facet, view, lighting, Method::faceted, {1, 0, 0}),
                  shaded(facet, view, lighting, Method::faceted, {third, third, third}));
    }
}

TEST(Methods, BothWaysToAPlaceOnATriangleAreOne) {
    const Loaded loaded = sphere(2, 96);
    const View& view = loaded.views.front();
    const Frame frame = rasterizer::render(loaded.scene, view);
    int compared = 0;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            if (frame.primitive.at(x, y) == PrimitiveId::none) continue;
            const Facet facet = facet_of(loaded.scene, view, std::uint32_t(frame.primitive.at(x, y)));
            const Weights a = rasterized_weights(view, facet, x, y), b = traced_weights(view, facet, x, y);
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-9);
            ++compared;
        }
    EXPECT_GT(compared, 2000);
}

// An edge from depth 1 to depth r: the weights differ by (sqrt r - 1) / (sqrt r + 1) at most, and do so.
TEST(Methods, AffineMixingIsOffByWhatIsPredicted) {
    View view;
    view.width = view.height = 64;
    const double r = 9;
    Facet facet;
    facet.p_world = {glm::dvec3{-1, 0, -1}, glm::dvec3{r, 0, -r}, glm::dvec3{0, 1, -1}};
    double most = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double s = i / 1000.0;
        most = std::max(most, std::abs(in_image(view, facet, {1 - s, s, 0})[1] - s));
    }
    EXPECT_NEAR(in_image(view, facet, {0.5, 0.5, 0})[1], r / (1 + r), 1e-12) << "the near half is larger";
    const double predicted = (std::sqrt(r) - 1) / (std::sqrt(r) + 1);
    EXPECT_LE(most, predicted + 1e-12);
    EXPECT_GT(most, 0.999 * predicted);
}

TEST(Tessellation, IsClosedAndGrowsByFour) {
    EXPECT_EQ(sphere(0, 8).scene.triangles.size(), 20u);
    EXPECT_EQ(sphere(3, 8).scene.triangles.size(), 1280u);
    EXPECT_EQ(sphere(3, 8).scene.vertices.position_world.size(), 642u) << "V = 2 + E - F";
}

TEST(Tessellation, PhongComesToTheSphereAndGouraudMissesItsHighlight) {
    View view = sphere(0, 128).views.front();
    const TessellationStudy study = study_tessellation(lighting_of(view, Highlight::phong), 3, 128);
    const auto score = [&](int level, Method method) {
        for (const LevelScore& s : study.scores)
            if (s.level == level && s.method == method) return s;
        return LevelScore{};
    };
    for (const Method method : all_methods)
        EXPECT_LT(score(3, method).rmse, 0.4 * score(1, method).rmse) << name_of(method);
    for (int level = 0; level <= 3; ++level) {
        EXPECT_LT(score(level, Method::phong).rmse, score(level, Method::gouraud).rmse);
        EXPECT_LT(score(level, Method::gouraud).rmse, score(level, Method::faceted).rmse);
        const MissedHighlight& missed = study.missed[std::size_t(level)];
        EXPECT_LE(missed.measured_peak, missed.predicted_peak + 1e-6) << "interpolation exceeds no corner";
    }
    EXPECT_GT(study.missed[0].nearest_degrees, study.missed[0].half_width_degrees);
    EXPECT_LT(study.missed[0].measured_peak, study.missed[0].sphere_peak - 0.1);
    EXPECT_GT(score(3, Method::phong).peak, study.missed[3].sphere_peak - 0.02);
}

TEST(Tessellation, BandsLieOnEdges) {
    View view = sphere(0, 192).views.front();
    const TessellationStudy study = study_tessellation(lighting_of(view, Highlight::phong), 2, 192);
    for (const LevelScore& s : study.scores) {
        if (s.method == Method::phong) continue;
        EXPECT_GT(s.bend_at_edges, 2 * s.bend_inside) << s.level << " " << name_of(s.method);
    }
}

TEST(Tessellation, BendsAreSecondDifferences) {
    Plane<double> ramp({5, 3}, 0);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) ramp.at(x, y) = x <= 2 ? x : 2;
    const Plane<float> bend = bends(ramp);
    EXPECT_EQ(bend.at(1, 1), 0);
    EXPECT_EQ(bend.at(2, 1), 1);
    EXPECT_EQ(bend.at(3, 1), 0);
    EXPECT_TRUE(std::isnan(bend.at(0, 1)));
}

TEST(ShadingStudy, RasterizedAndTracedAgreeToRoundingAndAffineKeepsToItsBound) {
    const Loaded loaded = sphere(1, 128);
    const ShadingStudy study = study_shading(loaded.scene, loaded.views.front(), [](const std::string&) {});
    EXPECT_GT(study.pixels, 5000u);
    EXPECT_EQ(study.scores.size(), 2u * 2 * 5);
    for (const SceneScore& s : study.scores) {
        if (s.mixing == Mixing::perspective) {
            EXPECT_LT(s.largest_to_traced, 1e-9) << name_of(s.method);
        } else if (s.method == Method::gouraud) {
            EXPECT_GT(s.largest_to_traced, 1e-3);
            EXPECT_LE(s.largest_to_traced, s.predicted_largest);
            EXPECT_GT(s.largest_to_traced, 0.3 * s.predicted_largest);
        }
        if (s.method == Method::phong && s.mixing == Mixing::perspective) {
            EXPECT_LT(s.largest_to_phong, 1e-9);
        }
    }
}

// Both interpolate normals by the place on the triangle. A picture of 16 bits errs by half a step; POV-Ray's
// mesh has float32 corners and normals, and a highlight's slope is its exponent.
TEST(ShadingStudy, NormalsAreMadeWhereNoneAreGiven) {
    Scene bare = sphere(3, 8).scene;
    EXPECT_EQ(with_normals(bare).vertices.normal_world, bare.vertices.normal_world);
    bare.vertices.normal_world.clear();
    const Scene smooth = with_normals(bare);
    for (std::size_t i = 0; i < bare.vertices.position_world.size(); ++i)
        EXPECT_GT(glm::dot(smooth.vertices.normal_world[i], bare.vertices.position_world[i]), 0.999f);
}

TEST(ShadingStudy, PovRaysSmoothTrianglesAreOurs) {
    const Loaded loaded = sphere(2, 96);
    const ShadingStudy study = study_shading(loaded.scene, loaded.views.front(), [](const std::string&) {});
    ASSERT_EQ(study.povray.not_asked, "");
    EXPECT_GT(study.povray.pixels, 3000u);
    EXPECT_LT(study.povray.largest, 0.5 / 65535 + 2 * 40 * 0x1p-22);
}

}  // namespace
}  // namespace zproof::study::shading
