#include <algorithm>
#include <array>
#include <cmath>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "frame/number_text.h"
#include "math/rounding.h"

namespace zproof {

namespace {

std::string bits_text(int bits) {
    return std::to_string(bits) + (bits == 1 ? " sub-pixel bit" : " sub-pixel bits");
}

Hypothesis as_precise_as(const DiagnosisInput& input, const Cause& cause, const RasterPrecision& precision) {
    Hypothesis h = as_declared(input, cause);
    h.precision = precision;
    h.only_permits = true;
    return h;
}

/// Rounding down is rounding to nearest of an image that stands half a step further up and left.
Hypothesis truncating(const DiagnosisInput& input, const RasterPrecision& declared, double direction,
                      const std::string& how) {
    Hypothesis h =
        as_declared(input, {"vertices are snapped " + how,
                            "Vertices go to the next grid point " + how + " instead of the nearest.",
                            "Look at the conversion to fixed point: round to the nearest, do not cut."});
    const double half_step = std::ldexp(0.5, -declared.subpixel_bits);
    h.moves_triangles = true;
    h.only_permits = true;
    h.view = shifted_view(input.view, glm::dvec2(direction * half_step));
    return h;
}

/// How far a triangle may be displaced, its distance from the eye apart.
double eps_base_px(const DiagnosisInput& input, const Precision& precision) {
    return ViewBounds(input.view, precision).of(corners_of(input.scene, 0)).eps_base_px;
}

/// Fewer bits and lesser arithmetic, the least displacement first.
std::vector<Hypothesis> of_coordinates(const DiagnosisInput& input, const RasterPrecision& declared) {
    std::vector<Hypothesis> all;
    if (declared.transform == Arithmetic::float64) {
        RasterPrecision p = declared;
        p.transform = Arithmetic::float32;
        all.push_back(as_precise_as(input,
                                    {"vertices are transformed in float32",
                                     "Matrix, division and viewport run in float32 instead of float64.",
                                     "Look at the type of matrices and vertices on the way to the grid."},
                                    p));
    }
    for (int bits = declared.subpixel_bits - 1; bits >= 0; --bits) {
        RasterPrecision p = declared;
        p.subpixel_bits = bits;
        all.push_back(as_precise_as(
            input,
            {"only " + bits_text(bits),
             "Vertices lie beside their places as on a grid of 2^-" + std::to_string(bits) +
                 " px, declared " + std::to_string(declared.subpixel_bits) + " bits.",
             "Look at the fixed-point scale of the rasterizer's vertices, and at whatever rounds "
             "them before."},
            p));
    }
    for (Hypothesis& h : all) h.moves_triangles = true;
    std::ranges::stable_sort(all, {}, [&](const Hypothesis& h) { return eps_base_px(input, h.precision); });
    return all;
}

/// A depth buffer that a rasterizer may have without saying so.
struct UndeclaredBuffer {
    const char* name;
    DepthBuffer buffer;
    DepthFormat format;
};
constexpr std::array undeclared_buffers{
    UndeclaredBuffer{"reversed z, float32", DepthBuffer::reversed_z, DepthFormat::float32},
    UndeclaredBuffer{"reversed z, 24 bits", DepthBuffer::reversed_z, DepthFormat::unorm24},
    UndeclaredBuffer{"standard z, float32", DepthBuffer::standard_z, DepthFormat::float32},
    UndeclaredBuffer{"standard z, 24 bits", DepthBuffer::standard_z, DepthFormat::unorm24},
    UndeclaredBuffer{"standard z, 16 bits", DepthBuffer::standard_z, DepthFormat::unorm16},
};

std::vector<Hypothesis> of_depth_buffers(const DiagnosisInput& input, const RasterPrecision& declared) {
    std::vector<Hypothesis> all;
    for (const UndeclaredBuffer& one : undeclared_buffers) {
        RasterPrecision p = declared;
        p.depth_buffer = one.buffer;
        p.depth_format = one.format;
        p.clip_range = ClipRange::minus_one_to_one;
        p.matrix_far = MatrixFar::finite;
        p.depth_interpolation = DepthInterpolation::plane;
        p.shown_depth = ShownDepth::buffer;
        all.push_back(as_precise_as(
            input,
            {std::string("undeclared depth buffer: ") + one.name,
             std::string("Depth went through a buffer that was not declared: ") + one.name + ".",
             "Look at the depth buffer's format: declare it (docs/bounds.md), or interpolate depth apart."},
            p));
    }
    return all;
}

/// Depth in whole steps of a fixed-point buffer. What the buffer holds is affine in inverse depth, so a step
/// is one everywhere there.
struct FixedPoint {
    View view;
    double step;  ///< of inverse depth

    FixedPoint(const View& v, int bits) : view(v) {
        const Camera& c = view.camera;
        const bool perspective = c.projection == Projection::perspective;
        const double range = perspective ? 1 / c.near_depth - 1 / c.far_depth : c.far_depth - c.near_depth;
        step = range / (std::ldexp(1.0, bits) - 1);
    }

