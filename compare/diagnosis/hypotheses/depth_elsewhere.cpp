#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "compare/bounds/triangle_depth.h"
#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/plane_depth.h"
#include "compare/diagnosis/hypotheses/told_steps.h"
#include "frame/number_text.h"
#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();
/// float32 roundings of a told_rounding: a quotient, a product, a sum, and the store.
const double told_rounding = gamma(4, unit_roundoff_float32);

/// The bounds of the depths that the candidate's ids may have at their pixels; the reference's ids, where the
/// candidate names no triangles.
class OwnDepths {
  public:
    explicit OwnDepths(const DiagnosisInput& input)
        : scene_(input.scene),
          view_(input.view),
          frame_(input.said ? input.reference.frame : input.candidate.frame),
          bounds_(ViewBounds::of_shown(input.view, input.candidate.precision)) {}

    /// Nothing where the id is none or no triangle's.
    std::optional<DepthBound> at(int x, int y) const {
        const PrimitiveId id = frame_.primitive.at(x, y);
        if (std::size_t(id) >= scene_.triangles.size()) return std::nullopt;
        const CornersWorld p_world = corners_of(scene_, std::uint32_t(id));
        return TriangleDepth(TriangleInView(view_, bounds_, p_world), bounds_).at(x, y);
    }
    const Frame& frame() const { return frame_; }

  private:
    const Scene& scene_;
    View view_;
    const Frame& frame_;
    ViewBounds bounds_;
};

/// The mean over the pixel and its neighbours; background is left out.
Hypothesis averaged(const DiagnosisInput& input) {
    Hypothesis h = as_declared(
        input,
        {"depth is averaged over 3 x 3 pixels",
         "Depth is the mean over the pixel and its neighbours, background left out.",
         "Look at multisample resolve, filters and resizing: depth must be one sample's, unfiltered."});
    h.report = [own = OwnDepths(input)](const DepthBound&, const Claim& claim) {
        double low = 0, high = 0, count = 0;
        for (int y = claim.y - 1; y <= claim.y + 1; ++y)
            for (int x = claim.x - 1; x <= claim.x + 1; ++x) {
                if (!holds(own.frame().size(), {x, y, {}})) continue;
                const std::optional<DepthBound> bound = own.at(x, y);
                if (!bound) continue;
                low += bound->low;
                high += bound->high;
                ++count;
            }
        // nine sums, a quotient and the store
        const double rounding = gamma(11, unit_roundoff_float32) * std::max(std::abs(low), std::abs(high));
        return ReportedDepth{(low - rounding) / count, (high + rounding) / count};
    };
    return h;
}

/// All 2 x 2 pixels have the depth of the first, whichever triangle they show.
Hypothesis first_of_quad(const DiagnosisInput& input) {
    Hypothesis h = as_declared(
        input, {"depth is that of the first of 2 x 2 pixels",
                "A block of 2 x 2 pixels has its own ids, and the first pixel's depth.",
                "Look at where depth is interpolated: for each pixel, not once for a block of lanes."});
    h.report = [own = OwnDepths(input)](const DepthBound&, const Claim& claim) {
        const std::optional<DepthBound> first = own.at(claim.x & ~1, claim.y & ~1);
        return first ? ReportedDepth{first->low, first->high} : ReportedDepth{no_limit, no_limit};
    };
    return h;
}

std::string half_steps_text(const glm::dvec2& offset_px) {
    const auto text = [](double px) { return px == 0 ? "0" : px > 0 ? "+1/2" : "-1/2"; };
    return std::string("(") + text(offset_px.x) + ", " + text(offset_px.y) + ") px";
}

/// The id is the centre's, the depth that of the same triangle's plane beside it.
Hypothesis beside_centre(const DiagnosisInput& input, const glm::dvec2& offset_px) {
    Hypothesis h = as_declared(
        input,
        {"depth is taken " + half_steps_text(offset_px) + " beside the centre",
         "The id belongs to the pixel's centre, the depth to another place of the triangle's plane.",
         "Look at where depth is interpolated: at the same place of the pixel as coverage is decided."});
    h.report = [offset_px, &scene = input.scene, view = input.view,
                bounds = ViewBounds::of_shown(input.view, input.candidate.precision)](const DepthBound&,
                                                                                      const Claim& claim) {
        const CornersWorld p_world = corners_of(scene, std::uint32_t(claim.answer.primitive));
        const Neighbour n = neighbour_of(ViewRay<double>(view, claim.x, claim.y), bounds, p_world);
        return plane_depth(n, view.camera.projection, offset_px);
    };
    return h;
}

