#include "tests/attack/planting.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace zproof::attack {

namespace {

/// Wrong answers that need more are easy to find.
constexpr double most_need_px = 3;

float depth_shown(const ExactScene& scene, std::size_t triangle, const Place<double>& p) {
    const Image<double>& image = scene.rounded(triangle);
    const auto [least, greatest] = std::ranges::minmax(image, {}, &ImageCorner<double>::front);
    const double front = front_at(image, p).value_or(least.front);
    return float(scene.depth(std::clamp(front, least.front, greatest.front)));
}

/// How far the corners of what is left of a triangle move, in x or in y; none where their number changes.
std::optional<Number> moved_px(const ExactImage& from, const ExactImage& to) {
    if (from.size() != to.size()) return std::nullopt;
    Number farthest = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
        farthest = std::max<Number>(
            {farthest, absolute<Number>(from[i].x - to[i].x), absolute<Number>(from[i].y - to[i].y)});
    return farthest;
}

/// The same of every triangle, where near and far err by a share of their depth.
std::vector<std::optional<Number>> moved_by_planes_px(const Trial& trial, double share) {
    const ExactScene& truth = trial.truth();
    std::vector<std::optional<Number>> moved(truth.size(), Number(0));
    const auto take = [&](const Number& of_near, const Number& of_far) {
        const View& view = truth.view();
        Planes planes = planes_of(view);
        planes.near += absolute(planes.near) * of_near;
        if (planes.far) *planes.far += absolute(*planes.far) * of_far;
        const ExactScene there(trial.scene().scene, view, planes);
        for (std::size_t t = 0; t < truth.size(); ++t) {
            const auto px = moved_px(truth.left_by_planes(t), there.left_by_planes(t));
            if (moved[t]) moved[t] = px ? std::optional(std::max<Number>(*moved[t], *px)) : std::nullopt;
        }
    };
    for (const int near_end : {-1, 1})
        for (const int far_end : {-1, 1}) take(near_end * Number(share), far_end * Number(share));
    return moved;
}

}  // namespace

WrongPlaces::WrongPlaces(const Trial& trial, double depth_relative, Sharing sharing)
    : trial_(trial),
      depth_relative_(depth_relative),
      sharing_(sharing),
      moved_by_planes_px_(sharing == Sharing::apart ? moved_by_planes_px(trial, depth_relative)
                                                    : std::vector<std::optional<Number>>{}),
      at_(trial.right().size(), {}),
      may_be_shown_(trial.right().size(), {}) {
    for (int y = 0; y < at_.size().height; ++y)
        for (int x = 0; x < at_.size().width; ++x) find(x, y);
}

/// How far its sides, and the diagonals along which it may come apart, are from p, which it covers. Nothing
/// where these may lie anywhere.
Number WrongPlaces::held_within(std::size_t triangle, const ExactPlace& p) const {
    Number least = inset_of(trial_.truth().image(triangle), p);
    if (sharing_ == Sharing::alike) return least;
    const ExactImage& left = trial_.truth().left_by_planes(triangle);
    for (std::size_t i = 0; i < left.size(); ++i)
        for (std::size_t k = i + 2; k < left.size(); ++k)
            least = std::min<Number>(least, distance_to_side(left[i], left[k], p));
    const std::optional<Number>& moved_px = moved_by_planes_px_[triangle];
    return moved_px && *moved_px < least ? Number(least - *moved_px) : Number(0);
}

double WrongPlaces::roughly_held(std::size_t triangle, int x, int y) const {
    const ExactScene& scene = trial_.truth();
    if (sharing_ == Sharing::apart &&
        (scene.left_by_planes(triangle).size() > 3 || moved_by_planes_px_[triangle] != Number(0)))
        return double(held_within(triangle, place_of(scene.view(), x, y)));
    return inset_of(scene.rounded(triangle), rounded_place_of(scene.view(), x, y));
}

/// By rounded numbers: exact_factor() says whether it is true.
void WrongPlaces::find(int x, int y) {
    const ExactScene& scene = trial_.truth();
    const Place<double> p = rounded_place_of(scene.view(), x, y);
    std::vector<std::size_t> covering;
    WrongPlace hole;
    for (std::size_t t = 0; t < scene.size(); ++t) {
        const auto distance = distance_to(scene.rounded(t), p);
        if (!distance) continue;
        if (*distance > 0 && *distance < most_need_px)
            at_.at(x, y).push_back({PixelClass::outside, PrimitiveId(t), t, *distance});
        if (*distance > 0) continue;
        covering.push_back(t);
        const double inset = roughly_held(t, x, y);
        if (inset > hole.need_px) hole.need_px = inset, hole.other = t;
    }
    if (hole.need_px > 0 && hole.need_px < most_need_px) at_.at(x, y).push_back(hole);
    for (const std::size_t t : covering) {
        const double front = front_at(scene.rounded(t), p).value_or(HUGE_VAL);
        WrongPlace hidden{PixelClass::hidden, PrimitiveId(t), t, 0};
        for (const std::size_t other : covering) {
            if (front_at(scene.rounded(other), p).value_or(-HUGE_VAL) <= front) continue;
            const double inset = roughly_held(other, x, y);
            if (inset > hidden.need_px && hides(other, t, place_of(scene.view(), x, y), inset))
                hidden.need_px = inset, hidden.other = other;
        }
        if (hidden.need_px == 0) may_be_shown_.at(x, y).push_back(std::uint32_t(t));
        if (hidden.need_px > 0 && hidden.need_px < most_need_px) at_.at(x, y).push_back(hidden);
    }
}

