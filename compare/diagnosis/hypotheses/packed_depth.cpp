#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "frame/number_text.h"
#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A number from 0 to 1 was written as digits of one base, and read as digits of another, times a factor.
struct Packing {
    int written, read;
    double factor;
    const char* mistake;

    /// Digits of three bytes at least: what follows them is less than a step.
    double step() const { return std::pow(read, -3); }
    /// Where the first digit changes, what is read may fall back by so much.
    double slip() const { return written > read ? std::pow(read, -2) : 0; }
    double of(double number) const {
        double sum = 0, weight = factor;
        for (int digit = 0; digit < 5; ++digit) {
            const double whole = std::floor(number * written);
            number = number * written - whole;
            weight /= read;
            sum += whole * weight;
        }
        return sum;
    }
    ReportedDepth operator()(double low, double high) const {
        const double room = step() + (std::floor(low * written) < std::floor(high * written) ? slip() : 0);
        return {of(low) - room, of(high) + room};
    }
};

constexpr const char* for_255 = "depth is packed in bytes with 256 for 255";
constexpr const char* for_256 = "depth is packed in bytes with 255 for 256";

// of a number whose bytes count as b / 255, the next by 1/255 or 1/256 less; or b / 256
constexpr std::array packings{Packing{255, 256, 256.0 / 255, for_255}, Packing{255, 256, 1, for_255},
                              Packing{256, 255, 1, for_256}, Packing{256, 256, 256.0 / 255, for_256},
                              Packing{256, 256, 255.0 / 256, for_255}};

/// What is packed: a number from 0 to 1 that grows with depth, and back.
struct PackedNumber {
    const char* name;
    std::function<double(double depth)> of;
    std::function<double(double number)> depth;  ///< grows; infinite from some number on
};

std::vector<PackedNumber> packed_numbers(const Camera& c) {
    const double near = c.near_depth, far = c.far_depth;
    std::vector<PackedNumber> all{
        {"(depth - near) / (far - near)", [=](double depth) { return (depth - near) / (far - near); },
         [=](double number) { return near + number * (far - near); }},
        {"depth / far", [=](double depth) { return depth / far; },
         [=](double number) { return number * far; }}};
    if (c.projection == Projection::perspective)
        all.push_back({"window z",
                       [=](double depth) { return far * (depth - near) / (depth * (far - near)); },
                       [=](double number) {
                           const double divisor = far - number * (far - near);
                           return divisor > 0 ? near * far / divisor : never;
                       }});
    return all;
}

Hypothesis packed(const DiagnosisInput& input, const Packing& packing, const PackedNumber& number) {
    Hypothesis h = as_declared(
        input, {packing.mistake,
                std::string("Bytes hold ") + number.name + " to base " + std::to_string(packing.written) +
                    ", and are read to base " + std::to_string(packing.read) + ", times " +
                    with_digits(packing.factor, 6) + ".",
                "Look at packing and unpacking of depth into bytes: both must use one base, 255 or 256."});
    // a quotient, a product, a sum and the store, of a number of size 1; then of the depth
    const double rounding = gamma(4, unit_roundoff_float32);
    h.report = [=](const DepthBound& bound, const Claim&) {
        const ReportedDepth read =
            packing(std::max(0.0, number.of(bound.low) - rounding), number.of(bound.high) + rounding);
        const double low = number.depth(read.low - rounding), high = number.depth(read.high + rounding);
        return ReportedDepth{low - rounding * std::abs(low), high + rounding * std::abs(high)};
    };
    h.restate = [](Claim claim) -> std::optional<Claim> {
        if (claim.answer.primitive == PrimitiveId::none) claim.answer.camera_depth = background_depth;
        return claim;
    };
    return h;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_packed_depth(const DiagnosisInput& input) {
    const Camera& c = input.view.camera;
    if (!std::isfinite(c.far_depth) || c.near_depth < 0) return {};
    std::vector<Hypothesis> all;
    for (const PackedNumber& number : packed_numbers(c))
        for (const Packing& packing : packings) all.push_back(packed(input, packing, number));
    return all;
}

}  // namespace zproof