/// What is told for a depth by a renderer with one number wrong, and which number a told depth speaks for.
struct OneNumber {
    std::function<double(double number, double depth)> told;
    std::function<double(double told, double depth)> number;
    std::function<double(double number, double depth)> rounding;  ///< of what is told
};

struct NumberRange {
    double low, high;
};

/// A number that the most ranges hold.
double most_held(const std::vector<NumberRange>& ranges) {
    std::vector<std::pair<double, int>> ends;
    for (const NumberRange& r : ranges) {
        ends.emplace_back(r.low, 0);
        ends.emplace_back(r.high, 1);
    }
    std::ranges::sort(ends);
    int held = 0, most = 0;
    double best = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        held += ends[i].second == 0 ? 1 : -1;
        if (held <= most || ends[i].second != 0) continue;
        most = held;
        best = (ends[i].first + ends[i + 1].first) / 2;
    }
    return best;
}

constexpr std::size_t most_fitted = 1'000;

/// A pixel's depth, and what is told there.
struct ToldDepth {
    DepthBound bound;
    double told;
};

/// Those of pixels whose ids are not in question.
std::vector<ToldDepth> told_depths(const DiagnosisInput& input) {
    const OwnDepths own(input);
    const Frame &ours = input.candidate.frame, &theirs = input.reference.frame;
    const std::size_t count = ours.primitive.pixels().size(), width = std::size_t(ours.size().width);
    std::vector<ToldDepth> all;
    for (std::size_t i = 0; i < count; i += count / most_fitted + 1) {
        const int x = int(i % width), y = int(i / width);
        if (ours.primitive.at(x, y) != theirs.primitive.at(x, y)) continue;
        const std::optional<DepthBound> bound = own.at(x, y);
        const double told = double(ours.camera_depth.at(x, y));
        if (bound && std::isfinite(told) && std::isfinite(bound->low + bound->high))
            all.push_back({*bound, told});
    }
    return all;
}

/// The number that explains the most of the told depths.
std::optional<double> fitted_number(const DiagnosisInput& input, const OneNumber& form) {
    std::vector<NumberRange> ranges;
    const double step = told_step(input);
    for (const auto& [bound, told] : told_depths(input)) {
        const double room = form.rounding(form.number(told, bound.truth), bound.truth) + step;
        NumberRange range{no_limit, -no_limit};
        for (const double depth : {bound.low, bound.high})
            for (const double one : {told - room, told + room}) {
                range.low = std::min(range.low, form.number(one, depth));
                range.high = std::max(range.high, form.number(one, depth));
            }
        if (std::isfinite(range.low) && std::isfinite(range.high)) ranges.push_back(range);
    }
    if (ranges.size() < 2) return std::nullopt;
    return most_held(ranges);
}

/// The cause's description ends where the number stands.
std::vector<Hypothesis> fitted(const DiagnosisInput& input, Cause cause, const OneNumber& form,
                               const std::function<double(double)>& shown = nullptr) {
    const std::optional<double> number = fitted_number(input, form);
    if (!number || !std::isfinite(*number)) return {};
    cause.description += with_digits(shown ? shown(*number) : *number, 6) + ".";
    Hypothesis h = as_declared(input, cause);
    h.learned_bits = bits_of_a_number;
    h.fits_a_limit = true;
    h.report = [form, number = *number](const DepthBound& bound, const Claim&) {
        const double one = form.told(number, bound.low), other = form.told(number, bound.high);
        const double room = std::max(form.rounding(number, bound.low), form.rounding(number, bound.high));
        return ReportedDepth{std::min(one, other) - room, std::max(one, other) + room};
    };
    allow_steps(h, told_step(input));
    return {h};
}

std::vector<Hypothesis> scaled_or_biased(const DiagnosisInput& input) {
    std::vector<Hypothesis> all =
        fitted(input,
               {"depth is scaled by a constant", "Depth is told times ",
                "Look at the camera node's scale, which the view matrix must not keep, and at units."},
               {.told = [](double k, double depth) { return k * depth; },
                .number = [](double told, double depth) { return told / depth; },
                .rounding = [](double k, double depth) { return told_rounding * std::abs(k * depth); }});
    for (Hypothesis& h :
         fitted(input,
                {"depth is biased by a constant", "To depth is added ",
                 "Look at polygon offset and depth bias, and at offsets of the ray's start."},
                {.told = [](double k, double depth) { return depth + k; },
                .number = [](double told, double depth) { return told - depth; },
                .rounding = [](double k,
                               double depth) { return told_rounding * (std::abs(k) + std::abs(depth)); }}))
        all.push_back(std::move(h));
    return all;
}

