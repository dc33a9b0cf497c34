// Ray cones held to the formulas of their papers (Akenine-Moller et al. 2019 and 2021, with the erratum of
// the latter), worked out here from the world's corners.
#include "rasterizer/ray_cones.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "filters/methods/lod.h"

namespace zproof::rasterizer {
namespace {

using Corners = std::array<TexturedCorner, 3>;

/// 65 rows and columns: the middle of pixel (32, 32) looks along the axis.
View square_view() {
    View view{.name = "v", .camera = {}, .width = 65, .height = 65};
    view.camera.window = {-1, 1, -1, 1};
    return view;
}
constexpr glm::dvec2 middle{32.5, 32.5};

/// A plane through (0, 0, -10), tilted backwards about the x axis; 32 texels per unit, v down the slope.
Corners tilted(double radians) {
    const auto at = [&](double x, double up) {
        return TexturedCorner{{x, up * std::cos(radians), -10 - up * std::sin(radians)}, {32 * x, -32 * up}};
    };
    return {at(-50, -5), at(50, -5), at(0, 20)};
}

texture::Footprint with(const texture::ConeEllipse& cone) {
    texture::Footprint f;
    f.cone = cone;
    return f;
}

/// alpha = atan(2 / 65), the distance 10: w = 20 tan(alpha / 2) = 0.30762 units.
TEST(RayCones, CoverACircleOfAPlaneSeenSquareOn) {
    const texture::ConeEllipse cone = RayCones{square_view(), tilted(0)}.at(middle);
    const double w = 20 * std::tan(std::atan(2 / 65.0) / 2);
    EXPECT_NEAR(w, 0.30762, 1e-5);
    EXPECT_NEAR(glm::length(cone.along), 16 * w, 1e-12);
    EXPECT_NEAR(glm::length(cone.across), 16 * w, 1e-12);
    EXPECT_NEAR(glm::dot(cone.along, cone.across), 0, 1e-12);
    EXPECT_EQ(cone.cosine, 1);
    EXPECT_NEAR(lod_ray_cone(with(cone)), std::log2(32 * w), 1e-13);
}

/// Tilted by 60 degrees: |n . d| = 1/2. The ellipse is w long up the slope and w / 2 wide, in semi-axes.
TEST(RayCones, CoverAnEllipseOfATiltedPlane) {
    const texture::ConeEllipse cone = RayCones{square_view(), tilted(std::acos(0.5))}.at(middle);
    const double w = 20 * std::tan(std::atan(2 / 65.0) / 2);
    EXPECT_NEAR(cone.cosine, 0.5, 1e-15);
    EXPECT_NEAR(std::abs(cone.along.y), 32 * w, 1e-11);
    EXPECT_NEAR(std::abs(cone.across.x), 16 * w, 1e-11);
    EXPECT_NEAR(cone.along.x, 0, 1e-11);
    EXPECT_NEAR(cone.across.y, 0, 1e-11);
    EXPECT_NEAR(lod_ray_cone(with(cone)), std::log2(32 * w / 0.5), 1e-13);
}

/// The cone of a parallel projection has no spread: half a pixel, 1/65, at any distance.
TEST(RayCones, OfAParallelProjectionAreAsWideAsAPixel) {
    View view = square_view();
    view.camera.projection = Projection::parallel;
    const texture::ConeEllipse cone = RayCones{view, tilted(std::acos(0.5))}.at({7.5, 60.5});
    EXPECT_NEAR(glm::length(cone.across), 32 / 65.0, 1e-12);
    EXPECT_NEAR(glm::length(cone.along), 64 / 65.0, 1e-12);
}

/// By barycentrics of the displaced point, as the paper's listing has it; areas by cross products.
struct Listed {
    glm::dvec2 g1{0}, g2{0};
    double lod = 0;
};

Listed by_the_paper(const Corners& corners, const glm::dvec3& ray, double tan_alpha) {
    const auto& [p0, p1, p2] = corners;
    const glm::dvec3 e1 = p1.from_eye - p0.from_eye, e2 = p2.from_eye - p0.from_eye,
                     f = glm::normalize(glm::cross(e1, e2)), d = glm::normalize(ray);
    const double t = glm::dot(f, p0.from_eye) / glm::dot(f, d), r = t * std::tan(std::atan(tan_alpha) / 2);
    const glm::dvec3 hit = t * d;
    const auto texel_at = [&](const glm::dvec3& p) {
        const glm::dvec3 from = p - p0.from_eye;
        const double area = glm::dot(f, glm::cross(e1, e2)), u = glm::dot(f, glm::cross(from, e2)) / area,
                     v = glm::dot(f, glm::cross(e1, from)) / area;
        return (1 - u - v) * p0.texel + u * p1.texel + v * p2.texel;
    };
    const auto scaled = [&](const glm::dvec3& h) { return r / glm::length(h - glm::dot(d, h) * d) * h; };
    const glm::dvec3 a1 = scaled(d - glm::dot(f, d) * f), a2 = scaled(glm::cross(f, a1));
    const glm::dvec2 s = p1.texel - p0.texel, q = p2.texel - p0.texel;
    const double t_a = std::abs(s.x * q.y - s.y * q.x), p_a = glm::length(glm::cross(e1, e2));
    return {texel_at(hit + a1) - texel_at(hit), texel_at(hit + a2) - texel_at(hit),
            std::log2(t_a / p_a) / 2 + std::log2(2 * r) - std::log2(std::abs(glm::dot(f, d)))};
}

TEST(RayCones, OfAnyTriangleAreThoseOfTheListing) {
    std::mt19937 random{3};
    std::uniform_real_distribution<double> place{-4, 4}, texel{0, 300};
    View view = square_view();
    view.camera.window = {-0.5, 1.5, -1, 0.25};
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto corner = [&] {
            return TexturedCorner{{place(random), place(random), place(random) - 6},
                                  {texel(random), texel(random)}};
        };
        const Corners corners{corner(), corner(), corner()};
        const glm::dvec2 p{32 + 8 * place(random), 32 + 8 * place(random)};
        const texture::ConeEllipse cone = RayCones{view, corners}.at(p);
        if (cone.cosine < 0.05) continue;  // the picture holds no more than 1 / cosine of the digits
        const Listed listed = by_the_paper(corners, pixel_ray(view, p.x, p.y).to, 1.25 / 65);
        if (std::isnan(listed.lod)) continue;  // the plane lies behind the eye there
        const double size = glm::length(listed.g1) + glm::length(listed.g2);
        EXPECT_LE(glm::distance(cone.along, listed.g1), 1e-9 * size) << i;
        EXPECT_LE(std::min(glm::distance(cone.across, listed.g2), glm::distance(cone.across, -listed.g2)),
                  1e-9 * size)
            << i;
        EXPECT_NEAR(lod_ray_cone(with(cone)), listed.lod, 1e-9) << i;
        ++seen;
    }
    EXPECT_GT(seen, 1000);
}

}  // namespace
}  // namespace zproof::rasterizer
