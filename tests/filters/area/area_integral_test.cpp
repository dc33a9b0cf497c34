#include "filters/area/area_integral.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <cstring>

#include "filters/area/surfaces.h"
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

/// The rows that count.
const AreaTruth& worked_truth() {
    static const AreaTruth truth = [] {
        View view = ground_view(worked::side, worked::side, 20);
        Window& window = view.camera.window;
        window.top -= (window.top - window.bottom) * worked::first_row / worked::side;
        view.height = worked::side - worked::first_row;
        return area_truth(worked_scene(), view, Reconstruction::nearest);
    }();
    return truth;
}

double psnr(double squares, int count) { return -10 * std::log10(squares / count); }

TEST(AreaIntegral, AgreesWithAnotherProgramOnTheWorkedSetUp) {
    const AreaTruth& truth = worked_truth();
    const Homography<double> map = worked::texels_from_raster(0);
    double worst = 0;
    for (int y = worked::first_row; y < worked::side; y += 7)
        for (int x = 0; x < worked::side; ++x) {
            ASSERT_EQ(truth.kind.at(x, y - worked::first_row), TruthKind::interior) << x << " " << y;
            worst = std::max(
                worst, std::abs(truth.mean.at(x, y - worked::first_row).r - worked::exact_mean(map, x, y)));
        }
    EXPECT_LT(worst, 1e-11);
}

/// Reference figures of the worked set-up, to the digits given.
TEST(AreaIntegral, PointSamplesAndBilinearOnesAreAsFarOffAsKnown) {
    const AreaTruth& truth = worked_truth();
    const Homography<double> map = worked::texels_from_raster(0);
    const auto white = [](std::int64_t k, std::int64_t l) {
        const auto odd = [](std::int64_t i) { return std::int64_t(std::floor(double(i) / 32)) & 1; };
        return odd(k) == odd(l) ? 1.0 : 0.0;
    };
    double point = 0, bilinear = 0;
    for (int y = worked::first_row; y < worked::side; ++y)
        for (int x = 0; x < worked::side; ++x) {
            const auto [u, v] = map.at(x + 0.5, y + 0.5);
            const double exact = truth.mean.at(x, y - worked::first_row).r, s = u - 0.5 - std::floor(u - 0.5),
                         t = v - 0.5 - std::floor(v - 0.5);
            const auto k = std::int64_t(std::floor(u - 0.5)), l = std::int64_t(std::floor(v - 0.5));
            const double mixed = (1 - s) * (1 - t) * white(k, l) + s * (1 - t) * white(k + 1, l) +
                                 (1 - s) * t * white(k, l + 1) + s * t * white(k + 1, l + 1);
            point += std::pow(white(std::int64_t(std::floor(u)), std::int64_t(std::floor(v))) - exact, 2);
            bilinear += std::pow(mixed - exact, 2);
        }
    const int count = worked::side * (worked::side - worked::first_row);
    EXPECT_NEAR(psnr(point, count), 13.88, 0.005);
    EXPECT_NEAR(psnr(bilinear, count), 14.82, 0.005);
}

/// Noise seen to the horizon, with texels both smaller and larger than pixels.
Scene noisy_ground() {
    return textured_plane(
        64, {.image = noise(37, 23, 5), .per_unit = 0.11, .phi_degrees = 25, .offset = {0.3, 0.71}});
}

/// How many pixels lie outside their 95 % interval, and the mean of (exact - estimate).
struct Agreement {
    int estimated = 0, outside = 0;
    double mean_difference = 0, rms = 0, mean_half_width = 0;
};

Agreement agreement(const AreaTruth& exact, const AreaTruth& samples) {
    Agreement a;
    for (int y = 0; y < exact.mean.size().height; ++y)
        for (int x = 0; x < exact.mean.size().width; ++x) {
            if (exact.kind.at(x, y) == TruthKind::sampled || exact.kind.at(x, y) == TruthKind::background)
                continue;
            const glm::dvec3 difference = exact.mean.at(x, y) - samples.mean.at(x, y);
            const double worst =
                std::max({std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
            ++a.estimated;
            a.outside += worst > samples.half_width.at(x, y) + exact.half_width.at(x, y);
            a.mean_difference += difference.r;
            a.rms += difference.r * difference.r;
            a.mean_half_width += samples.half_width.at(x, y);
        }
    a.mean_difference /= a.estimated;
    a.rms = std::sqrt(a.rms / a.estimated);
    a.mean_half_width /= a.estimated;
    return a;
}

class EveryReconstruction : public testing::TestWithParam<NamedReconstruction> {};
INSTANTIATE_TEST_SUITE_P(AreaIntegral, EveryReconstruction, testing::ValuesIn(reconstructions));

TEST_P(EveryReconstruction, LiesWithinTheIntervalOfItsSamples) {
    const Scene scene = noisy_ground();
    const View view = ground_view(40, 30, 20);
    const Reconstruction what = GetParam().reconstruction;
    const Agreement a = agreement(area_truth(scene, view, what), sampled_area_truth(scene, view, what));
    EXPECT_GT(a.estimated, 700);
    // Of three channels the worst is outside at up to 15 in 100 pixels where all is well.
    EXPECT_LT(a.outside, 0.15 * a.estimated);
    EXPECT_LT(std::abs(a.mean_difference), 4 * a.rms / std::sqrt(a.estimated));
}

/// The mean over a pixel is the mean over its quarters.
TEST(AreaIntegral, IsAdditive) {
    const Scene scene = noisy_ground();
    for (const Reconstruction what : {Reconstruction::nearest, Reconstruction::bilinear}) {
        const AreaTruth coarse = area_truth(scene, ground_view(24, 20, 35), what),
                        fine = area_truth(scene, ground_view(48, 40, 35), what);
        double worst = 0;
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 24; ++x) {
                glm::dvec3 sum(0);
                for (int i = 0; i < 4; ++i) sum += fine.mean.at(2 * x + i % 2, 2 * y + i / 2) / 4.0;
                ASSERT_EQ(coarse.kind.at(x, y), TruthKind::interior);
                worst = std::max(worst, glm::length(sum - coarse.mean.at(x, y)));
            }
        EXPECT_LT(worst, what == Reconstruction::nearest ? 1e-12 : 1e-8);
    }
}

bool same_bits(const AreaTruth& a, const AreaTruth& b) {
    const auto same = [](auto p, auto q) {
        return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size_bytes()) == 0;
    };
    return same(a.mean.pixels(), b.mean.pixels()) && same(a.kind.pixels(), b.kind.pixels()) &&
           same(a.half_width.pixels(), b.half_width.pixels());
}

TEST_P(EveryReconstruction, GivesTheSameBitsOnAnyNumberOfThreads) {
    const Scene scene = textured_plane(64, {.image = noise(37, 23, 5), .per_unit = 30});
    const View view = ground_view(12, 24, 5);
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 3);
    AreaTruth one, three;
    tbb::task_arena(1).execute([&] { one = area_truth(scene, view, GetParam().reconstruction); });
    tbb::task_arena(3).execute([&] { three = area_truth(scene, view, GetParam().reconstruction); });
    EXPECT_TRUE(same_bits(one, three));
    EXPECT_GT(std::ranges::count(one.kind.pixels(), TruthKind::sampled), 0);
}

}  // namespace

}  // namespace zproof::oracle
