#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <span>

#include "compare/bounds/triangle_depth.h"
#include "compare/bounds/triangle_extent.h"
#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/moved_part.h"
#include "compare/diagnosis/hypotheses/radial_distortion.h"
#include "frame/number_text.h"

namespace zproof {

namespace {

constexpr std::size_t most_numbers = 6, most_samples = 2'048, most_asked_if_wrong = 1 << 17;
constexpr int most_steps = 24;
using Numbers = std::array<double, most_numbers>;

/// A camera of the declared kind. Its eye is not yet rounded to float32.
struct FittedCamera {
    View view;
    glm::dvec3 eye_world;
    RadialDistortion lens{};  ///< of a perspective

    /// Where a depth lies that is told at a pixel.
    glm::dvec3 point_at(int x, int y, double depth) const {
        const Camera& c = view.camera;
        const glm::dvec2 at = sampled_at(view, x, y);
        const double u = c.window.left + (c.window.right - c.window.left) * at.x / view.width;
        const double v = c.window.top - (c.window.top - c.window.bottom) * at.y / view.height;
        const bool is_perspective = c.projection == Projection::perspective;
        const glm::dvec2 aside =
            is_perspective ? depth * lens.ray_of({u, v}) : glm::dvec2(u, v) + depth * c.shear;
        return eye_world + aside.x * c.right + aside.y * c.up - depth * c.back;
    }
};

/// The pixel at which a point is seen, by the camera alone; nothing where that is none.
std::optional<PixelCoord> pixel_of(const View& view, const glm::dvec3& p_world) {
    const Camera& c = view.camera;
    const glm::dvec3 from_eye = p_world - glm::dvec3(c.eye_world);
    const double depth = -dot(c.back, from_eye);
    glm::dvec2 at(dot(c.right, from_eye), dot(c.up, from_eye));
    at = c.projection == Projection::perspective ? at / depth : at - depth * c.shear;
    const double x = (at.x - c.window.left) / (c.window.right - c.window.left) * view.width;
    const double y = (c.window.top - at.y) / (c.window.top - c.window.bottom) * view.height;
    const bool is_inside = depth > 0 && x >= 0 && y >= 0 && x < view.width && y < view.height;
    return is_inside ? std::optional(PixelCoord{int(x), int(y)}) : std::nullopt;
}

/// What may be wrong of a camera, in numbers that are 0 where nothing is.
struct CameraModel {
    std::size_t count;
    FittedCamera (*camera)(const View& declared, const Numbers& numbers, double scene_depth);
    Cause (*cause)(const View& declared, const Numbers& numbers, double scene_depth);
};

View scaled(const View& view, double wider, double higher) {
    View other = view;
    Window& w = other.camera.window;
    const double u = (w.left + w.right) / 2, v = (w.bottom + w.top) / 2;
    w = {u + (w.left - u) * (1 + wider), u + (w.right - u) * (1 + wider), v + (w.bottom - v) * (1 + higher),
         v + (w.top - v) * (1 + higher)};
    return other;
}

FittedCamera in_place(const View& view) { return {view, glm::dvec3(view.camera.eye_world)}; }

FittedCamera posed(const View& declared, const glm::dvec3& step, const glm::dvec3& turn) {
    FittedCamera camera = in_place(declared);
    Camera& c = camera.view.camera;
    camera.eye_world += step.x * c.right + step.y * c.up + step.z * c.back;
    const double angle = length(turn);
    if (angle == 0) return camera;
    const glm::dvec3 axis = (turn.x * c.right + turn.y * c.up + turn.z * c.back) / angle;
    const glm::dquat rotation = glm::angleAxis(angle, axis);
    c.right = rotation * c.right;
    c.up = rotation * c.up;
    c.back = rotation * c.back;
    return camera;
}

std::string times(double more) { return with_digits(1 + more, 5); }
/// What a fit leaves of 0 is told as 0.
std::string fitted_text(double value) { return with_digits(std::round(value * 1e4) / 1e4, 4); }
std::string px_pair(double x, double y) { return "(" + fitted_text(x) + ", " + fitted_text(y) + ") px"; }

constexpr const char* focal_length =
    "Look at the focal length and the field of view: half an angle, tan of half the angle, degrees or "
    "radians, the other axis, another picture size.";
constexpr const char* principal_point =
    "Look at the principal point: cx and cy are from the picture's corner, and a centre is (x + 1/2, y + "
    "1/2).";

Cause scaled_cause(const std::string& axes, const std::string& how) {
    return {"the window is scaled" + axes, "The window is " + how + ".", focal_length};
}

Cause shifted_cause(const Numbers& n) {
    const bool is_fraction = std::hypot(n[0], n[1]) <= 1;
    return {
        is_fraction ? "the image is shifted by a fraction of a pixel" : "the principal point lies elsewhere",
        "Each pixel holds what belongs " + px_pair(n[0], n[1]) + " from its centre (x right, y down).",
        principal_point};
}

/// r is measured in units of depth, as a camera's calibration does, or in half sides of the picture.
enum class RadiusUnit { depth, half_sides };

template <Distorted distorted, RadiusUnit unit>
constexpr CameraModel lens_model{
    1,
    [](const View& v, const Numbers& n, double) {
        FittedCamera camera = in_place(v);
        const Window& w = v.camera.window;
        camera.lens = {n[0], distorted};
        if (unit == RadiusUnit::half_sides)
            camera.lens.unit = {(w.right - w.left) / 2, (w.top - w.bottom) / 2};
        return camera;
    },
    [](const View&, const Numbers& n, double) {
        const std::string k1 = "times 1 + k1 r^2: k1 is " + with_digits(n[0], 5);
        return Cause{"the image is distorted radially",
                     (distorted == Distorted::pixel ? "A ray meets the image at its pixel's place "
                                                    : "A pixel lies at the place of its ray ") +
                         k1 +
                         (unit == RadiusUnit::depth ? ", at depth 1." : ", in half sides of the picture."),
                     "Look at the camera model: a lens's distortion is left in, or undone where there is "
                     "none."};
    }};

/// Fits of the window alone; what takes fewer numbers first.
constexpr std::array window_models{
    CameraModel{1, [](const View& v, const Numbers& n, double) { return in_place(scaled(v, n[0], n[0])); },
                [](const View&, const Numbers& n, double) {
                    return scaled_cause("", times(n[0]) + " times as wide and high");
                }},
    CameraModel{1, [](const View& v, const Numbers& n, double) { return in_place(scaled(v, n[0], 0)); },
                [](const View&, const Numbers& n, double) {
                    return scaled_cause(" in x", times(n[0]) + " times as wide");
                }},
    CameraModel{1, [](const View& v, const Numbers& n, double) { return in_place(scaled(v, 0, n[0])); },
                [](const View&, const Numbers& n, double) {
                    return scaled_cause(" in y", times(n[0]) + " times as high");
                }},
    lens_model<Distorted::ray, RadiusUnit::depth>,
    lens_model<Distorted::pixel, RadiusUnit::depth>,
    lens_model<Distorted::ray, RadiusUnit::half_sides>,
    lens_model<Distorted::pixel, RadiusUnit::half_sides>,
    CameraModel{2,
                [](const View& v, const Numbers& n, double) {
                    return in_place(shifted_view(v, {-n[0], -n[1]}));
                },
                [](const View&, const Numbers& n, double) { return shifted_cause(n); }},
    CameraModel{2, [](const View& v, const Numbers& n, double) { return in_place(scaled(v, n[0], n[1])); },
                [](const View&, const Numbers& n, double) {
                    return scaled_cause(" in x and in y",
                                        times(n[0]) + " times as wide and " + times(n[1]) + " times as high");
                }},
    CameraModel{4,
                [](const View& v, const Numbers& n, double) {
                    return in_place(scaled(shifted_view(v, {-n[2], -n[3]}), n[0], n[1]));
                },
                [](const View&, const Numbers& n, double) {
                    return Cause{"the window is scaled and lies elsewhere",
                                 "The window is " + times(n[0]) + " times as wide and " + times(n[1]) +
                                     " times as high, and stands " + px_pair(n[2], n[3]) + " aside.",
                                 focal_length};
                }}};

constexpr const char* pose =
    "Look at the view matrix and where it comes from: another frame, the other eye, a rounded file.";

std::string moved_text(const Numbers& n, double unit) {
    return "It stands (" + fitted_text(n[0] * unit) + ", " + fitted_text(n[1] * unit) + ", " +
           fitted_text(n[2] * unit) + ") scene units right, up and back of its place";
}

std::string turned_text(double x, double y, double z) {
    constexpr double degrees = 57.29577951308232;
    return "turned by (" + fitted_text(x * degrees) + ", " + fitted_text(y * degrees) + ", " +
           fitted_text(z * degrees) + ") degrees about its axes";
}

/// Fits of the pose alone; what takes fewer numbers first.
constexpr std::array pose_models{
    CameraModel{3,
                [](const View& v, const Numbers& n, double unit) {
                    return posed(v, unit * glm::dvec3(n[0], n[1], n[2]), glm::dvec3(0));
                },
                [](const View&, const Numbers& n, double unit) {
                    return Cause{"the camera stands elsewhere", moved_text(n, unit) + ".", pose};
                }},
    CameraModel{
        3,
        [](const View& v, const Numbers& n, double) {
            return posed(v, glm::dvec3(0), {n[0], n[1], n[2]});
        },
        [](const View&, const Numbers& n, double) {
            return Cause{"the camera is turned", "It is " + turned_text(n[0], n[1], n[2]) + ".", pose};
        }},
    CameraModel{6,
                [](const View& v, const Numbers& n, double unit) {
                    return posed(v, unit * glm::dvec3(n[0], n[1], n[2]), {n[3], n[4], n[5]});
                },
                [](const View&, const Numbers& n, double unit) {
                    return Cause{"the camera stands elsewhere and is turned",
                                 moved_text(n, unit) + ", " + turned_text(n[3], n[4], n[5]) + ".", pose};
                }}};

struct FitSample {
    int x, y;
    double depth;
    PrimitiveId triangle;
    double bound = 0;  ///< of the depth's error, as a share of the depth
};

/// The plane that should hold a told depth: normal . p = offset, of such a length that the difference is in
/// units of the depth's bound. No plane: the normal is 0.
struct PlaneTerm {
    glm::dvec3 normal;
    double offset;
};

/// The value that a share of all does not exceed.
double quantile(std::vector<double> values, double share) {
    if (values.empty()) return std::numeric_limits<double>::infinity();
    const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// What errors, in units of their bounds, cost together: outliers little more than others (Cauchy's loss).
double mean_cost(std::span<const double> errors) {
    double sum = 0;
    for (const double e : errors) sum += std::log1p(e * e);
    return errors.empty() ? std::numeric_limits<double>::infinity() : sum / double(errors.size());
}

/// Solves the normal equations of that many unknowns by elimination; what nothing speaks of stays 0.
Numbers solved(std::array<Numbers, most_numbers> a, Numbers b, std::size_t count) {
    Numbers x{};
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, a[i][i]);
    for (std::size_t i = 0; i < count; ++i) a[i][i] += largest * 1e-14;
    for (std::size_t i = 0; i < count; ++i)  // positive definite: no pivot is needed
        for (std::size_t j = i + 1; j < count; ++j) {
            const double f = a[j][i] / a[i][i];
            for (std::size_t k = i; k < count; ++k) a[j][k] -= f * a[i][k];
            b[j] -= f * b[i];
        }
    for (std::size_t i = count; i-- > 0;) {
        double sum = b[i];
        for (std::size_t k = i + 1; k < count; ++k) sum -= a[i][k] * x[k];
        x[i] = sum / a[i][i];
    }
    return x;
}

/// Numbers of a camera fitted to what the candidate shows: the plane of the triangle that a pixel shows holds
/// the point that its depth names. Where the candidate names no triangle, the one that the reference sees in
/// the point's direction is taken, anew at every step (iterative closest points by projection; Blais and
/// Levine 1995, with distances to planes; Chen and Medioni 1992). Outliers weigh little, and less from step
/// to step (graduated non-convexity; Blake and Zisserman 1987).
class CameraFit {
  public:
    enum class Samples { of_all, of_what_is_wrong };

