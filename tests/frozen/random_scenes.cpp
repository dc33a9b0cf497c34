#include "tests/frozen/random_scenes.h"

#include <algorithm>
#include <limits>

#include "tests/frozen/planted.h"
#include "tests/frozen/true_depth.h"

namespace zproof::frozen {
namespace {

/// A corner by where it is seen, px, and its camera depth.
using Seen = glm::dvec3;

glm::vec3 position_world(const View& view, const glm::dvec3& p_camera) {
    const Camera& c = view.camera;
    return glm::vec3(glm::dvec3(c.eye_world) + p_camera.x * c.right + p_camera.y * c.up +
                     p_camera.z * c.back);
}

glm::dvec3 position_camera(const View& view, const Seen& seen) {
    const Camera& c = view.camera;
    const double u = c.window.left + (c.window.right - c.window.left) * seen.x / view.width;
    const double v = c.window.top - (c.window.top - c.window.bottom) * seen.y / view.height;
    if (c.projection == Projection::perspective) return {u * seen.z, v * seen.z, -seen.z};
    return {u + seen.z * c.shear.x, v + seen.z * c.shear.y, -seen.z};
}

/// A scene that grows.
struct Growing {
    const View& view;
    RandomNumbers& numbers;
    Scene scene{};

    std::uint32_t corner_world(const glm::vec3& p_world) {
        scene.vertices.position_world.push_back(p_world);
        return std::uint32_t(scene.vertices.position_world.size() - 1);
    }
    std::uint32_t corner(const Seen& seen) {
        return corner_world(position_world(view, position_camera(view, seen)));
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        scene.triangles.emplace_back(a, b, c);
    }
    void triangle(const Seen& a, const Seen& b, const Seen& c) {
        const std::uint32_t first = corner(a);
        corner(b);
        corner(c);
        triangle(first, first + 1, first + 2);
    }
    /// Behind everything, or nothing.
    void maybe_wall(double depth) {
        if (numbers.once_in(2)) triangle({-64, -64, depth}, {192, -64, depth}, {-64, 192, depth});
    }
};

/// The offsets from a pixel's centre that matter, px: none, within eps, beyond.
double random_offset(RandomNumbers& numbers) {
    switch (numbers.below(5)) {
        case 0:
        case 1:
            return 0;
        case 2:
            return numbers.between(-1, 1) * 0x1p-8;
        case 3:
            return numbers.between(-1, 1) * 0x1p-10;
        default:
            return numbers.between(-0.5, 0.5);
    }
}

double random_depth(RandomNumbers& numbers) {
    constexpr std::array depths{2.0, 4.0, 4.0, 4.0 + 0x1p-20, 8.0};
    return numbers.once_in(3) ? numbers.between(0.5, 12) : numbers.one_of(depths);
}

/// Near some pixel's centre.
Seen random_seen(const View& view, RandomNumbers& numbers) {
    const double x = numbers.below(view.width) + 0.5;
    const double y = numbers.below(view.height) + 0.5;
    return Seen{x + random_offset(numbers), y + random_offset(numbers), random_depth(numbers)};
}

/// Near a pixel's centre in the same column, row or diagonal, so that the line passes near more of them.
Seen in_line_with(const Seen& a, RandomNumbers& numbers) {
    constexpr std::array<glm::dvec2, 4> directions{glm::dvec2{1, 0}, {0, 1}, {1, 1}, {1, -1}};
    const double pixels = numbers.below(41) - 20;
    const glm::dvec2 step = pixels * numbers.one_of(directions);
    const double x = a.x + step.x + random_offset(numbers);
    return Seen{x, a.y + step.y, random_depth(numbers)};
}

/// Anywhere around the image.
Seen far_seen(RandomNumbers& numbers) {
    return Seen{numbers.between(-16, 32), numbers.between(-16, 32), random_depth(numbers)};
}

Seen random_or_far_seen(const View& view, RandomNumbers& numbers) {
    return numbers.once_in(2) ? random_seen(view, numbers) : far_seen(numbers);
}

double random_tiny(RandomNumbers& numbers, int least_power, int most_power) {
    const double size = power_of_two(least_power + numbers.below(most_power - least_power + 1));
    return numbers.between(-1, 1) * size;
}

/// `count` triangles in one plane, as well as float32 can say it; some lifted off by next to nothing.
void coplanar(Growing& grown) {
    RandomNumbers& numbers = grown.numbers;
    const double depth = random_depth(numbers);
    const double tilt = numbers.once_in(2) ? 0 : random_tiny(numbers, -20, -3);
    const int count = 2 + numbers.below(4);
    for (int i = 0; i < count; ++i) {
        const double lift = numbers.once_in(3) ? random_tiny(numbers, -26, -12) : 0;
        const auto on_plane = [&] {
            Seen seen = random_or_far_seen(grown.view, numbers);
            seen.z = (depth + tilt * seen.x) * (1 + lift);
            return seen;
        };
        const Seen a = on_plane(), b = on_plane(), c = on_plane();
        grown.triangle(a, b, c);
    }
}

/// Two sheets that meet along a line, cut into `pieces` on the one side and left whole on the other.
void abutting(Growing& grown) {
    RandomNumbers& numbers = grown.numbers;
    grown.maybe_wall(16);
    Seen top = random_seen(grown.view, numbers), bottom = random_seen(grown.view, numbers);
    top.y -= 20, bottom.y += 20;
    if (numbers.once_in(2)) top.z = bottom.z = 4;
    if (numbers.once_in(2)) bottom.x = top.x + random_tiny(numbers, -14, -6);
    grown.triangle(top, bottom, {-200, 8, 4});
    const int pieces = 1 + numbers.below(6);
    const double gap = numbers.once_in(3) ? random_tiny(numbers, -14, -6) : 0;
    for (int i = 0; i < pieces; ++i) {
        Seen from = glm::mix(top, bottom, double(i) / pieces), to = glm::mix(top, bottom, (i + 1.0) / pieces);
        from.x += gap, to.x += gap;
        grown.triangle(from, {200, 8, 4}, to);
    }
}

void slivers(Growing& grown) {
    RandomNumbers& numbers = grown.numbers;
    grown.maybe_wall(12);
    const int count = 2 + numbers.below(6);
    for (int i = 0; i < count; ++i) {
        const Seen a = random_seen(grown.view, numbers);
        const Seen b = numbers.once_in(2) ? in_line_with(a, numbers) : far_seen(numbers);
        Seen c = glm::mix(a, b, numbers.between(-0.5, 1.5));
        c.y += random_tiny(numbers, -24, -1);
        grown.triangle(a, b, c);
    }
}

/// On the rim of the square of half-side 1, a full turn as `share` goes from 0 to 1.
glm::dvec2 on_square(double share) {
    const double turn = 4 * (share - int(share));
    const double along = 2 * (turn - int(turn)) - 1;
    switch (int(turn)) {
        case 0:
            return {along, -1};
        case 1:
            return {1, along};
        case 2:
            return {-along, 1};
        default:
            return {-1, -along};
    }
}

/// A fan around one corner; now and then a blade is left out, or lies there twice.
void fan(Growing& grown, const Seen& hub) {
    RandomNumbers& numbers = grown.numbers;
    const int blades = 3 + numbers.below(22);
    const double radius = numbers.between(1, 30), slope = numbers.once_in(2) ? 0 : numbers.between(-0.4, 0.4);
    const double start = numbers.once_in(2) ? 0 : numbers.between(0, 1);
    const std::uint32_t centre = grown.corner(hub);
    for (int i = 0; i < blades; ++i) {
        const glm::dvec2 aside = radius * on_square(start + double(i) / blades);
        grown.corner({hub.x + aside.x, hub.y + aside.y, hub.z * (1 + slope)});
    }
    for (int i = 0; i < blades; ++i) {
        const auto from = centre + 1 + std::uint32_t(i), to = centre + 1 + std::uint32_t((i + 1) % blades);
        const int kind = numbers.below(12);
        if (kind != 0) grown.triangle(centre, from, to);
        if (kind == 1) grown.triangle(to, centre, from);
    }
}

void hubs(Growing& grown) {
    grown.maybe_wall(12);
    const Seen hub = random_seen(grown.view, grown.numbers);
    fan(grown, hub);
    if (grown.numbers.once_in(3)) fan(grown, {hub.x, hub.y, random_depth(grown.numbers)});
}

/// Three corners on one line of the image, or off it by next to nothing, at depths that differ.
void edge_on(Growing& grown) {
    RandomNumbers& numbers = grown.numbers;
    grown.maybe_wall(12);
    const int count = 1 + numbers.below(4);
    for (int i = 0; i < count; ++i) {
        const Seen a = random_seen(grown.view, numbers);
        const Seen b = numbers.once_in(2) ? in_line_with(a, numbers) : far_seen(numbers);
        Seen c = glm::mix(a, b, numbers.between(-2, 3));
        if (!numbers.once_in(3)) c.x += random_tiny(numbers, -30, -6);
        c.z = numbers.between(0.5, 12);
        grown.triangle(a, b, c);
    }
}

/// Over the whole image; has this depth in the column `through`.
struct Sheet {
    double depth, through, tilt, aside = 0;
};

void add_sheet(Growing& grown, const Sheet& sheet) {
    const auto corner = [&](double x, double y) {
        return Seen{x + sheet.aside, y, std::max(sheet.depth + sheet.tilt * (x - sheet.through), 0.125)};
    };
    grown.triangle(corner(0, -64), corner(64, 200), corner(-64, 200));
}

double random_column(Growing& grown) {
    const double column = grown.numbers.below(grown.view.width) + 0.5;
    return column + random_offset(grown.numbers);
}

/// Sheets in planes that nearly agree.
void crossing(Growing& grown) {
    RandomNumbers& numbers = grown.numbers;
    const double through = random_column(grown);
    const int count = 2 + numbers.below(3);
    for (int i = 0; i < count; ++i) {
        const double depth = numbers.once_in(4) ? 16 : 8;
        const double tilt = numbers.once_in(3) ? 0 : random_tiny(numbers, -24, -2);
        const double lift = numbers.once_in(3) ? random_tiny(numbers, -40, -1) : 0;
        const double aside = numbers.once_in(6) ? numbers.between(0, 16) : 0;
        add_sheet(grown, {depth + lift, through, tilt, aside});
    }
}

/// Corners before near, behind the eye, beyond far, and exactly on the planes.
void cut(Growing& grown) {
    RandomNumbers& numbers = grown.numbers;
    const Camera& camera = grown.view.camera;
    const double far = camera.far_depth < 1e30 ? camera.far_depth : 100;
    const std::array depths{camera.near_depth, camera.near_depth, far, far, 0.0, -2.0, 4.0, 2 * far};
    const int count = 2 + numbers.below(4);
    for (int i = 0; i < count; ++i) {
        std::array<std::uint32_t, 3> corners;
        for (std::uint32_t& corner : corners) {
            const Seen seen = random_or_far_seen(grown.view, numbers);
            glm::dvec3 p_camera = position_camera(grown.view, seen);
            if (numbers.once_in(2)) p_camera.z = -numbers.one_of(depths);
            corner = grown.corner_world(position_world(grown.view, p_camera));
        }
        grown.triangle(corners[0], corners[1], corners[2]);
    }
}

/// Sheets that near or far cuts along a column.
void cut_sheets(Growing& grown) {
    RandomNumbers& numbers = grown.numbers;
    const Camera& camera = grown.view.camera;
    const int count = 1 + numbers.below(3);
    for (int i = 0; i < count; ++i) {
        const bool at_far = camera.far_depth < 1e30 && numbers.once_in(2);
        const double through = random_column(grown);
        add_sheet(grown,
                  {at_far ? camera.far_depth : camera.near_depth, through, random_tiny(numbers, -20, 0)});
    }
}

using Kind = void (*)(Growing&);
constexpr std::array<Kind, 8> kinds{coplanar, abutting, slivers, hubs, cut, cut_sheets, edge_on, crossing};

/// A unit vector in the plane, without a sine.
glm::dvec2 turned(double half_tangent) {
    const double square = half_tangent * half_tangent;
    return {(1 - square) / (1 + square), 2 * half_tangent / (1 + square)};
}

void turn(Camera& camera, RandomNumbers& numbers) {
    const glm::dvec2 yaw = turned(numbers.between(-4, 4));
    const glm::dvec2 pitch = turned(numbers.between(-0.9, 0.9));
    camera.right = {yaw.x, 0, -yaw.y};
    camera.up = {-yaw.y * pitch.y, pitch.x, -yaw.x * pitch.y};
    camera.back = {yaw.y * pitch.x, pitch.y, yaw.x * pitch.x};
    camera.eye_world = glm::vec3{numbers.between(-9, 9), numbers.between(-9, 9), numbers.between(-9, 9)};
    camera.window = {.left = -0.9, .right = 0.7, .bottom = -0.8, .top = 0.6};
}

View random_view(RandomNumbers& numbers) {
    View view{.name = "random", .camera = {}, .width = 16, .height = 16};
    const int most_px = numbers.one_of(std::array{4, 4, 16});
    view.width = 1 + numbers.below(most_px);
    view.height = 1 + numbers.below(most_px);
    Camera& c = view.camera;
    if (numbers.once_in(2)) c.projection = Projection::parallel;
    const bool is_parallel = c.projection == Projection::parallel;
    c.window = {.left = 0, .right = double(view.width), .bottom = -double(view.height), .top = 0};
    c.near_depth = numbers.one_of(std::array{0.25, 0.25, 2.0, 4.0});
    c.far_depth = numbers.one_of(std::array{8.0, 100.0, 100.0, 5.0});
    if (numbers.once_in(2)) turn(c, numbers);
    if (is_parallel && numbers.once_in(3)) c.shear = {numbers.between(-0.5, 0.5), 0.25};
    if (!is_parallel && numbers.once_in(4)) c.far_depth = std::numeric_limits<double>::infinity();
    return view;
}

/// What is seen at the pixel's centre, or so near to it that a renderer may show it, or a bit farther.
PrimitiveId seen_nearby(const RandomScene& of, int x, int y, RandomNumbers& numbers) {
    const double aside = numbers.one_of(std::array{0.0, 0.0, 0x1p-11, 0x1p-9, 0x1p-8, 0x1p-6});
    const double right = numbers.between(-aside, aside);
    const double down = numbers.between(-aside, aside);
    return seen_at(of.scene, of.view, {x + 0.5 + right, y + 0.5 + down});
}

/// One of all that cover the place, however deep; none where there is none.
PrimitiveId covering_at(const RandomScene& of, const glm::dvec2& p_raster, RandomNumbers& numbers) {
    const std::vector<PrimitiveId> all = all_at(of.scene, of.view, p_raster);
    return all.empty() ? PrimitiveId::none : all[numbers.below(std::uint32_t(all.size()))];
}

PrimitiveId random_id(const RandomScene& of, int x, int y, RandomNumbers& numbers) {
    switch (numbers.below(12)) {
        case 0:
            return PrimitiveId::none;
        case 1:
            return PrimitiveId{numbers.below(std::uint32_t(of.scene.triangles.size()))};
        case 2:
        case 3:
            return covering_at(of, {x + 0.5, y + 0.5}, numbers);
        default:
            return seen_nearby(of, x, y, numbers);
    }
}

Shown random_answer(const RandomScene& of, int x, int y, RandomNumbers& numbers) {
    const PrimitiveId id = random_id(of, x, y, numbers);
    Shown answer{.primitive = id};
    if (id != PrimitiveId::none) answer.depth = depth_at(of.scene, of.view, id, {x + 0.5, y + 0.5});
    const int fate = numbers.below(64);
    if (fate == 0) return nonsense(answer, std::uint32_t(of.scene.triangles.size()), numbers);
    if (fate < 6) answer.depth = wrong_depth(answer.depth, numbers);
    return answer;
}

}  // namespace

RandomScene random_scene(std::uint32_t seed) {
    RandomNumbers numbers(seed);
    View view = random_view(numbers);
    Growing grown{view, numbers};
    const std::size_t kind = seed % (kinds.size() + 1);
    if (kind < kinds.size()) {
        kinds[kind](grown);
    } else {
        numbers.one_of(kinds)(grown);
        numbers.one_of(kinds)(grown);
    }
    return {std::move(grown.scene), std::move(view)};
}

Frame random_answers(const RandomScene& of, RandomNumbers& numbers) {
    Frame frame({of.view.width, of.view.height});
    for (int y = 0; y < of.view.height; ++y)
        for (int x = 0; x < of.view.width; ++x) {
            const Shown answer = random_answer(of, x, y, numbers);
            frame.primitive.at(x, y) = answer.primitive;
            frame.camera_depth.at(x, y) = answer.depth;
        }
    return frame;
}

}  // namespace zproof::frozen
