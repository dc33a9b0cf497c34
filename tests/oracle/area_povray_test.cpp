// The exact mean against POV-Ray's pictures with many samples per pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/area_integral.h"
#include "oracle/povray.h"
#include "scenes_at_random.h"
#include "textured_plane.h"

namespace zproof::oracle {

namespace {

constexpr int side = 6, replicates = 6;     ///< samples per pixel and axis; shifts of their grid
constexpr double student_5 = 2.5705818356;  ///< t of 5 degrees of freedom, two-sided 95 %

/// Means of side x side pixels, each sample at its cell's centre plus the shift (in cells, less than 1/2).
Plane<glm::dvec3> averaged(const Scene& scene, View view, const glm::dvec2& shift) {
    const Resolution size{view.width, view.height};
    view.width *= side, view.height *= side;
    Window& w = view.camera.window;
    const double right = shift.x * (w.right - w.left) / view.width,
                 down = shift.y * (w.top - w.bottom) / view.height;
    w = {w.left + right, w.right + right, w.bottom - down, w.top - down};
    const Picture picture = PovRay(scene).picture(view, Light{.ambient = 1, .diffuse = 0});
    Plane<glm::dvec3> mean(size, glm::dvec3(0));
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const LinearRgb c = picture.at(x, y);
            mean.at(x / side, y / side) += glm::dvec3(c.r, c.g, c.b) / double(side * side);
        }
    return mean;
}

/// Every sample is uniform in its cell, so that each replicate is an unbiased estimate.
std::vector<Plane<glm::dvec3>> estimates(const Scene& scene, const View& view) {
    Rng rng(11);
    std::vector<Plane<glm::dvec3>> pictures;
    for (int i = 0; i < replicates; ++i) {
        const double right = rng.between(-0.5, 0.5), down = rng.between(-0.5, 0.5);
        pictures.push_back(averaged(scene, view, {right, down}));
    }
    return pictures;
}

/// (exact - mean of the replicates) and half its interval, for one channel of a pixel.
struct Comparison {
    double difference = 0, half_width = 0;
};

Comparison compared(double exact, const std::array<double, replicates>& values) {
    double mean = 0, squares = 0;
    for (const double v : values) mean += v / replicates;
    for (const double v : values) squares += (v - mean) * (v - mean);
    constexpr double code_step = 0.5 / 65535;  // of a channel
    return {exact - mean, student_5 * std::sqrt(squares / (replicates * (replicates - 1))) + code_step};
}

class WithPovRay : public testing::TestWithParam<Reconstruction> {};
INSTANTIATE_TEST_SUITE_P(AreaIntegral, WithPovRay,
                         testing::Values(Reconstruction::nearest, Reconstruction::bilinear));

TEST_P(WithPovRay, LiesWithinTheIntervalOfItsPictures) {
    Scene scene = textured_plane(
        64, {.image = noise(37, 23, 5), .per_unit = 0.11, .phi_degrees = 25, .offset = {0.3, 0.71}});
    if (GetParam() == Reconstruction::nearest)
        scene.materials[0].base_color.sampler.magnification = Magnification::nearest;
    const View view = ground_view(24, 18, 20);
    const AreaTruth exact = area_truth(scene, view, GetParam());
    const auto pictures = estimates(scene, view);
    int count = 0, outside = 0;
    double sum = 0, squares = 0;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            if (exact.kind.at(x, y) == TruthKind::background) continue;
            std::array<double, replicates> values{};
            for (std::size_t i = 0; i < replicates; ++i) values[i] = pictures[i].at(x, y).g;
            const Comparison c = compared(exact.mean.at(x, y).g, values);
            ++count;
            outside += std::abs(c.difference) > c.half_width;
            sum += c.difference;
            squares += c.difference * c.difference;
        }
    EXPECT_GT(count, 200);
    EXPECT_LT(outside, 0.1 * count);
    EXPECT_LT(std::abs(sum), 4 * std::sqrt(squares));
}

}  // namespace

}  // namespace zproof::oracle