    CameraFit(const DiagnosisInput& input, Samples samples)
        : input_(input), bounds_(ViewBounds::of_shown(input.view, input.candidate.precision)) {
        const Frame& frame = input.candidate.frame;
        const std::size_t count = frame.primitive.pixels().size(), width = std::size_t(frame.size().width);
        std::vector<PixelCoord> places;
        for (std::size_t i = 0; i < count; i += count / most_asked_if_wrong + 1) {
            const PixelCoord place{int(i % width), int(i / width)};
            if (samples == Samples::of_all || is_wrong(place.x, place.y)) places.push_back(place);
        }
        std::vector<double> depths;
        for (std::size_t i = 0; i < places.size(); i += places.size() / most_samples + 1) {
            const auto [x, y] = places[i];
            const double depth = double(frame.camera_depth.at(x, y));
            const PrimitiveId triangle = frame.primitive.at(x, y);
            if (std::size_t(triangle) >= input.scene.triangles.size() || !std::isfinite(depth)) continue;
            samples_.push_back({x, y, depth, triangle, bound_of(depth, triangle, x, y)});
            depths.push_back(std::abs(depth));
        }
        if (!depths.empty()) scene_depth_ = quantile(depths, 0.5);
    }

    struct Fit {
        Numbers numbers{};
        double cost = std::numeric_limits<double>::infinity();
    };

