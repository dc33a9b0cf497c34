#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/diagnosis/hypotheses/affine_depth.h"
#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/told_steps.h"
#include "frame/number_text.h"
#include "math/rounding.h"
#include "math/srgb.h"
#include "scenes/camera_depth.h"

namespace zproof {

namespace {

/// float32 roundings from depth to what is reported: a quotient, a product, a sum, and the store.
const double conversion = gamma(4, unit_roundoff_float32);

/// a + b / depth: how projections store depth. Monotonic over positive depths.
struct Reciprocal {
    double a, b;

    ReportedDepth operator()(const DepthBound& bound, const Claim&) const {
        const double one = a + b / bound.low, other = a + b / bound.high;
        const double rounding = conversion * (std::abs(a) + std::abs(b) / std::min(bound.low, bound.high));
        return {std::min(one, other) - rounding, std::max(one, other) + rounding};
    }
};

/// a + b depth.
struct Linear {
    double a, b;

    ReportedDepth operator()(const DepthBound& bound, const Claim&) const {
        const double one = a + b * bound.low, other = a + b * bound.high;
        const double rounding =
            conversion * (std::abs(a) + std::abs(b) * std::max(std::abs(bound.low), std::abs(bound.high)));
        return {std::min(one, other) - rounding, std::max(one, other) + rounding};
    }
};

/// Depths as the frame stores them, by what they are turned back to where they are declared to be of a kind.
class TurnedBack {
  public:
    explicit TurnedBack(const DiagnosisInput& input) : camera_depth_(input.convention, input.view) {}

    ReportedDepth operator()(const ReportedDepth& stored, const Claim& claim) const {
        if (camera_depth_.is_identity()) return stored;
        const double one = camera_depth_(stored.low, claim.x, claim.y),
                     other = camera_depth_(stored.high, claim.x, claim.y);
        const double rounding = conversion * std::max(std::abs(one), std::abs(other));
        return {std::min(one, other) - rounding, std::max(one, other) + rounding};
    }

  private:
    CameraDepth camera_depth_;
};

/// Depths are stored as `report` says.
template <class Report>
Hypothesis exactly_reported_as(const DiagnosisInput& input, const Cause& cause, Report report) {
    Hypothesis h = as_declared(input, cause);
    h.report = [report, turned_back = TurnedBack(input)](const DepthBound& bound, const Claim& claim) {
        return turned_back(report(bound, claim), claim);
    };
    h.restate = [](Claim claim) -> std::optional<Claim> {
        if (claim.answer.primitive == PrimitiveId::none) claim.answer.camera_depth = background_depth;
        return claim;
    };
    return h;
}

/// Or were rounded or cut after that.
template <class Report>
Hypothesis reported_as(const DiagnosisInput& input, const Cause& cause, Report report) {
    Hypothesis h = exactly_reported_as(input, cause, report);
    allow_steps(h, told_step(input));
    return h;
}

/// NDC z that is `at_near` on the near plane and `at_far` on the far one.
Hypothesis ndc(const DiagnosisInput& input, double at_near, double at_far, const std::string& convention) {
    const Camera& c = input.view.camera;
    const Cause cause{"depth is NDC z (" + convention + ")",
                      "Depth is what the projection matrix makes of it, after division by w.",
                      "Look at the read-back of the depth buffer: z is not turned back to depth."};
    if (c.projection == Projection::parallel) {
        const double slope = (at_far - at_near) / (c.far_depth - c.near_depth);
        return reported_as(input, cause, Linear{at_near - slope * c.near_depth, slope});
    }
    const double b = (at_near - at_far) * c.near_depth / (1 - c.near_depth / c.far_depth);
    return reported_as(input, cause, Reciprocal{at_far - b / c.far_depth, b});
}

constexpr const char* other_projections_formula =
    "Look at how z is turned back: by the formula of the other kind of projection.";

/// z in [0, 1] that one projection wrote and the other reads. It is rounded as a number of size 1.
Hypothesis parallel_as_perspective(const DiagnosisInput& input) {
    const double near = input.view.camera.near_depth, far = input.view.camera.far_depth;
    return reported_as(input,
                       {"depth is of a parallel view, read as a perspective's",
                        "z of the depth buffer is linear in depth, and turned back as if it were not.",
                        other_projections_formula},
                       [=](const DepthBound& bound, const Claim&) {
                           const auto read = [&](double depth, double rounding) {
                               const double z = (depth - near) / (far - near) + rounding;
                               return near * far / (far - z * (far - near));
                           };
                           const double low = read(bound.low, -conversion),
                                        high = read(bound.high, conversion);
                           return ReportedDepth{
                               low - conversion * std::abs(low),
                               high > 0 ? high * (1 + conversion) : std::numeric_limits<double>::infinity()};
                       });
}

/// A perspective's depth is turned back as a parallel projection's.
Hypothesis perspective_as_parallel(const DiagnosisInput& input) {
    const Camera& c = input.view.camera;
    const double per_inverse = (c.far_depth - c.near_depth) / (1 / c.near_depth - 1 / c.far_depth);
    return reported_as(input,
                       {"depth is of a perspective, read as a parallel view's",
                        "z of the depth buffer is linear in 1/depth, and turned back as if in depth.",
                        other_projections_formula},
                       Reciprocal{c.near_depth + per_inverse / c.near_depth, -per_inverse});
}

/// scale / (a + b / depth): z turned back by another formula than it was made by. It is rounded as a number
/// of size 1, which is `z_range` in inverse depth.
struct MisreadZ {
    double a, b, z_range, scale = 1;