/// Pixels of a stereo pair instead of a depth.
std::vector<Hypothesis> disparity(const DiagnosisInput& input) {
    if (input.view.camera.projection == Projection::parallel) return {};
    return fitted(input,
                  {"depth is a disparity", "What is told for depth is, divided by depth, ",
                   "Look at the stereo matcher's output: depth is focal length times baseline by disparity."},
                  {.told = [](double k, double depth) { return k / depth; },
                   .number = [](double told, double depth) { return told * depth; },
                   .rounding = [](double k, double depth) { return told_rounding * std::abs(k / depth); }});
}

/// z was written with the declared planes, and read with another. z is rounded as a number of size 1, which
/// is 1 / near in inverse depth.
std::vector<Hypothesis> read_with_other_planes(const DiagnosisInput& input) {
    const Camera& c = input.view.camera;
    if (c.projection == Projection::parallel || !std::isfinite(c.far_depth)) return {};
    const double near = 1 / c.near_depth, far = 1 / c.far_depth;
    const auto form_about = [=](double kept) {
        const auto told = [=](double k, double depth) { return 1 / (kept + k * (1 / depth - kept)); };
        return OneNumber{.told = told,
                         .number = [=](double told_depth,
                                       double depth) { return (1 / told_depth - kept) / (1 / depth - kept); },
                         .rounding =
                             [=](double k, double depth) {
                                 const double at = told(k, depth);
                                 return told_rounding * (std::abs(at) + near * at * at * std::max(1.0, k));
                             }};
    };
    const char* planes =
        "Look at near and far where z is turned back: they must be those of the projection matrix.";
    std::vector<Hypothesis> all =
        fitted(input,
               {"depth is read with another far plane",
                "z of the depth buffer is turned back with a far plane of ", planes},
               form_about(near), [=](double k) { return 1 / (near - k * (near - far)); });
    for (Hypothesis& h : fitted(input,
                                {"depth is read with another near plane",
                                 "z of the depth buffer is turned back with a near plane of ", planes},
                                form_about(far), [=](double k) { return 1 / (far + k * (near - far)); }))
        all.push_back(std::move(h));
    return all;
}

/// Two of the pixels whose ids are not in question: one of those that tell least and one of those that tell
/// most, the most certain ones. Nothing where they tell the same.
std::optional<std::array<ToldDepth, 2>> far_apart(const DiagnosisInput& input) {
    std::vector<ToldDepth> all = told_depths(input);
    const std::size_t some = all.size() / 20;
    if (some == 0) return std::nullopt;
    std::ranges::sort(all, {}, &ToldDepth::told);
    const auto most_certain = [](std::span<const ToldDepth> of) {
        return *std::ranges::min_element(of, {}, [](const ToldDepth& t) {
            return (t.bound.high - t.bound.low) / std::abs(t.bound.truth);
        });
    };
    const ToldDepth least = most_certain(std::span(all).first(some)),
                    most = most_certain(std::span(all).last(some));
    if (least.told == most.told || least.bound.truth == most.bound.truth) return std::nullopt;
    return std::array{least, most};
}

/// What is told, or its reciprocal, is affine in depth, or in its reciprocal.
struct TwoNumbers {
    bool inverts_told, inverts_depth;
    std::array<ToldDepth, 2> known;
    double z_range;  ///< z is rounded as a number of size 1: what that is in inverse depth

    static double in(bool inverts, double number) { return inverts ? 1 / number : number; }
    double form(double told) const { return in(inverts_told, told); }
    double place(double depth) const { return in(inverts_depth, depth); }
    double slope() const {
        return (form(known[1].told) - form(known[0].told)) /
               (place(known[1].bound.truth) - place(known[0].bound.truth));
    }
    double told(double depth) const {
        return form(form(known[0].told) + slope() * (place(depth) - place(known[0].bound.truth)));
    }
    /// How far the form of what is told may be off, as the known depths may be and by roundings.
    double room(double depth) const {
        const double from = place(known[0].bound.truth), to = place(known[1].bound.truth),
                     share = (place(depth) - from) / (to - from);
        const auto width = [&](const ToldDepth& t) {
            return std::abs(place(t.bound.high) - place(t.bound.low));
        };
        const double of_places = width(known[0]) * std::abs(1 - share) + width(known[1]) * std::abs(share) +
                                 (inverts_depth ? told_rounding * z_range : 0);
        return std::abs(slope()) * of_places +
               told_rounding * (std::abs(form(known[0].told)) + std::abs(form(known[1].told)) +
                                std::abs(form(told(depth))));
    }
    ReportedDepth operator()(const DepthBound& bound, const Claim&) const {
        ReportedDepth range{no_limit, -no_limit};
        for (const double depth : {bound.low, bound.high}) {
            const double middle = form(told(depth)), off = room(depth);
            if (inverts_told && middle <= off) return {-no_limit, no_limit};
            for (const double one : {form(middle - off), form(middle + off)})
                range = {std::min(range.low, one), std::max(range.high, one)};
        }
        return range;
    }
};