/// Wherever both are displaced to within `half_side`, and with twice the error of depth?
bool WrongPlaces::hides(std::size_t occluder, std::size_t hidden, const ExactPlace& p,
                        double half_side) const {
    const ExactScene& scene = trial_.truth();
    const auto before = front_range(scene.image(occluder), p, Number(half_side), DepthFrom::square),
               behind = front_range(scene.image(hidden), p, Number(half_side), DepthFrom::square);
    if (!before || !behind) return false;
    // beyond a plane's horizon it is as far as may be
    if (scene.view().camera.projection == Projection::perspective && before->least <= 0) return false;
    if (scene.view().camera.projection == Projection::perspective && behind->greatest <= 0) return false;
    const Number farthest = scene.depth(before->least), nearest = scene.depth(behind->greatest);
    const Number share = 2 * Number(depth_relative_);
    return farthest + absolute(farthest) * share < nearest - absolute(nearest) * share;
}

std::optional<double> WrongPlaces::exact_factor(const WrongPlace& wrong, int x, int y, double eps_px) const {
    const ExactScene& scene = trial_.truth();
    const ExactPlace p = place_of(scene.view(), x, y);
    const Number need = wrong.kind == PixelClass::outside ? *distance_to(scene.image(wrong.other), p)
                                                          : held_within(wrong.other, p);
    if (wrong.kind == PixelClass::hidden && !hides(wrong.other, std::size_t(wrong.primitive), p, 2 * eps_px))
        return std::nullopt;
    return double(need / Number(eps_px));
}

std::vector<double> WrongPlaces::needs() const {
    std::vector<double> needs;
    for (const auto& here : at_.pixels())
        for (const WrongPlace& wrong : here) needs.push_back(wrong.need_px);
    std::ranges::sort(needs);
    return needs;
}

void WrongPlaces::show(PlantedFrame& planted, const WrongPlace& wrong, int x, int y, double eps_px,
                       double factor) const {
    const auto exact = exact_factor(wrong, x, y, eps_px);
    if (!exact || *exact < factor * (1 - 1e-9)) return;
    const Place<double> p = rounded_place_of(trial_.truth().view(), x, y);
    planted.frame.primitive.at(x, y) = wrong.primitive;
    planted.frame.camera_depth.at(x, y) = wrong.primitive == PrimitiveId::none
                                              ? background_depth
                                              : depth_shown(trial_.truth(), std::size_t(wrong.primitive), p);
    planted.pixels.push_back({x, y, wrong.kind, *exact});
}

PlantedFrame WrongPlaces::planted(double eps_px, double factor) const {
    PlantedFrame planted{trial_.right(), {}};
    for (int y = 0; y < at_.size().height; ++y)
        for (int x = 0; x < at_.size().width; ++x) {
            const WrongPlace* best = nullptr;
            for (const WrongPlace& wrong : at_.at(x, y))
                if (wrong.need_px >= eps_px * factor && (!best || wrong.need_px < best->need_px))
                    best = &wrong;
            if (best) show(planted, *best, x, y, eps_px, factor);
        }
    return planted;
}

/// None where a triangle of the label may be shown, or none comes near.
const WrongPlace* WrongPlaces::least_of_label(std::span<const std::uint32_t> label_of_triangle,
                                              std::uint32_t label, int x, int y) const {
    for (const std::uint32_t t : may_be_shown_.at(x, y))
        if (label_of_triangle[t] == label) return nullptr;
    const WrongPlace* least = nullptr;
    for (const WrongPlace& wrong : at_.at(x, y)) {
        if (wrong.primitive == PrimitiveId::none || label_of_triangle[std::size_t(wrong.primitive)] != label)
            continue;
        if (!least || wrong.need_px < least->need_px) least = &wrong;
    }
    return least;
}

PlantedFrame WrongPlaces::planted_labels(std::span<const std::uint32_t> label_of_triangle, double eps_px,
                                         double factor) const {
    PlantedFrame planted{trial_.right(), {}};
    const std::set<std::uint32_t> labels(label_of_triangle.begin(), label_of_triangle.end());
    for (int y = 0; y < at_.size().height; ++y)
        for (int x = 0; x < at_.size().width; ++x) {
            const WrongPlace* best = nullptr;
            for (const std::uint32_t label : labels) {
                const WrongPlace* wrong = least_of_label(label_of_triangle, label, x, y);
                if (!wrong || wrong->need_px < eps_px * factor) continue;
                if (!best || wrong->need_px < best->need_px) best = wrong;
            }
            if (best) show(planted, *best, x, y, eps_px, factor);
        }
    return planted;
}

}  // namespace zproof::attack