    ReportedDepth operator()(const DepthBound& bound, const Claim&) const {
        const auto [low, high] = std::minmax({a + b / bound.low, a + b / bound.high});
        const double room = conversion * (std::abs(a) + std::abs(b / bound.low) + z_range);
        return {scale / (high + room),
                low > room ? scale / (low - room) : std::numeric_limits<double>::infinity()};
    }
};

/// z of a perspective, read by the formula for z of another range.
std::vector<Hypothesis> misread_z(const DiagnosisInput& input) {
    const Camera& c = input.view.camera;
    const double near = 1 / c.near_depth, far = 1 / c.far_depth, range = near - far;
    const char* formula = "Look at how z is turned back: NDC z is 2 z - 1 of z in the depth buffer.";
    const auto read = [&](const std::string& name, const std::string& description, const MisreadZ& z) {
        return reported_as(input, {name, description, formula}, z);
    };
    return {read("z from 0 to 1 is turned back as if it were NDC z", "2 z - 1 is left out.",
                 MisreadZ{far / 2, 0.5, range}),
            read("z from 0 to 1 is turned back as if it were NDC z", "2 z - 1 is left out, and far divides.",
                 MisreadZ{far / 2, 0.5, range, far}),
            read("NDC z is turned back as if it were from 0 to 1", "(z + 1) / 2 is left out.",
                 MisreadZ{-far, 2, range}),
            read("z is turned back from its other end", "Near and far are exchanged, or z is 1 - z.",
                 MisreadZ{near + far, -1, range})};
}

/// Length of the view ray per unit of depth, at the pixel's centre.
double ray_length_per_depth(const View& view, int x, int y) {
    const Vector3<double> d = ViewRay<double>(view, x, y).direction;
    return std::sqrt(dot(d, d));
}

Hypothesis ray_length(const DiagnosisInput& input) {
    const auto report = [view = input.view](const DepthBound& bound, const Claim& claim) {
        return Linear{0, ray_length_per_depth(view, claim.x, claim.y)}(bound, claim);
    };
    return reported_as(
        input,
        {"depth is the ray's length",
         "Depth is the distance from the eye along the ray, not along the view axis.",
         "Look at where the hit's distance is stored: multiply it by the ray's component ahead."},
        report);
}

/// The ray's length is counted from where it meets the near plane.
Hypothesis ray_length_from_near(const DiagnosisInput& input) {
    const auto report = [view = input.view](const DepthBound& bound, const Claim& claim) {
        const double length = ray_length_per_depth(view, claim.x, claim.y);
        return Linear{-length * view.camera.near_depth, length}(bound, claim);
    };
    return reported_as(
        input,
        {"depth is the ray's length from the near plane",
         "Depth is the distance along the ray from where it passes the near plane.",
         "Look at where rays start: on the near plane; add near and divide by the ray's length per depth."},
        report);
}

/// The ray's length has lost the near depth.
Hypothesis ray_length_less_near(const DiagnosisInput& input) {
    const auto report = [view = input.view](const DepthBound& bound, const Claim& claim) {
        return Linear{-view.camera.near_depth, ray_length_per_depth(view, claim.x, claim.y)}(bound, claim);
    };
    return reported_as(
        input,
        {"depth is the ray's length less near",
         "Depth is the distance from the eye along the ray, less the near plane's depth.",
         "Look at where near is subtracted, and at the hit's distance that is taken for depth."},
        report);
}

/// A coordinate of the point in the world, such as its height.
Hypothesis coordinate(const DiagnosisInput& input, int axis, const std::string& name) {
    const auto report = [view = input.view, axis](const DepthBound& bound, const Claim& claim) {
        const ViewRay<double> ray(view, claim.x, claim.y);
        const auto along = [axis](const Vector3<double>& v) {
            return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
        };
        return Linear{along(ray.origin), along(ray.direction)}(bound, claim);
    };
    Hypothesis h =
        reported_as(input,
                    {"depth is the point's " + name + " in the world",
                     "What is told for depth is a coordinate of the place that the pixel shows.",
                     "Look at which pass or channel is exported: a position or a height map is no depth."},
                    report);
    // a sum's steps are those of its terms, also where it is nearly 0
    const double step = 2 * unit_roundoff_float32 * std::abs(double(input.view.camera.eye_world[axis]));
    h.tellable = [step](const ReportedDepth& range) {
        const double floats = floats_within(range);
        return step > 0 ? std::min(floats, (range.high - range.low) / step + 1) : floats;
    };
    return h;
}

/// A monotonic curve over depth, with what its own roundings may change of what it gives.
struct Curve {
    std::function<double(double depth)> at;
    double rounding;  ///< as a share

