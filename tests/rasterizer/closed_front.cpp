#include "closed_front.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <ostream>
#include <tuple>
#include <vector>

#include "drawing.h"
#include "rasterizer/pipeline.h"

namespace zproof::rasterizer {
namespace {

constexpr int image_side = 32;

glm::vec3 at_raster(double x, double y) { return glm::vec3{glm::dvec3{x, -y, -1}}; }

/// Triangles from the hub, vertex 0, to each two neighbours of a closed rim.
Scene fan_of(const std::vector<glm::vec3>& hub_and_rim) {
    Scene scene;
    scene.vertices.position_world.assign(hub_and_rim.begin(), hub_and_rim.end());
    const auto rim = std::uint32_t(hub_and_rim.size() - 1);
    for (std::uint32_t i = 0; i < rim; ++i) scene.triangles.push_back({0, 1 + i, 1 + (i + 1) % rim});
    return scene;
}

/// Two triangles for each cell of a lattice whose points are numbered row by row.
void add_cells(Scene& scene, std::uint32_t columns, std::uint32_t rows) {
    for (std::uint32_t j = 0; j + 1 < rows; ++j) {
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
            scene.triangles.push_back({a, b, c});
            scene.triangles.push_back({b, d, c});
        }
    }
}

/// Points from before the image to behind it, in order.
std::vector<double> places_along(std::mt19937& random) {
    std::vector<double> places{-8};
    while (places.back() < image_side + 8) {
        const double last = places.back(), gap = std::pow(10.0, uniform(random, -5, 0.3));
        const double kind = uniform(random, 0, 1);
        if (kind < 0.1)
            places.push_back(last);
        else if (kind < 0.3)
            places.push_back(std::floor(last + 0.5) + 0.5);
        else
            places.push_back(last + gap);
    }
    return places;
}

/// The points of a box's surface by their place on an n x n x n lattice, each made once.
class BoxMesh {
  public:
    BoxMesh(std::mt19937& random, double half_side) : half_side_(half_side) {
        for (auto& axis : ticks_) {
            for (int i = 0; i <= cells; ++i) {
                const double jitter = i % cells ? uniform(random, -0.4, 0.4) : 0;
                axis.push_back(float(half_side * (2 * (i + jitter) / cells - 1)));
            }
        }
    }

    Scene surface() {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {0, cells}) add_face(axis, side);
        }
        return scene_;
    }

  private:
    static constexpr int cells = 5;

    std::uint32_t vertex(const glm::ivec3& at) {
        auto& positions = scene_.vertices.position_world;
        const auto next = std::uint32_t(positions.size());
        const auto [place, is_new] = number_.try_emplace(std::tuple{at.x, at.y, at.z}, next);
        if (is_new)
            positions.push_back(
                {ticks_[0][std::size_t(at.x)], ticks_[1][std::size_t(at.y)], ticks_[2][std::size_t(at.z)]});
        return place->second;
    }

    void add_face(int axis, int side) {
        const auto corner = [&](int i, int j) {
            glm::ivec3 at;
            at[axis] = side;
            at[(axis + 1) % 3] = i;
            at[(axis + 2) % 3] = j;
            return vertex(at);
        };
        for (int j = 0; j < cells; ++j) {
            for (int i = 0; i < cells; ++i) {
                const auto a = corner(i, j), b = corner(i + 1, j), c = corner(i, j + 1),
                           d = corner(i + 1, j + 1);
                scene_.triangles.push_back({a, b, c});
                scene_.triangles.push_back({b, d, c});
            }
        }
    }

    double half_side_;
    std::array<std::vector<float>, 3> ticks_;
    std::map<std::tuple<int, int, int>, std::uint32_t> number_;
    Scene scene_;
};

glm::dvec3 direction(std::mt19937& random) {
    for (;;) {
        const glm::dvec3 v{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
        if (const double length = glm::length(v); length > 0.1 && length < 1) return v / length;
    }
}

}  // namespace

Front fan_through_centres(int hub, int reach) {
    const double centre = hub + 0.5;
    std::vector<glm::vec3> points{at_raster(centre, centre)};
    const auto add = [&](int dx, int dy) { points.push_back(at_raster(centre + dx, centre + dy)); };
    for (int i = -reach; i < reach; ++i) add(i, -reach);
    for (int i = -reach; i < reach; ++i) add(reach, i);
    for (int i = reach; i > -reach; --i) add(i, reach);
    for (int i = reach; i > -reach; --i) add(-reach, i);
    return {fan_of(points), raster_view(image_side, image_side)};
}

