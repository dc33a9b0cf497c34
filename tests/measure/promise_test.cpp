#include "measure/promise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "frame/precision_text.h"
#include "subjects.h"

namespace zproof::measure {
namespace {

/// The promise, as its text gives it back, is kept by what it was found from.
RasterPrecision kept_promise(const Renderer& renderer, const Precision& declared = RasterPrecision{}) {
    const Measurement measurement = measure(renderer);
    const Precision promise =
        precision_from_json(precision_to_json(measured_promise(measurement, declared)), "promise");
    EXPECT_FALSE(is_worse(findings(measurement, promise))) << precision_to_json(promise);
    return std::get<RasterPrecision>(promise);
}

TEST(MeasuredPromise, NamesTheGridAndItsSnap) {
    const RasterPrecision nearest = kept_promise(by_rules({.subpixel_bits = 6, .snap = Snap::nearest}));
    EXPECT_EQ(nearest.subpixel_bits, 6);
    EXPECT_EQ(nearest.snap, Snap::nearest);
    const RasterPrecision truncated = kept_promise(by_rules({.subpixel_bits = 10, .snap = Snap::truncate}));
    EXPECT_EQ(truncated.subpixel_bits, 10);
    EXPECT_EQ(truncated.snap, Snap::truncate);
}

TEST(MeasuredPromise, KeepsWhatPicturesCannotShow) {
    const RasterPrecision declared{.transform = Arithmetic::float64,
                                   .origin = Origin::eye,
                                   .clipping = Clipping::view_volume,
                                   .interpolation = Arithmetic::float64,
                                   .depth_roundings = 5};
    const RasterPrecision promise = kept_promise(by_rules({}), declared);
    EXPECT_EQ(promise.transform, Arithmetic::float64);
    EXPECT_EQ(promise.origin, Origin::eye);
    EXPECT_EQ(promise.clipping, Clipping::view_volume);
    EXPECT_EQ(promise.depth_roundings, 5);
}

/// Depth is off by some 60 ULP: more than two roundings, fewer than a thousand.
Renderer with_coarse_depth(double relative) {
    return with_moved_vertices([=](glm::vec3 p, glm::vec3 eye) {
        return glm::vec3{p.x, p.y, float(eye.z - (double(eye.z) - p.z) * (1 + relative))};
    });
}

TEST(MeasuredPromise, CountsTheRoundingsThatTheDepthsNeed) {
    const Measurement measurement = measure(with_coarse_depth(4e-6));
    const auto promise = std::get<RasterPrecision>(measured_promise(measurement, RasterPrecision{}));
    EXPECT_GT(promise.depth_roundings, 40);
    EXPECT_LT(promise.depth_roundings, 80);
    const auto is_kept = [&](int roundings) {
        RasterPrecision other = promise;
        other.depth_roundings = roundings;
        for (const Finding& f : findings(measurement, other))
            if (f.name.starts_with("depth_") && f.conformity == Conformity::worse) return false;
        return true;
    };
    EXPECT_TRUE(is_kept(promise.depth_roundings));
    EXPECT_FALSE(is_kept(promise.depth_roundings - 1));
}

TEST(MeasuredPromise, RefusesWhatNoPrecisionAllows) {
    EXPECT_THROW(measured_promise(measure(with_coarse_depth(1e-3)), RasterPrecision{}), NoPromise);
    EXPECT_THROW(
        measured_promise(measure(by_rules({.raster_y = rasterizer::RasterY::up})), RasterPrecision{}),
        NoPromise);
}

TEST(MeasuredPromise, OfARayCasterIsAsDeclared) {
    const Precision declared = RayPrecision{Arithmetic::float64};
    EXPECT_EQ(std::get<RayPrecision>(measured_promise(measure(by_rules({})), declared)).arithmetic,
              Arithmetic::float64);
}

}  // namespace
}  // namespace zproof::measure
