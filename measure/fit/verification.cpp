#include "measure/fit/verification.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/judge.h"
#include "measure/fit/octaves.h"

namespace zproof::measure {
namespace {

constexpr PrimitiveId no_triangle{0xFFFF'FFFE};  // an id that no scene has

Frame frame_without_answers(Resolution size) {
    Frame frame(size);
    frame.primitive = Plane<PrimitiveId>(size, no_triangle);
    frame.camera_depth = Plane<float>(size, std::numeric_limits<float>::quiet_NaN());
    return frame;
}

}  // namespace

double rounded_up(double value) {
    const int decimals = 2 - int(std::floor(std::log10(value)));
    const double power = std::pow(10.0, std::abs(decimals));
    const auto scaled = [&](double digits) { return decimals >= 0 ? digits / power : digits * power; };
    double digits = std::ceil(decimals >= 0 ? value * power : value / power);
    while (scaled(digits) < value) ++digits;
    return scaled(digits);
}

double promised_relative(double error) { return rounded_up(std::max(error, std::ldexp(1.0, least_octave))); }

std::vector<PixelCoord> defects_under(const BoundedPrecision& promise, const Scene& scene, const View& view,
                                      const Frame& frame) {
    const Frame nobody = frame_without_answers(frame.size());
    std::vector<PixelCoord> defects;
    for (const zproof::Finding& f : judge(scene, view, {frame, promise}, {nobody, promise}).findings)
        if (f.verdict != PixelClass::wrong_attribute) defects.push_back({f.x, f.y});  // of ids and depths
    return defects;
}

}  // namespace zproof::measure
