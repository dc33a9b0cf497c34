#include "lessons/depth/format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace zproof::study::depth {
namespace {

using enum Coding;
using enum NdcRange;
using enum Store;

constexpr std::array all_formats{
    Format{"z-unorm16", z, zero_to_one, unorm16},
    Format{"z-unorm16-gl", z, minus_one_to_one, unorm16},
    Format{"z-unorm24", z, zero_to_one, unorm24},
    Format{"z-unorm24-gl", z, minus_one_to_one, unorm24},
    Format{"z-float32", z, zero_to_one, float32},
    Format{"z-float32-gl", z, minus_one_to_one, float32},
    Format{"reversed-float32", reversed, zero_to_one, float32},
    Format{"reversed-float32-gl", reversed, minus_one_to_one, float32},
    Format{"w-unorm16", w, zero_to_one, unorm16},
    Format{"w-unorm24", w, zero_to_one, unorm24},
    Format{"w-float32", w, zero_to_one, float32},
    Format{"log-unorm16", logarithmic, zero_to_one, unorm16},
    Format{"log-unorm24", logarithmic, zero_to_one, unorm24},
    Format{"log-float32", logarithmic, zero_to_one, float32},
};

double largest_code(Store store) { return std::exp2(bits_of(store)) - 1; }

}  // namespace

std::span<const Format> formats() { return all_formats; }

const Format& format_named(const std::string& name) {
    const auto found = std::ranges::find_if(all_formats, [&](const Format& f) { return name == f.name; });
    if (found == all_formats.end()) throw std::out_of_range("no depth format is called " + name);
    return *found;
}

int bits_of(Store store) {
    switch (store) {
        case float32:
            return 32;
        case unorm24:
            return 24;
        case unorm16:
            return 16;
    }
    return 0;
}

std::string definition_of(const Format& format) {
    const std::string bits =
        format.store == float32 ? "float32" : std::to_string(bits_of(format.store)) + " bits, whole numbers";
    const std::string window = format.range == minus_one_to_one ? " in [-1, 1], then z/2 + 1/2" : "";
    switch (format.coding) {
        case z:
            return "z = a + b/d, near 0, far 1" + window + "; " + bits;
        case reversed:
            return "z = a + b/d, near 1, far 0" + window + "; " + bits;
        case w:
            return "(d - n) / (f - n); " + bits;
        case logarithmic:
            return "log(d/n) / log(f/n); " + bits;
    }
    return bits;
}

bool is_affine_in_image(Coding coding) {
    switch (coding) {
        case z:
        case reversed:
            return true;
        case w:
        case logarithmic:
            return false;
    }
    return false;
}

bool grows_with_depth(Coding coding) {
    switch (coding) {
        case z:
        case w:
        case logarithmic:
            return true;
        case reversed:
            return false;
    }
    return false;
}

bool can_hold(Coding coding, const Planes& planes) {
    return is_affine_in_image(coding) || std::isfinite(planes.far);
}

/// n / f is 0 for an infinite far plane, and nothing else has f in it.
Constants constants_of(const Format& format, const Planes& planes) {
    const double n = planes.near, f = planes.far, span = 1 - n / f;
    const bool doubled = format.range == minus_one_to_one;
    switch (format.coding) {
        case z:
            return {.a = (doubled ? 1 + n / f : 1) / span,
                    .b = -(doubled ? 2 : 1) * n / span,
                    .near = n,
                    .half = doubled ? 0.5 : 1};
        case reversed:
            return {.a = -(doubled ? 1 + n / f : n / f) / span,
                    .b = (doubled ? 2 : 1) * n / span,
                    .near = n,
                    .half = doubled ? 0.5 : 1};
        case w:
            return {.k = 1 / (f - n), .near = n};
        case logarithmic:
            return {.k = 1 / std::log2(f / n), .near = n};
    }
    return {};
}

Coder::Coder(const Format& format, const Planes& planes)
    : format_(format),
      exact_(constants_of(format, planes)),
      a_(float(exact_.a)),
      b_(float(exact_.b)),
      k_(float(exact_.k)),
      near_(float(exact_.near)),
      inverse_near_(float(1 / exact_.near)) {}

float Coder::in_window(float z_ndc) const {
    return format_.range == minus_one_to_one ? 0.5f * z_ndc + 0.5f : z_ndc;
}

float Coder::of_depth(float depth) const {
    switch (format_.coding) {
        case z:
        case reversed:
            return in_window((a_ * depth + b_) / depth);
        case w:
            return (depth - near_) * k_;
        case logarithmic:
            return std::log2(depth * inverse_near_) * k_;
    }
    return 0;
}

float Coder::of_inverse(float inverse) const {
    return is_affine_in_image(format_.coding) ? in_window(a_ + b_ * inverse) : of_depth(1 / inverse);
}

double Coder::stored(float s) const {
    const double most = largest_code(format_.store);
    switch (format_.store) {
        case float32:
            return std::isnan(s) ? s : std::clamp(s, 0.0f, 1.0f);
        case unorm24:
        case unorm16:
            return std::isnan(s) ? 0 : std::nearbyint(std::clamp(double(s), 0.0, 1.0) * most) / most;
    }
    return 0;
}

double Coder::ideal(double depth) const {
    const Constants& c = exact_;
    switch (format_.coding) {
        case z:
        case reversed:
            return (c.a + c.b / depth) * c.half + (1 - c.half);
        case w:
            return (depth - c.near) * c.k;
        case logarithmic:
            return std::log2(depth / c.near) * c.k;
    }
    return 0;
}

double Coder::depth_of(double s) const {
    const Constants& c = exact_;
    switch (format_.coding) {
        case z:
        case reversed:
            return c.b / ((s - (1 - c.half)) / c.half - c.a);
        case w:
            return c.near + s / c.k;
        case logarithmic:
            return c.near * std::exp2(s / c.k);
    }
    return 0;
}

}  // namespace zproof::study::depth