    Fit of(const CameraModel& model) const {
        Fit fit;
        double scale = std::numeric_limits<double>::infinity();
        for (int step = 0; step < most_steps; ++step) {
            const std::vector<PlaneTerm> planes =
                planes_of(model.camera(input_.view, fit.numbers, scene_depth_));
            std::vector<double> errors = errors_of(model, fit.numbers, planes);
            if (errors.size() < 2 * model.count) return {};
            fit.cost = mean_cost(errors);
            std::vector<double> sizes = errors;
            for (double& size : sizes) size = std::abs(size);
            scale = std::max(1.0, std::min(scale / 2, 2 * quantile(sizes, 0.9)));
            step_towards_less(model, planes, errors, scale, fit.numbers);
        }
        return fit;
    }
    /// As declared.
    double cost() const {
        const CameraModel& any = window_models.front();
        return mean_cost(errors_of(any, {}, planes_of(in_place(input_.view))));
    }
    double scene_depth() const { return scene_depth_; }

  private:
    /// As far as the reference tells: an outline may be right as well.
    bool is_wrong(int x, int y) const {
        const Frame &ours = input_.candidate.frame, &theirs = input_.reference.frame;
        const PrimitiveId id = ours.primitive.at(x, y);
        if (id != theirs.primitive.at(x, y)) return true;
        if (std::size_t(id) >= input_.scene.triangles.size()) return false;
        const double depth = double(ours.camera_depth.at(x, y)), right = double(theirs.camera_depth.at(x, y));
        return std::abs(depth - right) > bound_of(right, id, x, y) * std::abs(right);
    }

