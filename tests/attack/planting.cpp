#include "tests/attack/planting.h"

#include <algorithm>
#include <cmath>

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

void answer(Frame& frame, int x, int y, PrimitiveId id, float depth) {
    frame.primitive.at(x, y) = id;
    frame.camera_depth.at(x, y) = depth;
}

}  // namespace

WrongPlaces::WrongPlaces(const Trial& trial, double depth_relative)
    : trial_(trial), depth_relative_(depth_relative), at_(trial.right().size(), {}) {
    for (int y = 0; y < at_.size().height; ++y)
        for (int x = 0; x < at_.size().width; ++x) find(x, y);
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
        const double inset = inset_of(scene.rounded(t), p);
        if (inset > hole.need_px) hole.need_px = inset, hole.other = t;
    }
    if (hole.need_px > 0 && hole.need_px < most_need_px) at_.at(x, y).push_back(hole);
    for (const std::size_t t : covering) {
        const double front = front_at(scene.rounded(t), p).value_or(HUGE_VAL);
        WrongPlace hidden{PixelClass::hidden, PrimitiveId(t), t, 0};
        for (const std::size_t other : covering) {
            if (front_at(scene.rounded(other), p).value_or(-HUGE_VAL) <= front) continue;
            const double inset = inset_of(scene.rounded(other), p);
            if (inset > hidden.need_px && hides(other, t, place_of(scene.view(), x, y), inset))
                hidden.need_px = inset, hidden.other = other;
        }
        if (hidden.need_px > 0 && hidden.need_px < most_need_px) at_.at(x, y).push_back(hidden);
    }
}

/// Wherever both are displaced to within `half_side`, and with twice the error of depth?
bool WrongPlaces::hides(std::size_t occluder, std::size_t hidden, const ExactPlace& p,
                        double half_side) const {
    const ExactScene& scene = trial_.truth();
    const auto before = front_in_square(scene.image(occluder), p, Number(half_side)),
               behind = front_in_square(scene.image(hidden), p, Number(half_side));
    if (!before || !behind) return false;
    const Number farthest = scene.depth(before->least), nearest = scene.depth(behind->greatest);
    const Number share = 2 * Number(depth_relative_);
    return farthest + absolute(farthest) * share < nearest - absolute(nearest) * share;
}

std::optional<double> WrongPlaces::exact_factor(const WrongPlace& wrong, int x, int y, double eps_px) const {
    const ExactScene& scene = trial_.truth();
    const ExactPlace p = place_of(scene.view(), x, y);
    const Number need = wrong.kind == PixelClass::outside ? *distance_to(scene.image(wrong.other), p)
                                                          : inset_of(scene.image(wrong.other), p);
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

PlantedFrame WrongPlaces::planted(double eps_px, double factor) const {
    PlantedFrame planted{trial_.right(), {}};
    for (int y = 0; y < at_.size().height; ++y)
        for (int x = 0; x < at_.size().width; ++x) {
            const WrongPlace* best = nullptr;
            for (const WrongPlace& wrong : at_.at(x, y))
                if (wrong.need_px >= eps_px * factor && (!best || wrong.need_px < best->need_px))
                    best = &wrong;
            if (!best) continue;
            const auto exact = exact_factor(*best, x, y, eps_px);
            if (!exact || *exact < factor * (1 - 1e-9)) continue;
            const Place<double> p = rounded_place_of(trial_.truth().view(), x, y);
            const float depth = best->primitive == PrimitiveId::none
                                    ? background_depth
                                    : depth_shown(trial_.truth(), std::size_t(best->primitive), p);
            answer(planted.frame, x, y, best->primitive, depth);
            planted.pixels.push_back({x, y, best->kind, *exact});
        }
    return planted;
}

PlantedFrame with_wrong_depths(const Trial& trial, const BoundedPrecision& promise, double factor,
                               std::uint64_t seed) {
    const ExactScene& scene = trial.truth();
    PlantedFrame planted{trial.right(), {}};
    const Allowance allowance = allowance_of(promise, scene.view());
    for (int y = 0; y < planted.frame.size().height; ++y)
        for (int x = 0; x < planted.frame.size().width; ++x) {
            const PrimitiveId id = planted.frame.primitive.at(x, y);
            if (id == PrimitiveId::none) continue;
            const auto front = front_in_square(scene.image(std::size_t(id)), place_of(scene.view(), x, y),
                                               Number(promise.eps_px));
            if (!front) continue;  // it is at the limit of what the truth is drawn with
            const bool is_far = ((seed + std::uint64_t(x) + std::uint64_t(y)) & 1) != 0;
            const Number end = scene.depth(is_far ? front->least : front->greatest);
            const Number room =
                absolute(end) * Number(allowance.depth_relative) + Number(allowance.depth_absolute);
            const Number wanted =
                is_far ? Number(end + room * Number(factor)) : Number(end - room * Number(factor));
            float depth = float(double(wanted));
            const auto got = [&] { return absolute<Number>(Number(depth) - end) / room; };
            while (got() < Number(factor)) depth = std::nextafterf(depth, is_far ? HUGE_VALF : -HUGE_VALF);
            if (depth <= 0 && scene.view().camera.near_depth >= 0) continue;
            answer(planted.frame, x, y, id, depth);
            planted.pixels.push_back({x, y, PixelClass::wrong_depth, double(got())});
        }
    return planted;
}

}  // namespace zproof::attack
