#include "tests/attack/planted_values.h"

#include <algorithm>
#include <cmath>

namespace zproof::attack {

namespace {

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
            const auto front = front_range(image, p, Number(promise.eps_px), from);
            const bool is_far = ((x + y) & 1) != 0;
            if (!front || (is_perspective && front->least <= 0)) continue;
            const Number end = scene.depth(is_far ? front->least : front->greatest);
            const Number room =
                absolute(end) * Number(allowance.depth_relative) + Number(allowance.depth_absolute);
            const WrongDepth wrong = beyond(end, room, factor, is_far);
            if (wrong.depth <= 0 && scene.view().camera.near_depth >= 0) continue;
            planted.frame.camera_depth.at(x, y) = wrong.depth;
            planted.pixels.push_back({x, y, PixelClass::wrong_depth, wrong.factor});
        }
    return planted;
}

namespace {

/// The nearest depth that any triangle may have there, and its error; none where none comes near.
struct Nearest {
    Number end, room;
};

/// A triangle without a plane has any depth between its corners'.
Extremes<Number> front_of_corners(const ExactImage& image) {
    Extremes<Number> extremes{image[0].front, image[0].front};
    for (const auto& c : image) {
        extremes.least = std::min<Number>(extremes.least, c.front);
        extremes.greatest = std::max<Number>(extremes.greatest, c.front);
    }
    return extremes;
}

std::optional<Nearest> nearest_of_all(const ExactScene& scene, const Allowance& allowance, int x, int y) {
    const ExactPlace p = place_of(scene.view(), x, y);
    const Place<double> rounded = rounded_place_of(scene.view(), x, y);
    std::optional<Nearest> nearest;
    for (std::size_t t = 0; t < scene.size(); ++t) {
        const auto distance = distance_to(scene.rounded(t), rounded);
        if (!distance || *distance > 2 * allowance.eps_px + 1e-6) continue;
        auto front = front_range(scene.image(t), p, Number(allowance.eps_px), DepthFrom::square);
        if (!front) front = front_of_corners(scene.image(t));
        if (!front || (scene.view().camera.projection == Projection::perspective && front->greatest <= 0))
            continue;
        const Number end = scene.depth(front->greatest);
        const Number room =
            absolute(end) * Number(allowance.depth_relative) + Number(allowance.depth_absolute);
        if (!nearest || end - room < nearest->end - nearest->room) nearest = {end, room};
    }
    return nearest;
}

/// Weights of the second and third corner, perspective-correct, at a place of the triangle's plane.
std::array<Number, 2> weights_at(const ExactImage& image, bool is_perspective, const ExactPlace& p) {
    const Number area = twice_area(image);
    std::array<Number, 3> w{side_of(image[1], image[2], p) / area, side_of(image[2], image[0], p) / area,
                            side_of(image[0], image[1], p) / area};
    if (is_perspective)
        for (std::size_t i = 0; i < 3; ++i) w[i] *= image[i].front;
    const Number sum = w[0] + w[1] + w[2];
    return {Number(w[1] / sum), Number(w[2] / sum)};
}

/// The weight of the second corner at the pixel, and its greatest in the triangle's part of the square.
std::pair<Number, Number> weight_range(const ExactScene& scene, std::size_t triangle, const ExactPlace& p,
                                       double eps_px) {
    const bool is_perspective = scene.view().camera.projection == Projection::perspective;
    const ExactImage& image = scene.image(triangle);
    const Number here = weights_at(image, is_perspective, p)[0];
    Number greatest = here;
    for (const auto& corner : part_in_square(image, p, Number(eps_px)))
        greatest = std::max<Number>(greatest, weights_at(image, is_perspective, {corner.x, corner.y})[0]);
    return {here, greatest};
}

}  // namespace

PlantedFrame with_depths_before_all(const Trial& trial, const BoundedPrecision& promise, double factor) {
    const ExactScene& scene = trial.truth();
    PlantedFrame planted{trial.right(), {}};
    const Allowance allowance = allowance_of(promise, scene.view());
    for (int y = 0; y < planted.frame.size().height; ++y)
        for (int x = 0; x < planted.frame.size().width; ++x) {
            const auto nearest = nearest_of_all(scene, allowance, x, y);
            if (!nearest) continue;
            const WrongDepth wrong = beyond(nearest->end, nearest->room, factor, false);
            if (wrong.depth <= 0 && scene.view().camera.near_depth >= 0) continue;
            planted.frame.camera_depth.at(x, y) = wrong.depth;
            planted.pixels.push_back({x, y, PixelClass::wrong_depth, wrong.factor});
        }
    return planted;
}

PlantedFrame with_wrong_weights(const Trial& trial, const BoundedPrecision& promise, double factor) {
    const ExactScene& scene = trial.truth();
    const bool is_perspective = scene.view().camera.projection == Projection::perspective;
    PlantedFrame planted{trial.right(), {}};
    auto& planes = planted.frame.attributes.planes;
    planes[0] = planes[1] = Plane<float>(planted.frame.size(), 0.0f);
    // bounds.md, "Rounding": weights are at most 1, and their absolute sum is their sum inside
    const Number rounding = 2 * Number(promise.depth_relative) + Number(0x1p-24);
    for (int y = 0; y < planted.frame.size().height; ++y)
        for (int x = 0; x < planted.frame.size().width; ++x) {
            const auto id = std::size_t(planted.frame.primitive.at(x, y));
            const ExactPlace p = place_of(scene.view(), x, y);
            if (planted.frame.primitive.at(x, y) == PrimitiveId::none || !covers(scene.image(id), p))
                continue;
            if (!scene.is_whole(id)) {  // it is not judged here, and takes no part
                planted.frame.primitive.at(x, y) = PrimitiveId::none;
                planted.frame.camera_depth.at(x, y) = background_depth;
                continue;
            }
            const auto right = weights_at(scene.image(id), is_perspective, p);
            const auto range = weight_range(scene, id, p, promise.eps_px);
            const Number room = range.second - range.first + rounding;
            float wrong = float(double(range.first + room * Number(factor)));
            const auto got = [&] { return Number((Number(wrong) - range.first) / room); };
            while (got() < Number(factor)) wrong = std::nextafterf(wrong, HUGE_VALF);
            planes[0].at(x, y) = wrong;
            planes[1].at(x, y) = float(double(right[1]));
            planted.pixels.push_back({x, y, PixelClass::wrong_attribute, double(got())});
        }
    return planted;
}

}  // namespace zproof::attack
