#include "compare/diagnosis/hypothesis.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

namespace zproof {

namespace {

/// Where a float32 stands among all of them.
double place_among_floats(double value) {
    const auto bits = std::bit_cast<std::int32_t>(float(value));
    return bits >= 0 ? bits : -double(bits & 0x7FFF'FFFF);
}

}  // namespace

double floats_within(const ReportedDepth& range) {
    return std::max(0.0, place_among_floats(range.high) - place_among_floats(range.low)) + 1;
}

Hypothesis as_declared(const DiagnosisInput& input, Cause cause) {
    return {.cause = std::move(cause),
            .cell = {input.view.width, input.view.height},
            .view = input.view,
            .precision = input.candidate.precision,
            .restate = nullptr,
            .amend = nullptr,
            .report = nullptr};
}

double bits_of_an_id(const DiagnosisInput& input) {
    if (!input.said) return std::log2(double(input.scene.triangles.size()) + 1);
    const auto& of_triangle = input.said->labels.of_triangle;
    return std::log2(double(std::set(of_triangle.begin(), of_triangle.end()).size()) + 1);
}

}  // namespace zproof