    double bound_of(double depth, PrimitiveId triangle, int x, int y) const {
        const CornersWorld p_world = corners_of(input_.scene, std::uint32_t(triangle));
        const DepthBound bound =
            TriangleDepth(TriangleInView(input_.view, bounds_, p_world), bounds_).at(x, y);
        const double share = (bound.high - bound.low) / std::abs(depth);
        return std::isfinite(share) ? std::clamp(share, 1e-7, 1e-2) : 1e-2;
    }

    /// The planes that samples_ should lie on; of no length where there is none.
    std::vector<PlaneTerm> planes_of(const FittedCamera& camera) const {
        std::vector<PlaneTerm> planes;
        for (const FitSample& s : samples_) planes.push_back(plane_of(camera, s));
        return planes;
    }

    PlaneTerm plane_of(const FittedCamera& camera, const FitSample& s) const {
        constexpr PlaneTerm none{glm::dvec3(0), 0};
        const PrimitiveId triangle = input_.said ? triangle_seen_at(camera, s) : s.triangle;
        if (triangle == PrimitiveId::none) return none;
        const CornersWorld p = corners_of(input_.scene, std::uint32_t(triangle));
        const glm::dvec3 a(p[0]);
        glm::dvec3 normal = cross(glm::dvec3(p[1]) - a, glm::dvec3(p[2]) - a);
        const Camera& c = input_.view.camera;
        const double distance = c.projection == Projection::perspective
                                    ? dot(normal, glm::dvec3(c.eye_world) - a)
                                    : dot(normal, c.back) * scene_depth_;
        if (distance == 0) return none;
        normal /= distance * s.bound;
        return {normal, dot(normal, a)};
    }

