#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "frame/number_text.h"
#include "math/rounding.h"

namespace zproof {

namespace {

/// What becomes of a triangle. Undecided: it lies on the limit, within its bounds.
enum class Outcome { drawn, undecided, dropped };

/// A number below its limit, off by at most `error`.
Outcome dropped_below(double number, double limit, double error) {
    if (number + error < limit) return Outcome::dropped;
    return number - error < limit ? Outcome::undecided : Outcome::drawn;
}

template <class OutcomeOf>
Hypothesis dropped(const DiagnosisInput& input, const Cause& cause, OutcomeOf outcome_of) {
    Hypothesis h = as_declared(input, cause);
    h.amend = [outcome_of](Neighbourhood& around, PrimitiveId) {
        std::erase_if(around.neighbours, [&](Neighbour& n) {
            const Outcome outcome = outcome_of(around, n);
            n.may_be_missing |= outcome == Outcome::undecided;
            return outcome == Outcome::dropped;
        });
    };
    return h;
}

/// A corner as the camera has it, off by at most `error` in each coordinate.
struct CameraCorner {
    double right, up, depth, error;
};

CameraCorner in_camera(const Camera& c, const glm::vec3& p_world) {
    const glm::dvec3 v = glm::dvec3(p_world) - glm::dvec3(c.eye_world);
    const double size = std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
    return {dot(c.right, v), dot(c.up, v), -dot(c.back, v), gamma(8, unit_roundoff_float64) * size};
}

Hypothesis across_near(const DiagnosisInput& input) {
    return dropped(
        input,
        {"triangles across the near plane are dropped",
         "A triangle with a corner nearer than the near plane is left out instead of clipped.",
         "Look at clipping: a triangle with a corner before the near plane must be cut, not rejected."},
        [](const Neighbourhood& around, const Neighbour& n) {
            Outcome outcome = Outcome::drawn;
            for (const glm::vec3& p : n.p_world) {
                const CameraCorner corner = in_camera(around.view.camera, p);
                outcome = std::max(outcome, dropped_below(corner.depth, around.view.camera.near_depth,
                                                          corner.error + n.near_slack));
            }
            return outcome;
        });
}

Hypothesis across_far(const DiagnosisInput& input) {
    return dropped(input,
                   {"triangles across the far plane are dropped",
                    "A triangle with a corner beyond the far plane is left out instead of clipped.",
                    "Look at clipping: reject a triangle only if all its corners lie beyond the far plane."},
                   [](const Neighbourhood& around, const Neighbour& n) {
                       Outcome outcome = Outcome::drawn;
                       for (const glm::vec3& p : n.p_world) {
                           const CameraCorner corner = in_camera(around.view.camera, p);
                           outcome =
                               std::max(outcome, dropped_below(-corner.depth, -around.view.camera.far_depth,
                                                               corner.error + n.far_slack));
                       }
                       return outcome;
                   });
}

Hypothesis behind_eye(const DiagnosisInput& input) {
    return dropped(
        input,
        {"triangles with a corner behind the eye are dropped",
         "A triangle with a corner at a depth of 0 or less is left out instead of clipped.",
         "Look at clipping: a triangle with a corner of w <= 0 must be cut before the division by w."},
        [](const Neighbourhood& around, const Neighbour& n) {
            Outcome outcome = Outcome::drawn;
            for (const glm::vec3& p : n.p_world) {
                const CameraCorner corner = in_camera(around.view.camera, p);
                outcome = std::max(outcome, dropped_below(corner.depth, 0, corner.error + n.near_slack));
            }
            return outcome;
        });
}

/// A box of raster space, px.
struct RasterBox {
    double left, top, right, bottom;
};

/// What becomes of a triangle that no corner may leave the box. Decided in units of the window, times depth
/// in a perspective: clip coordinates, in which a corner behind the eye lies outside.
Outcome outcome_at(const RasterBox& box, const Neighbourhood& around, const Neighbour& n) {
    const Camera& c = around.view.camera;
    const Window& w = c.window;
    const bool perspective = c.projection == Projection::perspective;
    const double u_per_px = (w.right - w.left) / around.view.width,
                 v_per_px = (w.top - w.bottom) / around.view.height;
    Outcome outcome = Outcome::drawn;
    for (const glm::vec3& p : n.p_world) {
        const CameraCorner corner = in_camera(c, p);
        const double scale = perspective ? corner.depth : 1;
        const double x = perspective ? corner.right : corner.right - corner.depth * c.shear.x;
        const double y = perspective ? corner.up : corner.up - corner.depth * c.shear.y;
        const auto keep_below = [&](double number, double side, double per_px) {
            const double error =
                4 * corner.error * (1 + std::abs(side)) + n.bounds.eps_px * per_px * std::abs(scale);
            outcome = std::max(outcome, dropped_below(side * scale - number, 0, error));
        };
        keep_below(-x, -(w.left + box.left * u_per_px), u_per_px);
        keep_below(x, w.left + box.right * u_per_px, u_per_px);
        keep_below(y, w.top - box.top * v_per_px, v_per_px);
        keep_below(-y, -(w.top - box.bottom * v_per_px), v_per_px);
    }
    return outcome;
}

Outcome outcome_at_sides(const Neighbourhood& around, const Neighbour& n) {
    return outcome_at({0, 0, double(around.view.width), double(around.view.height)}, around, n);
}

/// Beyond 16 bits of whole pixels with a sign, which many rasterizers cannot hold.
Outcome outcome_at_guard_band(const Neighbourhood& around, const Neighbour& n) {
    constexpr double most_px = 32'768;
    return outcome_at({-most_px, -most_px, most_px, most_px}, around, n);
}

/// Two-fold area of the image, px^2, and how far displacement may change it. Without end where a corner is
/// not before the eye.
struct DoubleArea {
    double px2, error;
};

DoubleArea double_area(const View& view, const CornersWorld& p_world, double eps_px) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const Camera& c = view.camera;
    const Window& w = c.window;
    const bool perspective = c.projection == Projection::perspective;
    std::array<glm::dvec2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        const CameraCorner corner = in_camera(c, p_world[i]);
        if (perspective && corner.depth <= corner.error) return {endless, 0};
        const double u = perspective ? corner.right / corner.depth : corner.right - corner.depth * c.shear.x;
        const double v = perspective ? corner.up / corner.depth : corner.up - corner.depth * c.shear.y;
        p[i] = {u * view.width / (w.right - w.left), v * view.height / (w.top - w.bottom)};
    }
    const glm::dvec2 a = p[1] - p[0], b = p[2] - p[0];
    const double size = std::abs(a.x) + std::abs(a.y) + std::abs(b.x) + std::abs(b.y);
    // each coordinate of a and b moves by up to 2 eps
    return {std::abs(a.x * b.y - a.y * b.x), 2 * eps_px * size + 8 * eps_px * eps_px};
}