    ReportedDepth operator()(const DepthBound& bound, const Claim&) const {
        const double one = at(bound.low), other = at(bound.high);
        const double room = rounding * std::max(std::abs(one), std::abs(other));
        return {std::min(one, other) - room, std::max(one, other) + room};
    }
};

/// Depths end at the largest that the frame tells, as a sensor's do.
std::vector<Hypothesis> cut_off(const DiagnosisInput& input) {
    double largest = 0;
    for (const float depth : input.candidate.frame.camera_depth.pixels())
        if (std::isfinite(depth)) largest = std::max(largest, double(depth));
    const auto beyond = [&](const std::string& as, double told) {
        Hypothesis h = exactly_reported_as(
            input,
            {"depths beyond a limit are told as " + as,
             "Depths above " + with_digits(largest, 6) + " are told as " + as + ".",
             "Look at the range of the sensor, or of the format that depths are kept in."},
            [=](const DepthBound& bound, const Claim&) {
                return bound.low > largest
                           ? ReportedDepth{told, told}
                           : ReportedDepth{std::min(bound.low, largest), std::min(bound.high, largest)};
            });
        h.learned_bits = bits_of_a_number;
        h.tells_numbers = true;
        return h;
    };
    return {beyond("the limit", largest), beyond("0", 0)};
}

/// What pictures do to their values.
std::vector<Hypothesis> as_pictures(const DiagnosisInput& input) {
    const double near = input.view.camera.near_depth, far = input.view.camera.far_depth;
    const char* picture =
        "Look at the depth's export: colour management, tone curves and clamps are for colours.";
    const auto curve = [&](const std::string& name, const std::string& description,
                           std::function<double(double)> at) {
        // powers and logarithms of the C library are off by less than 1 ulp; arguments by a few roundings
        return reported_as(input, {name, description, picture}, Curve{std::move(at), 8 * conversion});
    };
    std::vector<Hypothesis> all{
        curve("depth went through a curve of gamma 2.2", "Depth is told to the power of 1 / 2.2.",
              [](double depth) { return std::pow(std::max(0.0, depth), 1 / 2.2); }),
        curve("depth went through a curve of gamma 1/2.2", "Depth is told to the power of 2.2.",
              [](double depth) { return std::pow(std::max(0.0, depth), 2.2); }),
        curve("depth is clamped at 1", "Depths above 1 are told as 1.",
              [](double depth) { return std::min(1.0, depth); })};
    for (Hypothesis& h : cut_off(input)) all.push_back(std::move(h));
    if (near <= 0) return all;
    all.push_back(curve("depth is a logarithm", "The natural logarithm of depth is told.",
                        [](double depth) { return std::log(depth); }));
    if (!std::isfinite(far)) return all;
    const auto add_curves = [&](const std::string& what, const std::string& of_what, double from) {
        const auto share = [=](double depth) { return std::clamp((depth - from) / (far - from), 0.0, 1.0); };
        all.push_back(curve(what + " went through a curve of gamma 2.2", "The 1/2.2th power " + of_what,
                            [=](double depth) { return std::pow(share(depth), 1 / 2.2); }));
        all.push_back(curve(what + " went through a curve of gamma 1/2.2", "The 2.2th power " + of_what,
                            [=](double depth) { return std::pow(share(depth), 2.2); }));
        all.push_back(curve(what + " went through the curve of sRGB", "The sRGB code " + of_what,
                            [=](double depth) { return encoded_srgb(share(depth)); }));
    };
    add_curves("depth from near to far", "of the share of the way from near to far is told.", near);
    add_curves("depth by far", "of depth / far is told.", 0);
    all.push_back(curve("depth is a logarithm, counted from 1", "log(1 + depth) is told.",
                        [](double depth) { return std::log1p(depth); }));
    all.push_back(curve("depth is a logarithm, counted from 1", "log(1 + depth) / log(1 + far) is told.",
                        [=](double depth) { return std::log1p(depth) / std::log1p(far); }));
    all.push_back(curve("depth from near to far is a logarithm",
                        "log(depth / near) / log(far / near) is told.",
                        [=](double depth) { return std::log(depth / near) / std::log(far / near); }));
    return all;
}

std::string factor_text(double factor) {
    return factor > 1 ? std::to_string(int(factor)) : "1/" + std::to_string(int(std::round(1 / factor)));
}

/// Depths lie elsewhere than the ids that they belong to; at the outline, where there is none to be had, they
/// stay.
Hypothesis apart_from_ids(const DiagnosisInput& input, int dx, int dy, const std::string& where) {
    Hypothesis h = as_declared(input, {"depths lie one pixel " + where + " of their ids",
                                       "The depth of a pixel belongs to its neighbour's id.",
                                       "Look at the offsets at which the depth plane is read or written."});
    h.reads_surroundings = true;
    h.restate = [dx, dy, &frame = input.candidate.frame](Claim claim) -> std::optional<Claim> {
        const Claim moved{claim.x - dx, claim.y - dy, claim.answer};
        if (!holds(frame.size(), moved)) return std::nullopt;
        const PrimitiveId id = frame.primitive.at(moved.x, moved.y);
        const bool outline = id == PrimitiveId::none && claim.answer.camera_depth != background_depth;
        return outline ? claim : Claim{moved.x, moved.y, {id, claim.answer.camera_depth}};
    };
    return h;
}

/// One of the two planes has its rows from the wrong end.
Hypothesis flipped_apart(const DiagnosisInput& input, bool are_depths_flipped) {
    Hypothesis h = as_declared(
        input,
        {are_depths_flipped ? "depths are flipped in y, ids are not" : "ids are flipped in y, depths are not",
         "One plane's row y holds what belongs to row H - 1 - y.",
         "Look at the read-back of both planes: glReadPixels begins at the lowest row."});
    h.restate = [are_depths_flipped,
                 &frame = input.candidate.frame](const Claim& claim) -> std::optional<Claim> {
        const int y = frame.size().height - 1 - claim.y;
        const Answer there{frame.primitive.at(claim.x, y), frame.camera_depth.at(claim.x, y)};
        return are_depths_flipped ? Claim{claim.x, y, {there.primitive, claim.answer.camera_depth}}
                                  : Claim{claim.x, y, {claim.answer.primitive, there.camera_depth}};
    };
    return h;
}

std::vector<Hypothesis> depths_beside_ids(const DiagnosisInput& input) {
    if (input.said && input.said->labels.are_absent) return {};  // of depth alone: the image's own shift
    std::vector<Hypothesis> all{apart_from_ids(input, 1, 0, "right"), apart_from_ids(input, -1, 0, "left"),
                                apart_from_ids(input, 0, 1, "below"), apart_from_ids(input, 0, -1, "above")};
    if (!input.said) all.insert(all.end(), {flipped_apart(input, true), flipped_apart(input, false)});
    return all;
}

/// The mean of the corners' depths, all over a triangle.
Hypothesis flat(const DiagnosisInput& input) {
    return reported_as(
        input,
        {"a triangle has one depth: the mean of its corners'", "Depth is not interpolated over the triangle.",
         "Look at where depth is interpolated: it is the centroid's, as for sorting."},
        [&scene = input.scene, c = input.view.camera](const DepthBound&, const Claim& claim) {
            if (std::size_t(claim.answer.primitive) >= scene.triangles.size()) return ReportedDepth{1, 0};
            double depth = 0, size = 0;
            for (const glm::vec3& p : corners_of(scene, std::uint32_t(claim.answer.primitive))) {
                const glm::dvec3 from_eye = glm::dvec3(p) - glm::dvec3(c.eye_world);
                depth -= dot(c.back, from_eye) / 3;
                size += dot(abs(c.back), abs(glm::dvec3(p)) + abs(glm::dvec3(c.eye_world))) / 3;
            }
            return ReportedDepth{depth - 2 * conversion * size, depth + 2 * conversion * size};
        });
}

/// Depth test and reported depth both go by depth that is interpolated linearly over the raster image.
Hypothesis affine(const DiagnosisInput& input) {
    Hypothesis h = as_declared(input, {"depth is affine instead of perspective-correct",
                                       "Depth itself is interpolated linearly over the image, not 1/depth.",
                                       "Look at depth's interpolation: interpolate 1/depth over the image, "
                                       "or divide by w for each pixel."});
    h.report = [&scene = input.scene, view = input.view,
                bounds = ViewBounds(input.view, input.candidate.precision)](const DepthBound&,
                                                                            const Claim& claim) {
        const CornersWorld p_world = corners_of(scene, std::uint32_t(claim.answer.primitive));
        const Neighbour n = neighbour_of(ViewRay<double>(view, claim.x, claim.y), bounds, p_world);
        return affine_depth(view, claim.x, claim.y, n);
    };
    h.amend = [](Neighbourhood& around, PrimitiveId) {
        for (Neighbour& n : around.neighbours) {
            const ReportedDepth depth = affine_depth(around.view, around.x, around.y, n);
            n.least_inverse_depth = -depth.high;
            n.greatest_inverse_depth = -depth.low;
            n.gradient = 0;
        }
    };
    return h;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_depth(const DiagnosisInput& input) {
    const Camera& c = input.view.camera;
    std::vector<Hypothesis> all{ray_length(input),
                                ndc(input, -1, 1, "-1 to 1"),
                                ndc(input, 0, 1, "0 to 1"),
                                ndc(input, 1, 0, "1 to 0, reversed"),
                                reported_as(input,
                                            {"depth is counted from the near plane", "Depth is depth - near.",
                                             "Look at where depth is stored: near was subtracted."},
                                            Linear{-c.near_depth, 1}),
                                ray_length_from_near(input),
                                ray_length_less_near(input)};
    if (!CameraDepth(input.convention, input.view).is_identity())
        all.push_back(reported_as(input,
                                  {"depth is along the view axis already",
                                   "Depth is camera depth, and is turned back as if it were of another kind.",
                                   "Look at depth_kind and depth_scale of the convention."},
                                  Linear{0, 1}));
    for (Hypothesis& h : as_pictures(input)) all.push_back(std::move(h));
    for (const auto& [axis, name] : {std::pair{0, "x"}, {1, "y"}, {2, "z"}})
        all.push_back(coordinate(input, axis, name));
    for (const double unit : {1000.0, 100.0, 10.0})
        for (const double factor : {unit, 1 / unit})
            all.push_back(reported_as(
                input,
                {"depth is in other units", "Depth is " + factor_text(factor) + " times the depth.",
                 "Look at the units of the scene's import and of the depth's export."},
                Linear{0, factor}));
    for (Hypothesis& h : depths_beside_ids(input)) all.push_back(std::move(h));
    if (c.projection == Projection::parallel) {
        if (c.near_depth > 0) all.push_back(parallel_as_perspective(input));
        return all;
    }
    all.push_back(reported_as(input,
                              {"depth is 1/depth", "Depth is what is linear over the image, its reciprocal.",
                               "Look at where depth is stored: what is interpolated was not inverted."},
                              Reciprocal{0, 1}));
    if (std::isfinite(c.far_depth)) {
        const double per_depth = 1 / (c.far_depth - c.near_depth);
        all.push_back(reported_as(
            input,
            {"depth is scaled to 0 at near and 1 at far", "Depth is (depth - near) / (far - near).",
             "Look at the depth's export: a normalization between near and far was left in."},
            Linear{-c.near_depth * per_depth, per_depth}));
    }
    if (std::isfinite(c.far_depth)) {
        all.push_back(perspective_as_parallel(input));
        for (Hypothesis& h : misread_z(input)) all.push_back(std::move(h));
    }
    all.push_back(affine(input));
    all.push_back(flat(input));
    return all;
}

}  // namespace zproof