Front sheared_grid(glm::ivec2 u, glm::ivec2 v) {
    // The image's corners in lattice coordinates, by Cramer's rule.
    const double det = u.x * v.y - u.y * v.x;
    int reach = 0;
    for (const glm::dvec2 corner :
         {glm::dvec2{0, 0}, {image_side, 0}, {0, image_side}, {image_side, image_side}}) {
        const double i = (corner.x * v.y - corner.y * v.x) / det, j = (u.x * corner.y - u.y * corner.x) / det;
        reach = std::max({reach, int(std::abs(i)) + 2, int(std::abs(j)) + 2});
    }
    Scene scene;
    for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
            const glm::ivec2 p = i * u + j * v;
            scene.vertices.position_world.push_back(at_raster(p.x + 0.5, p.y + 0.5));
        }
    }
    add_cells(scene, std::uint32_t(2 * reach + 1), std::uint32_t(2 * reach + 1));
    return {scene, raster_view(image_side, image_side)};
}

Front slivers(std::mt19937& random, Direction direction) {
    Scene scene;
    std::array<std::vector<double>, 2> places{places_along(random), places_along(random)};
    const std::size_t count = std::min(places[0].size(), places[1].size());
    for (std::size_t side = 0; side < 2; ++side) {
        places[side].resize(count);
        places[side].back() = image_side + 8;
        const double across = side ? image_side + 1 : -1;
        for (const double along : places[side]) {
            scene.vertices.position_world.push_back(
                direction == Direction::across ? at_raster(along, across) : at_raster(across, along));
        }
    }
    add_cells(scene, std::uint32_t(count), 2);
    return {scene, raster_view(image_side, image_side)};
}

Front far_fan(std::mt19937& random) {
    const auto hub_at = [&] {
        const double place = uniform(random, 0, image_side);
        return random() % 2 ? std::floor(place) + 0.5 : place;
    };
    const double x = hub_at(), y = hub_at();
    std::vector<glm::vec3> points{at_raster(x, y)};
    const int spokes = 8 + int(random() % 32);
    const double turn = uniform(random, 0, 1);
    for (int i = 0; i < spokes; ++i) {
        const double angle = 2 * std::numbers::pi * (i + turn) / spokes;
        const double away = std::pow(10.0, uniform(random, 2.5, 7));
        points.push_back(at_raster(x + away * std::cos(angle), y + away * std::sin(angle)));
    }
    return {fan_of(points), raster_view(image_side, image_side)};
}

Front box_from_inside(std::mt19937& random) {
    const double half_side = std::pow(10.0, uniform(random, -2, 4));
    Front front{BoxMesh(random, half_side).surface(), {}};
    const glm::dvec3 eye = 0.8 * half_side * direction(random) * uniform(random, 0, 1);
    const glm::dvec3 ahead = direction(random);
    front.view = {.name = "inside",
                  .camera = look_at(eye, eye + half_side * ahead, direction(random)),
                  .width = image_side,
                  .height = image_side};
    const double zoom = std::pow(10.0, uniform(random, -2, 0.3));
    front.view.camera.window = {.left = -zoom, .right = zoom, .bottom = -zoom, .top = zoom};
    front.view.camera.near_depth = 0.05 * half_side;  // at least 0.2 half_side / |(2, 2, 1)| is free
    front.view.camera.far_depth = 8 * half_side;
    return front;
}

Flaws flaws_of(const Front& front, const Rules& rules) {
    const Plane<std::uint32_t> fragments = count_fragments(rules, front.scene, front.view);
    Flaws flaws;
    for (const std::uint32_t hits : fragments.pixels()) {
        flaws.holes += hits == 0;
        flaws.double_hits += hits > 1 ? hits - 1 : 0;
    }
    return flaws;
}

void PrintTo(const Flaws& flaws, std::ostream* out) {
    *out << flaws.holes << " holes, " << flaws.double_hits << " double hits";
}

}  // namespace zproof::rasterizer