    PrimitiveId triangle_seen_at(const FittedCamera& camera, const FitSample& s) const {
        const auto pixel = pixel_of(input_.view, camera.point_at(s.x, s.y, s.depth));
        if (!pixel) return PrimitiveId::none;
        const PrimitiveId seen = input_.reference.frame.primitive.at(pixel->x, pixel->y);
        return have_one_label(input_.said->labels, seen, s.triangle) ? seen : PrimitiveId::none;
    }

    std::vector<double> errors_of(const CameraModel& model, const Numbers& numbers,
                                  std::span<const PlaneTerm> planes) const {
        const FittedCamera camera = model.camera(input_.view, numbers, scene_depth_);
        std::vector<double> errors;
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const FitSample& s = samples_[i];
            if (planes[i].normal == glm::dvec3(0)) continue;
            errors.push_back(dot(planes[i].normal, camera.point_at(s.x, s.y, s.depth)) - planes[i].offset);
        }
        return errors;
    }

    void step_towards_less(const CameraModel& model, std::span<const PlaneTerm> planes,
                           std::span<const double> errors, double scale, Numbers& numbers) const {
        constexpr double h = 1e-5;
        std::array<std::vector<double>, most_numbers> slopes;
        for (std::size_t k = 0; k < model.count; ++k) {
            Numbers more = numbers, less = numbers;
            more[k] += h;
            less[k] -= h;
            slopes[k] = errors_of(model, more, planes);
            const std::vector<double> other = errors_of(model, less, planes);
            for (std::size_t i = 0; i < other.size(); ++i) slopes[k][i] = (slopes[k][i] - other[i]) / (2 * h);
        }
        std::array<Numbers, most_numbers> a{};
        Numbers b{};

        for (std::size_t i = 0; i < errors.size(); ++i) {
            const double weight = 1 / (1 + errors[i] * errors[i] / (scale * scale));
            for (std::size_t j = 0; j < model.count; ++j) {
                b[j] -= weight * slopes[j][i] * errors[i];
                for (std::size_t k = 0; k < model.count; ++k) a[j][k] += weight * slopes[j][i] * slopes[k][i];
            }
        }
        const Numbers step = solved(a, b, model.count);
        for (std::size_t k = 0; k < model.count; ++k)
            if (std::isfinite(step[k])) numbers[k] += step[k];
    }

