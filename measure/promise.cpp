#include "measure/promise.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace zproof::measure {
namespace {

constexpr int finest_bits = 16, most_roundings = 1000;  ///< of the language (frame/precision.h)
using Names = std::vector<std::string_view>;            ///< how names of findings begin

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
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    throw NoPromise{"no precision promises what was measured: " + list};
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

/// More roundings allow more: the fewest are found by halving.
void promise_depth(const Measurement& measurement, RasterPrecision& promise) {
    const auto is_broken = [&](int roundings) {
        promise.depth_roundings = roundings;
        return broken(measurement, promise, {"depth_"});
    };
    int least = promise.depth_roundings, most = most_roundings;
    if (const auto names = is_broken(most); !names.empty()) refuse(names);
    while (least < most) {
        const int middle = (least + most) / 2;
        if (is_broken(middle).empty())
            most = middle;
        else
            least = middle + 1;
    }
    promise.depth_roundings = least;
}

}  // namespace

Precision measured_promise(const Measurement& measurement, const Precision& declared) {
    if (!measurement.unmeasured.empty())
        throw NoPromise{"not everything could be measured: " + measurement.unmeasured.front()};
    const auto* raster = std::get_if<RasterPrecision>(&declared);
    if (raster == nullptr) return declared;
    RasterPrecision promise = *raster;
    promise_grid(measurement, promise);
    promise_depth(measurement, promise);
    return promise;
}

}  // namespace zproof::measure
