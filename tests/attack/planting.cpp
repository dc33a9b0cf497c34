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

WrongPlaces::WrongPlaces(const Trial& trial, double depth_relative, Sharing sharing)
    : trial_(trial), depth_relative_(depth_relative), sharing_(sharing), at_(trial.right().size(), {}) {
    for (int y = 0; y < at_.size().height; ++y)
        for (int x = 0; x < at_.size().width; ++x) find(x, y);
}

/// How far its sides, and the diagonals along which it may come apart, are from p, which it covers.
template <class N>
N WrongPlaces::held_within(const Image<N>& image, const Place<N>& p) const {
    N least = inset_of(image, p);
    if (sharing_ == Sharing::alike) return least;
    for (std::size_t i = 0; i < image.size(); ++i)
        for (std::size_t k = i + 2; k < image.size(); ++k)
            least = std::min<N>(least, distance_to_side(image[i], image[k], p));
    return least;
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
        const double inset = held_within(scene.rounded(t), p);
        if (inset > hole.need_px) hole.need_px = inset, hole.other = t;
    }
    if (hole.need_px > 0 && hole.need_px < most_need_px) at_.at(x, y).push_back(hole);
    for (const std::size_t t : covering) {
        const double front = front_at(scene.rounded(t), p).value_or(HUGE_VAL);
        WrongPlace hidden{PixelClass::hidden, PrimitiveId(t), t, 0};
        for (const std::size_t other : covering) {
            if (front_at(scene.rounded(other), p).value_or(-HUGE_VAL) <= front) continue;
            const double inset = held_within(scene.rounded(other), p);
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
                                                          : held_within(scene.image(wrong.other), p);
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

namespace {

/// Of the plane over the square; none where the triangle has no plane.
std::optional<Extremes<Number>> plane_in_square(const ExactImage& image, const ExactPlace& p,
                                                const Number& half_side) {
    const auto here = front_at(image, p), right = front_at(image, {p.x + 1, p.y}),
               below = front_at(image, {p.x, p.y + 1});
    if (!here) return std::nullopt;
    const Number reach = half_side * (absolute<Number>(*right - *here) + absolute<Number>(*below - *here));
    return Extremes<Number>{*here - reach, *here + reach};
}

/// A depth beyond one end of what is permitted, and how far in units of the error there.
struct WrongDepth {
    float depth;
    double factor;
};

WrongDepth beyond(const Number& end, const Number& room, double factor, bool is_far) {
    const Number step = room * Number(factor);
    float depth = float(double(is_far ? Number(end + step) : Number(end - step)));
    const auto got = [&] { return Number((is_far ? Number(depth) - end : end - Number(depth)) / room); };
    while (got() < Number(factor)) depth = std::nextafterf(depth, is_far ? HUGE_VALF : -HUGE_VALF);
    return {depth, double(got())};
}

}  // namespace

PlantedFrame with_wrong_depths(const Trial& trial, const BoundedPrecision& promise, DepthFrom from,
                               double factor) {
    const ExactScene& scene = trial.truth();
    PlantedFrame planted{trial.right(), {}};
    const Allowance allowance = allowance_of(promise, scene.view());
    const bool is_perspective = scene.view().camera.projection == Projection::perspective;
    for (int y = 0; y < planted.frame.size().height; ++y)
        for (int x = 0; x < planted.frame.size().width; ++x) {
            const PrimitiveId id = planted.frame.primitive.at(x, y);
            if (id == PrimitiveId::none) continue;
            const ExactImage& image = scene.image(std::size_t(id));
            const ExactPlace p = place_of(scene.view(), x, y);
            const auto front = from == DepthFrom::square ? plane_in_square(image, p, Number(promise.eps_px))
                                                         : front_in_square(image, p, Number(promise.eps_px));
            const bool is_far = ((x + y) & 1) != 0;
            if (!front || (is_perspective && front->least <= 0)) continue;
            const Number end = scene.depth(is_far ? front->least : front->greatest);
            const Number room =
                absolute(end) * Number(allowance.depth_relative) + Number(allowance.depth_absolute);
            const WrongDepth wrong = beyond(end, room, factor, is_far);
            if (wrong.depth <= 0 && scene.view().camera.near_depth >= 0) continue;
            answer(planted.frame, x, y, id, wrong.depth);
            planted.pixels.push_back({x, y, PixelClass::wrong_depth, wrong.factor});
        }
    return planted;
}

}  // namespace zproof::attack