    const DiagnosisInput& input_;
    ViewBounds bounds_;
    std::vector<FitSample> samples_;
    double scene_depth_ = 1;
};

/// A camera that was fitted, by the numbers of one of the models.
struct ProposedCamera {
    FittedCamera camera;
    Cause cause;
    double learned_bits;
};

/// The first of the models that costs little more than the best; nothing where none costs much less than the
/// declared camera. What is proposed here is decided by the judge.
std::optional<ProposedCamera> best_of(const DiagnosisInput& input, const CameraFit& fit,
                                      std::span<const CameraModel> models) {
    std::vector<CameraFit::Fit> fits;
    for (const CameraModel& model : models) fits.push_back(fit.of(model));
    const double least = std::ranges::min(fits, {}, &CameraFit::Fit::cost).cost, declared = fit.cost();
    if (!(least < declared / 2)) return {};
    const auto best =
        std::ranges::find_if(fits, [&](const CameraFit::Fit& f) { return f.cost <= least + declared / 100; });
    const CameraModel& model = models[std::size_t(best - fits.begin())];
    FittedCamera camera = model.camera(input.view, best->numbers, fit.scene_depth());
    camera.view.camera.eye_world = glm::vec3(camera.eye_world);
    return ProposedCamera{camera, model.cause(input.view, best->numbers, fit.scene_depth()),
                          double(model.count) * bits_of_a_number};
}

/// The whole frame is that camera's.
std::vector<Hypothesis> seen_by(const DiagnosisInput& input, const std::optional<ProposedCamera>& proposed) {
    if (!proposed) return {};
    const auto& [camera, cause, learned_bits] = *proposed;
    Hypothesis h = camera.lens.k1 != 0 ? shown_through(input, cause, camera.lens)
                                       : shown_instead(input, cause, declared_scene(input), camera.view);
    h.learned_bits = learned_bits;
    h.tells_numbers = true;
    return {h};
}

Hypothesis elsewhere(const DiagnosisInput& input, const Part& part, const ProposedCamera& proposed) {
    Hypothesis h = shown_instead(
        input,
        {"a part of the scene stands elsewhere",
         part.node + " is seen as if " + proposed.cause.name + ": " + proposed.cause.description,
         "Look at its node: translation, rotation, scale, and those of its parents."},
        with_part_moved(input.scene, part, input.view.camera, proposed.camera.view.camera), input.view);
    h.learned_bits = proposed.learned_bits;
    h.tells_numbers = true;
    return h;
}

/// Tiles that hold a defect are that camera's, or some pixels: where most of the frame is the declared one's.
std::vector<Hypothesis> stale_parts(const DiagnosisInput& input,
                                    const std::optional<ProposedCamera>& proposed) {
    if (!proposed) return {};
    if (const Part* part = only_part_that_differs(input)) return {elsewhere(input, *part, *proposed)};
    const auto world = std::make_shared<OtherWorld>(input, declared_scene(input), proposed->camera.view);
    std::vector<Hypothesis> all;
    for (const int side : {256, 128, 64, 32, 16, 8, 1}) {
        if (side >= std::max(input.view.width, input.view.height)) continue;
        Hypothesis h = decided_by(
            input,
            {side == 1 ? "part of the picture shows another view"
                       : "tiles of " + std::to_string(side) + " px show another view",
             "There " + proposed->cause.name + ": " + proposed->cause.description,
             "Look at what is left of the frame before: tiles that are skipped, not cleared, or shown too "
             "early."},
            world, [world](const Claim& claim) { return world->admits(claim); },
            [world](const Claim& claim) { return world->depth_of(claim); });
        h.cell = {side, side};
        h.learned_bits = proposed->learned_bits;
        h.tells_numbers = true;
        all.push_back(std::move(h));
    }
    return all;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_fitted_cameras(const DiagnosisInput& input) {
    const CameraFit fit(input, CameraFit::Samples::of_all);
    std::vector<Hypothesis> all = seen_by(input, best_of(input, fit, window_models));
    const std::optional<ProposedCamera> posed_elsewhere = best_of(input, fit, pose_models);
    const std::vector<Hypothesis> more =
        posed_elsewhere
            ? seen_by(input, posed_elsewhere)
            : stale_parts(input, best_of(input, {input, CameraFit::Samples::of_what_is_wrong}, pose_models));
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace zproof
