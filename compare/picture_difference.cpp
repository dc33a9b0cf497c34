#include "compare/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace zproof {

namespace {

double distance(float a, float b) {
    const double d = std::abs(double{a} - double{b});
    return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
}

/// Until the end, rms and mean hold sums.
void add(PictureDifference& sum, const LinearRgb& a, const LinearRgb& b) {
    ++sum.pixels;
    for (const double d : {distance(a.r, b.r), distance(a.g, b.g), distance(a.b, b.b)}) {
        sum.rms += d * d;
        sum.mean += d;
        sum.largest = std::max(sum.largest, d);
    }
}

void divide_by_count(PictureDifference& sum) {
    if (sum.pixels == 0) return;
    const double channels = 3.0 * double(sum.pixels);
    sum.rms = std::sqrt(sum.rms / channels);
    sum.mean /= channels;
}

}  // namespace

PictureDifferences differences(const Picture& a, const Picture& b, const Plane<PixelClass>& classes) {
    if (a.size() != b.size() || a.size() != classes.size())
        throw std::invalid_argument{"differences: planes of different sizes"};
    PictureDifferences sums{};
    for (std::size_t i = 0; i < classes.pixels().size(); ++i)
        add(sums[std::size_t(classes.pixels()[i])], a.pixels()[i], b.pixels()[i]);
    std::ranges::for_each(sums, divide_by_count);
    return sums;
}

Plane<PixelClass> severer(const Plane<PixelClass>& a, const Plane<PixelClass>& b) {
    if (a.size() != b.size()) throw std::invalid_argument{"severer: planes of different sizes"};
    Plane<PixelClass> worst = a;
    for (std::size_t i = 0; i < worst.pixels().size(); ++i)
        worst.pixels()[i] = std::max(a.pixels()[i], b.pixels()[i]);
    return worst;
}

}  // namespace zproof