    /// The depth moves by up to a step, since some round and others cut; then float32 rounds it twice.
    ReportedDepth operator()(const DepthBound& bound, const Claim&) const {
        const double r = gamma(4, unit_roundoff_float32);
        if (view.camera.projection == Projection::parallel)
            return {bound.low - step - r * std::abs(bound.low), bound.high + step + r * std::abs(bound.high)};
        const double farthest = bound.high * step < 1 ? bound.high / (1 - bound.high * step)
                                                      : std::numeric_limits<double>::infinity();
        return {bound.low / (1 + bound.low * step) * (1 - r), farthest * (1 + r)};
    }
};

/// Hypotheses about so few bits that the depths that a buffer can tell lie apart: any other is no such
/// buffer's.
constexpr int few_bits = 16;

/// A depth as a number of steps of a buffer, and what float32's roundings of the depth may change of it.
struct Steps {
    double count, error;
};

/// A level is a number of whole steps, of any of the buffers whose steps `steps_of(depth)` counts.
template <class StepsOf>
void tells_levels_only(Hypothesis& h, StepsOf steps_of) {
    h.tellable = [steps_of](const ReportedDepth& range) {
        const auto count = [&](double depth) { return steps_of(depth).front().count; };
        return std::max(1.0, std::round(std::abs(count(range.high) - count(range.low))));
    };
    h.restate = [steps_of](const Claim& claim) -> std::optional<Claim> {
        if (claim.answer.primitive == PrimitiveId::none) return claim;
        const auto is_level = [](const Steps& s) {
            return std::abs(s.count - std::round(s.count)) <= s.error;
        };
        if (std::ranges::none_of(steps_of(double(claim.answer.camera_depth)), is_level)) return std::nullopt;
        return claim;
    };
}

/// float32 roundings of a depth, as a share.
const double depth_rounding = gamma(4, unit_roundoff_float32);

void tells_equal_steps_only(Hypothesis& h, const DiagnosisInput& input, double step) {
    tells_levels_only(h, [near = input.view.camera.near_depth, step](double depth) {
        return std::array{
            Steps{(depth - near) / step, depth_rounding * (std::abs(near) + std::abs(depth)) / step}};
    });
}

constexpr const char* stored_format =
    "Look at the depth buffer's format, and at the format of the file that it is read from.";

Hypothesis stored_in(const DiagnosisInput& input, int bits) {
    const FixedPoint format(input.view, bits);
    Hypothesis h = as_declared(
        input, {"depth has " + std::to_string(bits) + " bits, fixed point",
                "Depth went through a buffer of " + std::to_string(bits) + " bits between near and far.",
                stored_format});
    h.report = format;
    h.amend = [step = format.step](Neighbourhood& around, PrimitiveId) {
        for (Neighbour& n : around.neighbours)
            n.least_inverse_depth -= step, n.greatest_inverse_depth += step;
    };
    const Camera c = input.view.camera;
    h.only_permits = bits > few_bits;
    if (h.only_permits) return h;
    if (c.projection == Projection::parallel) {
        tells_equal_steps_only(h, input, format.step);
        return h;
    }
    // z between near and far; near / depth; and 1 / depth
    const double step = format.step, at_near = 1 / c.near_depth, most = std::ldexp(1.0, bits);
    tells_levels_only(h, [=](double depth) {
        const auto inverse = [&](double scale) {
            return Steps{scale / depth, depth_rounding * std::abs(scale / depth)};
        };
        return std::array{Steps{(at_near - 1 / depth) / step, depth_rounding * (at_near + 1 / depth) / step},
                          inverse(c.near_depth * (most - 1)), inverse(c.near_depth * most), inverse(most)};
    });
    return h;
}

/// Depth itself in whole steps between near and far, as a grey value has it.
Hypothesis stored_linearly(const DiagnosisInput& input, int bits) {
    const Camera& c = input.view.camera;
    Hypothesis h = as_declared(input, {"depth has " + std::to_string(bits) + " bits, in equal steps",
                                       "Depth was stored in equal steps between near and far, " +
                                           std::to_string(bits) + " bits of them.",
                                       stored_format});
    const double step = (c.far_depth - c.near_depth) / (std::ldexp(1.0, bits) - 1);
    h.report = [step](const DepthBound& bound, const Claim&) {
        const double r = gamma(4, unit_roundoff_float32);
        return ReportedDepth{bound.low - step - r * std::abs(bound.low),
                             bound.high + step + r * std::abs(bound.high)};
    };
    tells_equal_steps_only(h, input, step);
    return h;
}

/// Steps in which depths may be kept, the largest first: whole units, parts of them, and the file's own.
std::vector<double> likely_steps(const DiagnosisInput& input) {
    std::vector<double> steps{1,
                              0.1,
                              0.01,
                              0.001,
                              0.0001,
                              1.0 / 256,
                              input.convention.depth_scale,
                              input.convention.depth_scale / 4};
    if (const double far = input.view.camera.far_depth; std::isfinite(far))
        steps.insert(steps.end(), {far / 255, far / 65535});
    std::ranges::sort(steps, std::greater());
    return steps;
}

/// Depths are told in steps, from `below` under the true depth to `above` it.
Hypothesis told_in_steps(const DiagnosisInput& input, double step, double below, double above, Cause cause) {
    Hypothesis h = as_declared(input, std::move(cause));
    const double promised =
        std::visit([](const auto& p) { return p.depth_step; }, input.candidate.precision) / 2;
    h.report = [=](const DepthBound& bound, const Claim&) {
        const double rounding = depth_rounding * std::max(std::abs(bound.low), std::abs(bound.high));
        return ReportedDepth{bound.low + promised - below - rounding,
                             bound.high - promised + above + rounding};
    };
    tells_levels_only(h, [step](double depth) {
        return std::array{Steps{depth / step, depth_rounding * std::abs(depth) / step}};
    });
    return h;
}

Hypothesis rounded_to_steps(const DiagnosisInput& input, double step) {
    return told_in_steps(input, step, step / 2, step / 2,
                         {"depth is in whole steps of " + with_digits(step, 4),
                          "Depth was rounded to a whole number of steps of " + with_digits(step, 4) + ".",
                          "Look at the file's integers: half a step is part of the promise "
                          "(--convention depth_coding=integer, or depth_step of --precision)."});
}

Hypothesis cut_to_steps(const DiagnosisInput& input, double step) {
    return told_in_steps(
        input, step, step, 0,
        {"depth is cut to whole steps of " + with_digits(step, 4),
         "The whole number of steps below the depth was stored, not the nearest.",
         "Look at the conversion to integers: add one half before what follows the point is cut."});
}

Hypothesis raised_to_steps(const DiagnosisInput& input, double step) {
    return told_in_steps(
        input, step, 0, step,
        {"depth is raised to whole steps of " + with_digits(step, 4),
         "The whole number of steps above the depth was stored, not the nearest.",
         "Look at the conversion to integers: it rounds up, where the nearest is promised."});
}

/// Depth in whole steps of scene units. The largest that holds at most of the depths is taken.
std::vector<Hypothesis> stored_in_steps(const DiagnosisInput& input) {
    const auto depths = input.candidate.frame.camera_depth.pixels();
    for (const double step : likely_steps(input)) {
        std::size_t finite = 0, whole = 0;
        for (const float told : depths) {
            if (!std::isfinite(told)) continue;
            const double count = double(told) / step;
            ++finite;
            whole += std::abs(count - std::round(count)) <= depth_rounding * std::abs(count);
        }
        if (finite == 0 || 2 * whole < finite) continue;
        if (depth_rounding * double(*std::ranges::max_element(
                                 depths, {}, [](float d) { return std::isfinite(d) ? d : 0.0f; })) >
            step / 4)
            continue;  // every float is near a step
        return {rounded_to_steps(input, step), cut_to_steps(input, step), raised_to_steps(input, step)};
    }
    return {};
}

/// Depth as a float of fewer significant bits, rounded either way. It tells no depth of more bits.
Hypothesis stored_as_float(const DiagnosisInput& input, int bits) {
    Hypothesis h =
        as_declared(input, {"depth is a float of " + std::to_string(bits) + " bits",
                            "Depth was rounded to " + std::to_string(bits) + " significant bits.",
                            "Look for half floats or reduced precision where depth is kept or exported."});
    const double r = std::ldexp(1.0, 1 - bits);
    h.report = [r](const DepthBound& bound, const Claim&) {
        return ReportedDepth{bound.low - r * std::abs(bound.low), bound.high + r * std::abs(bound.high)};
    };
    // the depth, or its reciprocal
    tells_levels_only(h, [bits](double depth) {
        const auto significand = [&](double number) {
            const bool has_steps = number != 0 && std::isfinite(number);
            return has_steps ? std::ldexp(number, bits - 1 - std::ilogb(number)) : 0.0;
        };
        const double inverse = significand(1 / depth);
        return std::array{Steps{significand(depth), 0}, Steps{inverse, depth_rounding * std::abs(inverse)}};
    });
    return h;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_precision(const DiagnosisInput& input) {
    std::vector<Hypothesis> all{
        stored_in(input, 32),       stored_in(input, 24),       stored_in(input, 16),     stored_in(input, 8),
        stored_as_float(input, 16), stored_as_float(input, 11), stored_as_float(input, 8)};
    if (std::isfinite(input.view.camera.far_depth))
        for (const int bits : {16, 8}) all.push_back(stored_linearly(input, bits));
    for (Hypothesis& h : stored_in_steps(input)) all.push_back(std::move(h));
    const auto* declared = std::get_if<RasterPrecision>(&input.candidate.precision);
    if (!declared) return all;
    if (declared->snap == Snap::nearest) {
        all.push_back(truncating(input, *declared, -1, "up and left"));
        all.push_back(truncating(input, *declared, 1, "down and right"));
    }
    for (Hypothesis& h : of_depth_buffers(input, *declared)) all.push_back(std::move(h));
    for (Hypothesis& h : of_coordinates(input, *declared)) all.push_back(std::move(h));
    return all;
}

}  // namespace zproof
