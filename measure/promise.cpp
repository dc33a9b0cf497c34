#include "measure/promise.h"
#include "frame/joined.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace zproof::measure {
namespace {

constexpr int finest_bits = 16;     ///< of the language (frame/precision.h)
constexpr int most_roundings = 64;  ///< no format of a depth buffer is taken for a finer one with more
using Names = std::vector<std::string_view>;  ///< how names of findings begin

/// The names of those findings that the promise does not keep.
std::vector<std::string> broken(const Measurement& measurement, const RasterPrecision& promise,
                                const Names& concerned) {
    std::vector<std::string> names;
    for (const Finding& finding : findings(measurement, promise)) {
        const bool concerns = std::ranges::any_of(
            concerned, [&](std::string_view beginning) { return finding.name.starts_with(beginning); });
        if (concerns && finding.conformity == Conformity::worse) names.push_back(finding.name);
    }
    return names;
}

[[noreturn]] void refuse(const std::vector<std::string>& names) {
    throw NoPromise{"no precision promises what was measured: " + joined(names)};
}

/// The finest grid, and the stricter snap on it, that the vertices keep.
void promise_grid(const Measurement& measurement, RasterPrecision& promise) {
    const Names concerned{"subpixel_bits", "vertex_shift", "snap"};
    for (promise.subpixel_bits = finest_bits; promise.subpixel_bits >= 0; --promise.subpixel_bits)
        for (const Snap snap : {Snap::nearest, Snap::truncate}) {
            promise.snap = snap;
            if (broken(measurement, promise, concerned).empty()) return;
        }
    promise.subpixel_bits = 0;
    refuse(broken(measurement, promise, concerned));
}

/// The depth buffers that are tried, the finest first.
struct Buffer {
    DepthBuffer depth_buffer;
    DepthFormat format;
    DepthInterpolation interpolation;
};
constexpr std::array buffers{
    Buffer{DepthBuffer::camera_depth, DepthFormat::float32, DepthInterpolation::barycentrics},
    Buffer{DepthBuffer::reversed_z, DepthFormat::float32, DepthInterpolation::plane},
    Buffer{DepthBuffer::standard_z, DepthFormat::unorm32, DepthInterpolation::plane},
    Buffer{DepthBuffer::standard_z, DepthFormat::float32, DepthInterpolation::plane},
    Buffer{DepthBuffer::standard_z, DepthFormat::unorm24, DepthInterpolation::plane},
    Buffer{DepthBuffer::standard_z, DepthFormat::unorm16, DepthInterpolation::plane},
};

/// The fewest roundings, found by halving: more allow more. False where the most do not suffice.
bool promise_roundings(const Measurement& measurement, RasterPrecision& promise, int fewest) {
    const auto is_broken = [&](int roundings) {
        promise.depth_roundings = roundings;
        return broken(measurement, promise, {"depth_"});
    };
    int least = fewest, most = most_roundings;
    if (!is_broken(most).empty()) return false;
    while (least < most) {
        const int middle = (least + most) / 2;
        if (is_broken(middle).empty())
            most = middle;
        else
            least = middle + 1;
    }
    promise.depth_roundings = least;
    return true;
}

/// What was declared, or else the finest buffer that does.
void promise_depth(const Measurement& measurement, RasterPrecision& promise) {
    const int fewest = promise.depth_roundings;
    if (promise_roundings(measurement, promise, fewest)) return;
    const std::vector<std::string> names = broken(measurement, promise, {"depth_"});
    for (const Buffer& buffer : buffers) {
        promise.depth_buffer = buffer.depth_buffer;
        promise.depth_format = buffer.format;
        promise.depth_interpolation = buffer.interpolation;
        promise.matrix_far = MatrixFar::finite;
        promise.clip_range = ClipRange::minus_one_to_one;
        if (promise_roundings(measurement, promise, fewest)) return;
    }
    refuse(names);
}

}  // namespace

Precision measured_promise(const Measurement& measurement, const Precision& declared) {
    if (!measurement.unmeasured.empty())
        throw NoPromise{"not everything could be measured: " + measurement.unmeasured.front()};
    const auto* raster = std::get_if<RasterPrecision>(&declared);
    if (raster == nullptr) return declared;
    RasterPrecision promise = *raster;
    if (measurement.watertightness) promise.watertight = measurement.watertightness->holes == 0;
    promise_grid(measurement, promise);
    promise_depth(measurement, promise);
    return promise;
}

}  // namespace zproof::measure
