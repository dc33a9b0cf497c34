// Views as callers state them, held against the sentences of zproof/zproof.h by arithmetic of their own.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "zproof/data.h"
#include "zproof/zproof.h"

namespace zproof::api {
namespace {

using Point = std::array<double, 3>;

double dot(const double* row, const Point& p) { return row[0] * p[0] + row[1] * p[1] + row[2] * p[2]; }

/// The image of a point by K (R p + t), in OpenCV's pixels.
std::array<double, 2> by_opencv(const View::OpenCv& c, const Point& p_world) {
    Point p{};
    for (int i = 0; i < 3; ++i) p[i] = dot(&c.R[3 * i], p_world) + c.t[i];
    return {dot(&c.K[0], p) / p[2], dot(&c.K[3], p) / p[2]};
}

/// The same by the matrices, in raster space.
std::array<double, 2> by_matrices(const View& view, const Point& p_world) {
    const auto [camera, clip] = view.matrices();
    const auto times = [](const std::array<double, 16>& m, const std::array<double, 4>& v) {
        std::array<double, 4> product{};
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k) product[i] += m[4 * i + k] * v[k];
        return product;
    };
    const auto p = times(clip, times(camera, {p_world[0], p_world[1], p_world[2], 1}));
    return {(p[0] / p[3] + 1) / 2 * view.size().width, (1 - p[1] / p[3]) / 2 * view.size().height};
}

/// About an axis, by Rodrigues' formula.
std::array<double, 9> rotation(const Point& axis, double angle) {
    const double length = std::sqrt(dot(axis.data(), axis));
    const double x = axis[0] / length, y = axis[1] / length, z = axis[2] / length, c = std::cos(angle),
                 s = std::sin(angle), d = 1 - c;
    return {c + x * x * d,     x * y * d - z * s, x * z * d + y * s, y * x * d + z * s, c + y * y * d,
            y * z * d - x * s, z * x * d - y * s, z * y * d + x * s, c + z * z * d};
}

struct RandomCameras {
    std::mt19937 generator{42};
    double draw(double low, double high) { return std::uniform_real_distribution<>(low, high)(generator); }
    View::OpenCv next() {
        const double fx = draw(50, 900), fy = draw(50, 900);
        return {.K = {fx, 0, draw(0, 200), 0, fy, draw(0, 100), 0, 0, 1},
                .R = rotation({draw(-1, 1), draw(-1, 1), draw(-1, 1)}, draw(0, 3)),
                .t = {draw(-3, 3), draw(-3, 3), draw(-3, 3)}};
    }
};

TEST(ApiView, OfOpenCvProjectsAsKAndRAndTSayHalfAPixelOn) {
    RandomCameras cameras;
    for (int i = 0; i < 200; ++i) {
        const View view = View::from_opencv(cameras.next(), {200, 100}, 0.1, 100);
        const View::OpenCv judged = view.opencv();
        const Point p{cameras.draw(-9, 9), cameras.draw(-9, 9), cameras.draw(-9, 9)};
        const auto theirs = by_opencv(judged, p), ours = by_matrices(view, p);
        const double tolerance = 1e-9 * (1 + std::abs(theirs[0]) + std::abs(theirs[1]));
        EXPECT_NEAR(theirs[0] + 0.5, ours[0], tolerance);
        EXPECT_NEAR(theirs[1] + 0.5, ours[1], tolerance);
    }
}

TEST(ApiView, OfOpenCvIsTheCameraThatCameButForTheEyesFloat32) {
    RandomCameras cameras;
    for (int i = 0; i < 50; ++i) {
        const View::OpenCv given = cameras.next();
        const View::OpenCv judged = View::from_opencv(given, {200, 100}, 0.1, 100).opencv();
        for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(given.K[k], judged.K[k], 1e-9);
        for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(given.R[k], judged.R[k], 1e-14);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(given.t[k], judged.t[k], 1e-6);
        const View again = View::from_opencv(judged, {200, 100}, 0.1, 100);
        EXPECT_EQ(again.data().view.camera.eye_world,
                  View::from_opencv(given, {200, 100}, 0.1, 100).data().view.camera.eye_world);
    }
}

TEST(ApiView, ARotationInFloat32IsTakenAndWhatIsNoneIsNot) {
    View::OpenCv camera = RandomCameras{}.next();
    for (double& r : camera.R) r = float(r);
    EXPECT_NO_THROW(View::from_opencv(camera, {200, 100}, 0.1, 100));
    View::OpenCv mirrored = camera, scaled = camera;
    for (int i = 0; i < 3; ++i) mirrored.R[i] = -mirrored.R[i];
    for (double& r : scaled.R) r *= 1.001;
    for (const View::OpenCv& bad : {mirrored, scaled})
        EXPECT_THROW(View::from_opencv(bad, {200, 100}, 0.1, 100), InputError);
    camera.R[4] = std::nan("");
    EXPECT_THROW(View::from_opencv(camera, {200, 100}, 0.1, 100), InputError);
}

TEST(ApiView, KWithSkewOrWithoutFocalLengthIsRefused) {
    const View::OpenCv camera = RandomCameras{}.next();
    for (const std::size_t entry : {0, 1, 3, 4, 6, 7, 8}) {
        View::OpenCv bad = camera;
        bad.K[entry] = entry == 0 || entry == 4 ? 0 : 0.5;
        EXPECT_THROW(View::from_opencv(bad, {200, 100}, 0.1, 100), InputError) << entry;
    }
}

TEST(ApiView, PerspectiveLooksAtItsTarget) {
    const View view = View::perspective(
        {.eye = {1, 2, 3}, .target = {4, -5, 6}, .near_depth = 0.1, .far_depth = 100, .size = {64, 48}}, 0.7);
    const auto centre = by_matrices(view, {4, -5, 6});
    EXPECT_NEAR(centre[0], 32, 1e-9);
    EXPECT_NEAR(centre[1], 24, 1e-9);
    EXPECT_NEAR(view.opencv().K[4], 24 / std::tan(0.35), 1e-9);
}

TEST(ApiView, WhatIsOutOfRangeIsRefused) {
    const View::Placed placed{.eye = {0, 0, 3}, .near_depth = 0.1, .far_depth = 10, .size = {8, 8}};
    EXPECT_NO_THROW(View::perspective(placed, 1));
    for (const double yfov : {0.0, -1.0, 3.2, std::nan("")})
        EXPECT_THROW(View::perspective(placed, yfov), InputError) << yfov;
    const auto without = [&](auto change) {
        View::Placed changed = placed;
        change(changed);
        EXPECT_THROW(View::perspective(changed, 1), InputError);
    };
    without([](View::Placed& p) { p.size = {0, 8}; });
    without([](View::Placed& p) { p.size = {8, 32769}; });
    without([](View::Placed& p) { p.near_depth = 0; });
    without([](View::Placed& p) { p.far_depth = 0.05; });
    without([](View::Placed& p) { p.eye[0] = std::nan(""); });
    without([](View::Placed& p) { p.target = p.eye; });
    without([](View::Placed& p) { p.name = "a/b"; });
    without([](View::Placed& p) { p.name = ""; });
    EXPECT_THROW(View::orthographic({.eye = {0, 0, 3}, .size = {8, 8}}, 2), InputError) << "far is infinite";
    EXPECT_THROW(View::orthographic(placed, 2).opencv(), InputError);
}

}  // namespace
}  // namespace zproof::api
