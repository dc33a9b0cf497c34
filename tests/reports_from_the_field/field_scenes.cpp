#include "tests/reports_from_the_field/field_scenes.h"

#include <array>
#include <cmath>
#include <numbers>

namespace zproof::field_reports {

namespace {

constexpr double pi = std::numbers::pi;

/// Adds parts, each of quads.
class Builder {
  public:
    void begin(const std::string& node, int material) {
        scene_.parts.push_back({.node = node,
                                .mesh = node,
                                .primitive = 0,
                                .first_triangle = std::uint32_t(scene_.triangles.size()),
                                .triangle_count = 0,
                                .material = material,
                                .node_index = int(scene_.parts.size())});
    }
    std::uint32_t vertex(const glm::dvec3& p) {
        scene_.vertices.position_world.push_back(glm::vec3(p));
        return std::uint32_t(scene_.vertices.position_world.size()) - 1;
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        scene_.triangles.push_back({a, b, c});
        ++scene_.parts.back().triangle_count;
    }
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        triangle(a, b, c);
        triangle(a, c, d);
    }
    /// A net of columns x rows quads through place(column, row).
    template <class Place>
    void net(int columns, int rows, const Place& place) {
        const std::uint32_t first = std::uint32_t(scene_.vertices.position_world.size());
        for (int r = 0; r <= rows; ++r)
            for (int c = 0; c <= columns; ++c) vertex(place(c, r));
        const auto at = [&](int c, int r) { return first + std::uint32_t(r * (columns + 1) + c); };
        for (int r = 0; r < rows; ++r)
            for (int c = 0; c < columns; ++c) quad(at(c, r), at(c + 1, r), at(c + 1, r + 1), at(c, r + 1));
    }
    void box(const glm::dvec3& low, const glm::dvec3& high) {
        const auto at = [&](int k) {
            return glm::dvec3(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
        };
        std::array<std::uint32_t, 8> v{};
        for (int k = 0; k < 8; ++k) v[std::size_t(k)] = vertex(at(k));
        quad(v[4], v[5], v[7], v[6]);
        quad(v[1], v[0], v[2], v[3]);
        quad(v[5], v[1], v[3], v[7]);
        quad(v[0], v[4], v[6], v[2]);
        quad(v[6], v[7], v[3], v[2]);
        quad(v[0], v[1], v[5], v[4]);
    }
    Scene done(const std::string& name) {
        scene_.name = name;
        scene_.materials.resize(2);
        return std::move(scene_);
    }

  private:
    Scene scene_;
};

}  // namespace

Scene one_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    Builder builder;
    builder.begin("triangle", 0);
    for (const glm::vec3& p : {a, b, c}) builder.vertex(glm::dvec3(p));
    builder.triangle(0, 1, 2);
    return builder.done("one triangle");
}

Scene square_ahead(float depth, float half_side) {
    Builder builder;
    builder.begin("square", 0);
    builder.net(1, 1, [half = double(half_side), depth](int c, int r) {
        return glm::dvec3((2 * c - 1) * half, (2 * r - 1) * half, -depth);
    });
    return builder.done("square");
}

Scene yard() {
    Builder builder;
    builder.begin("ground", 0);
    builder.net(8, 8, [](int c, int r) { return glm::dvec3(c - 4.1, 0, 3.7 - r); });
    builder.begin("ball", 1);
    builder.net(16, 10, [](int c, int r) {
        const double east = 2 * pi * c / 16, north = pi * (r - 5) / 10.3;
        return glm::dvec3(0.2 + 0.8 * std::cos(north) * std::sin(east), 0.9 + 0.8 * std::sin(north),
                          0.8 * std::cos(north) * std::cos(east) - 0.3);
    });
    builder.begin("chest", 0);
    builder.box({-2.3, 0, -1.9}, {-1.2, 1.3, -0.8});
    builder.begin("crate", 1);
    builder.box({0.9, 0, 0.7}, {1.5, 0.45, 1.4});
    builder.begin("post", 0);
    builder.box({-0.95, 0, 0.9}, {-0.85, 2.2, 1.0});
    return builder.done("yard");
}

Scene hills(int n) {
    Builder builder;
    builder.begin("hills", 0);
    builder.net(n, n, [n](int c, int r) {
        const double x = 8.0 * c / n - 4, z = 4 - 8.0 * r / n;
        return glm::dvec3(x, 0.3 * std::sin(2 * x) * std::cos(1.5 * z) + 0.2 * std::sin(5 * z + x), z);
    });
    return builder.done("hills");
}

View view_ahead(double yfov_degrees, int width, int height, double near_depth, double far_depth) {
    View view{.name = "ahead", .camera = {}, .width = width, .height = height};
    view.camera.window = symmetric_window(yfov_degrees * pi / 180, double(width) / height);
    view.camera.near_depth = near_depth;
    view.camera.far_depth = far_depth;
    return view;
}

View parallel_view_ahead(double half_width, double half_height, int width, int height, double near_depth,
                         double far_depth) {
    View view = view_ahead(60, width, height, near_depth, far_depth);
    view.camera.projection = Projection::parallel;
    view.camera.window = {-half_width, half_width, -half_height, half_height};
    return view;
}

View view_of_yard(int width, int height) {
    View view = view_ahead(50, width, height, 0.1, 60);
    const Camera aimed = look_at({2.1, 1.9, 4.3}, {-0.2, 0.9, -0.2}, {0, 1, 0});
    view.camera.eye_world = aimed.eye_world;
    view.camera.right = aimed.right;
    view.camera.up = aimed.up;
    view.camera.back = aimed.back;
    return view;
}

View parallel_view_of_yard(double half_width, double half_height, int width, int height) {
    View view = view_of_yard(width, height);
    view.camera.projection = Projection::parallel;
    view.camera.window = {-half_width, half_width, -half_height, half_height};
    return view;
}

}  // namespace zproof::field_reports