/// Depths that are normalized, pictures that are inverted, z of planes that are both wrong.
std::vector<Hypothesis> of_two_numbers(const DiagnosisInput& input) {
    const auto known = far_apart(input);
    if (!known) return {};
    const Camera& c = input.view.camera;
    const double z_range = c.near_depth > 0 ? 1 / c.near_depth : 0;
    const auto text = [](double number) { return with_digits(number, 6); };
    const auto with = [&](const Cause& cause, const TwoNumbers& numbers) {
        Hypothesis h = as_declared(input, cause);
        h.learned_bits = 2 * bits_of_a_number;
        h.fits_a_limit = h.tells_numbers = true;
        h.report = numbers;
        allow_steps(h, told_step(input));
        return h;
    };
    const TwoNumbers linear{false, false, *known, 0}, buffer{false, true, *known, z_range},
        planes{true, true, *known, z_range};
    std::vector<Hypothesis> all{
        with({"depth is scaled and biased",
              "Depth is told times " + text(linear.slope()) + ", and " + text(linear.told(0)) + " is added.",
              "Look at the depth's export: it is normalized, or inverted for a picture."},
             linear)};
    if (c.projection == Projection::parallel) return all;
    all.push_back(with({"depth is z of another buffer",
                        "What is told is 1/depth times " + text(buffer.slope()) + ", and " +
                            text(buffer.told(no_limit)) + " is added.",
                        "Look at the read-back of the depth buffer, and at its normalization."},
                       buffer));
    all.push_back(
        with({"depth is read with other planes",
              "z of the depth buffer is turned back with a near plane of " + text(planes.told(c.near_depth)) +
                  " and a far plane of " + text(planes.told(c.far_depth)) + ".",
              "Look at near and far where z is turned back: they must be those of the projection matrix."},
             planes));
    return all;
}

/// The planes between which the candidate shows anything.
std::vector<Hypothesis> clipped_elsewhere(const DiagnosisInput& input) {
    const bool is_perspective = input.view.camera.projection == Projection::perspective;
    double nearest = no_limit, farthest = -no_limit;
    for (const float depth : input.candidate.frame.camera_depth.pixels()) {
        if (!std::isfinite(depth) || (depth <= 0 && is_perspective)) continue;
        nearest = std::min(nearest, double(depth));
        farthest = std::max(farthest, double(depth));
    }
    const Camera& c = input.view.camera;
    if (is_perspective) nearest = std::max(nearest, c.near_depth * 0x1p-20);  // or it cuts nothing
    if (!(nearest < farthest)) return {};
    const auto clipped_at_depths = [&](const Cause& cause, double near_depth, double far_depth) {
        Hypothesis h = as_declared(input, cause);
        h.learned_bits = bits_of_a_number;
        h.fits_a_limit = true;
        h.view.camera.near_depth = near_depth;
        h.view.camera.far_depth = far_depth;
        return h;
    };
    return {clipped_at_depths(
                {farthest < c.far_depth ? "the far plane lies nearer" : "the far plane lies farther",
                 "Nothing is drawn beyond the farthest depth of the frame, " + with_digits(farthest, 6) + ".",
                 "Look at far: the projection matrix's, the ray's end, scene units."},
                c.near_depth, farthest),
            clipped_at_depths(
                {nearest > c.near_depth ? "the near plane lies farther" : "the near plane lies nearer",
                 "Nothing is drawn before the nearest depth of the frame, " + with_digits(nearest, 6) + ".",
                 "Look at near: the projection matrix's, the ray's start, scene units."},
                nearest, c.far_depth)};
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_depth_elsewhere(const DiagnosisInput& input) {
    std::vector<Hypothesis> all{averaged(input), first_of_quad(input)};
    for (const int dy : {0, -1, 1})
        for (const int dx : {0, -1, 1})
            if (dx != 0 || dy != 0) all.push_back(beside_centre(input, 0.5 * glm::dvec2(dx, dy)));
    for (const auto& more : {scaled_or_biased(input), disparity(input), read_with_other_planes(input),
                             of_two_numbers(input), clipped_elsewhere(input)})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace zproof