Hypothesis below_area(const DiagnosisInput& input, double least_px2, const Cause& cause) {
    return dropped(input, cause, [=](const Neighbourhood& around, const Neighbour& n) {
        const DoubleArea area = double_area(around.view, n.p_world, n.bounds.eps_px);
        return dropped_below(area.px2, 2 * least_px2, area.error);
    });
}

/// |edge x edge . ray| as a ray test has it, the ray's component ahead being 1; and its rounding in float32.
struct Determinant {
    double size, error;
};

Determinant determinant_of(const ViewRay<double>& ray, const CornersWorld& p_world) {
    const Corners<double> p = corners<double>(p_world);
    const Vector3<double> e1 = p[1] - p[0], e2 = p[2] - p[0];
    const auto sum = [](const Vector3<double>& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    return {std::abs(dot(cross(e1, e2), ray.direction)),
            gamma(8, unit_roundoff_float32) * sum(e1) * sum(e2) * sum(ray.direction)};
}

Hypothesis below_determinant(const DiagnosisInput& input, double least, const std::string& name,
                             const std::string& description) {
    const char* epsilon =
        "Look at the ray test's epsilon: it scales with the triangle's area; reject 0 alone.";
    return dropped(input, {name, description, epsilon}, [=](const Neighbourhood& around, const Neighbour& n) {
        const Determinant d = determinant_of(ViewRay<double>(around.view, around.x, around.y), n.p_world);
        return dropped_below(d.size, least, d.error);
    });
}

/// A number of which something was drawn or is missing.
struct Observed {
    double number;
    bool is_drawn;
};

/// A limit below which nothing was drawn: between the smallest number drawn and the largest missing one below
/// it. Nothing where none is missing there.
std::optional<double> fitted_limit(const std::vector<Observed>& observed) {
    double smallest_drawn = std::numeric_limits<double>::infinity(), largest_missing = -1;
    for (const Observed& o : observed)
        if (o.is_drawn) smallest_drawn = std::min(smallest_drawn, o.number);
    for (const Observed& o : observed)
        if (!o.is_drawn && o.number < smallest_drawn) largest_missing = std::max(largest_missing, o.number);
    if (largest_missing < 0 || !std::isfinite(smallest_drawn)) return std::nullopt;
    return (smallest_drawn + largest_missing) / 2;
}

/// Is it drawn anywhere? Asked of the triangles that the reference sees or the candidate shows.
std::unordered_map<std::uint32_t, bool> drawn_anywhere(const DiagnosisInput& input) {
    std::unordered_map<std::uint32_t, bool> drawn;
    for (const PrimitiveId id : input.reference.frame.primitive.pixels())
        if (id != PrimitiveId::none) drawn.emplace(std::uint32_t(id), false);
    for (const PrimitiveId id : input.candidate.frame.primitive.pixels())
        if (std::size_t(id) < input.scene.triangles.size()) drawn[std::uint32_t(id)] = true;
    return drawn;
}

std::vector<Hypothesis> fitted_to_area(const DiagnosisInput& input) {
    std::vector<Observed> observed;
    for (const auto& [triangle, is_drawn] : drawn_anywhere(input))
        observed.push_back({double_area(input.view, corners_of(input.scene, triangle), 0).px2 / 2, is_drawn});
    const std::optional<double> limit = fitted_limit(observed);
    if (!limit || !std::isfinite(*limit)) return {};
    Hypothesis h = below_area(
        input, *limit,
        {"small triangles are dropped",
         "Triangles whose image is smaller than " + with_digits(*limit, 3) +
             " px^2 are not drawn: a limit fitted to what is missing.",
         "Look at the test that rejects small triangles, and at bounding boxes that round to nothing."});
    h.learned_bits = bits_of_a_number;
    h.fits_a_limit = true;
    return {h};
}

/// Pixels, evenly spread, at which the determinant of the triangle to be seen is looked at.
constexpr std::size_t most_observed = 20'000;

std::vector<Hypothesis> fitted_to_determinant(const DiagnosisInput& input) {
    const Frame &ours = input.candidate.frame, &theirs = input.reference.frame;
    const std::size_t count = theirs.primitive.pixels().size(), stride = count / most_observed + 1;
    const ViewRays<double> rays(input.view);
    std::vector<Observed> observed;
    for (std::size_t i = 0; i < count; i += stride) {
        const int x = int(i % std::size_t(theirs.size().width)),
                  y = int(i / std::size_t(theirs.size().width));
        const PrimitiveId seen = theirs.primitive.at(x, y);
        if (seen == PrimitiveId::none) continue;
        const CornersWorld p_world = corners_of(input.scene, std::uint32_t(seen));
        observed.push_back({determinant_of(rays.at(x, y), p_world).size, ours.primitive.at(x, y) == seen});
    }
    const std::optional<double> limit = fitted_limit(observed);
    if (!limit) return {};
    Hypothesis h = below_determinant(input, *limit, "triangles with a small determinant are dropped",
                                     "Rays miss triangles whose determinant is below " +
                                         with_digits(*limit, 3) + ": a limit fitted to what is missing.");
    h.learned_bits = bits_of_a_number;
    h.fits_a_limit = true;
    return {h};
}

/// Nothing is drawn behind the last triangle that the candidate shows.
std::vector<Hypothesis> beyond_a_count(const DiagnosisInput& input) {
    std::uint32_t last_drawn = 0, last_seen = 0;
    for (const auto& [triangle, is_drawn] : drawn_anywhere(input)) {
        last_seen = std::max(last_seen, triangle);
        if (is_drawn) last_drawn = std::max(last_drawn, triangle);
    }
    if (last_drawn >= last_seen) return {};
    Hypothesis h =
        dropped(input,
                {"triangles beyond a count are not drawn",
                 "None is drawn behind triangle " + std::to_string(last_drawn) + ", the last that is shown.",
                 "Look at buffers of a fixed size, at the number of indices drawn, and at 16-bit counters."},
                [last_drawn](const Neighbourhood&, const Neighbour& n) {
                    return n.triangle > last_drawn ? Outcome::dropped : Outcome::drawn;
                });
    h.learned_bits = bits_of_a_number;
    h.fits_a_limit = true;
    return {h};
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_dropped_triangles(const DiagnosisInput& input) {
    const char* small_test = "Look at the test that rejects small triangles: only an area of 0 may go.";
    std::vector<Hypothesis> all{
        across_near(input),
        behind_eye(input),
        across_far(input),
        dropped(
            input,
            {"triangles across the guard band are dropped",
             "A triangle with a corner beyond +-32768 px is left out.",
             "Look at clipping: what leaves the range of the fixed-point grid must be cut, not rejected."},
            outcome_at_guard_band),
        dropped(input,
                {"triangles across a side of the picture are dropped",
                 "A triangle with a corner outside the picture is left out.",
                 "Look at frustum culling: reject only if all corners lie beyond one side; clip or clamp the "
                 "rest."},
                outcome_at_sides),
        below_area(input, 0.5,
                   {"triangles of less than 1/2 px^2 are dropped",
                    "Triangles whose two-fold area is below 1 px^2 are not drawn.", small_test}),
        below_area(input, 1,
                   {"triangles of less than 1 px^2 are dropped",
                    "Triangles whose area is below 1 px^2 are not drawn.", small_test})};
    for (const auto& [least, text] : {std::pair{1e-3, "1e-3"},
                                      {1e-4, "1e-4"},
                                      {1e-5, "1e-5"},
                                      {1e-6, "1e-6"},
                                      {1e-7, "1e-7"},
                                      {1e-8, "1e-8"}})
        all.push_back(below_determinant(
            input, least, std::string("triangles of a determinant below ") + text + " are dropped",
            "Rays miss triangles whose determinant is below that limit."));
    for (const auto& more : {beyond_a_count(input), fitted_to_area(input), fitted_to_determinant(input)})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace zproof
