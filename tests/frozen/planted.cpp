#include "tests/frozen/planted.h"

#include <algorithm>
#include <limits>

#include "tests/frozen/true_depth.h"

namespace zproof::frozen {
namespace {

constexpr int planted_count = 2000;

Shown shown_by(const Frame& frame, int x, int y) {
    return {frame.primitive.at(x, y), frame.camera_depth.at(x, y)};
}

/// The scene and the frame that answers are planted into.
struct Ground {
    const Scene& scene;
    const View& view;
    const Frame& good;
};

/// What is shown up to three pixels aside.
Shown neighbours(const Ground& on, int x, int y, RandomNumbers& numbers) {
    const int right = x - 3 + numbers.below(7), down = y - 3 + numbers.below(7);
    return shown_by(on.good, std::clamp(right, 0, on.view.width - 1),
                    std::clamp(down, 0, on.view.height - 1));
}

float depth_at_centre(const Ground& on, PrimitiveId id, int x, int y) {
    if (id == PrimitiveId::none) return background_depth;
    return depth_at(on.scene, on.view, id, {x + 0.5, y + 0.5});
}

Shown any_triangle(const Ground& on, int x, int y, RandomNumbers& numbers) {
    const PrimitiveId id{numbers.below(std::uint32_t(on.scene.triangles.size()))};
    return {id, depth_at_centre(on, id, x, y)};
}

Shown planted_at(const Ground& on, int x, int y, RandomNumbers& numbers) {
    const Shown right = shown_by(on.good, x, y);
    switch (numbers.below(8)) {
        case 0:
        case 1: {
            const PrimitiveId id = neighbours(on, x, y, numbers).primitive;
            return {id, depth_at_centre(on, id, x, y)};
        }
        case 2:
            return neighbours(on, x, y, numbers);
        case 3:
            return any_triangle(on, x, y, numbers);
        case 4:
            return {};
        case 5:
        case 6:
            return {right.primitive, wrong_depth(right.depth, numbers)};
        default:
            return nonsense(right, std::uint32_t(on.scene.triangles.size()), numbers);
    }
}

}  // namespace

Shown nonsense(Shown right, std::uint32_t triangle_count, RandomNumbers& numbers) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    switch (numbers.below(8)) {
        case 0:
            return {right.primitive, std::numeric_limits<float>::quiet_NaN()};
        case 1:
            return {right.primitive, -right.depth};
        case 2:
            return {PrimitiveId{triangle_count}, right.depth};
        case 3:
            return {PrimitiveId{0xFFFF'FFFE}, right.depth};
        case 4:
            return {PrimitiveId::none, 1.0f};
        case 5:
            return {right.primitive, infinity};
        case 6:
            return {right.primitive, 0.0f};
        default:
            return {right.primitive, -0.0f};
    }
}

float wrong_depth(float right, RandomNumbers& numbers) {
    const double error = power_of_two(-numbers.below(31));
    return float(double(right) * (numbers.once_in(2) ? 1 + error : 1 - 0.5 * error));
}

Frame with_planted_answers(const Scene& scene, const View& view, const Frame& good, std::uint32_t seed) {
    RandomNumbers numbers(seed);
    Frame frame = good;
    for (int i = 0; i < planted_count; ++i) {
        const int x = numbers.below(view.width), y = numbers.below(view.height);
        const Shown planted = planted_at({scene, view, good}, x, y, numbers);
        frame.primitive.at(x, y) = planted.primitive;
        frame.camera_depth.at(x, y) = planted.depth;
    }
    return frame;
}

}  // namespace zproof::frozen
