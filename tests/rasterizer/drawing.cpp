#include "drawing.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "rasterizer/pipeline.h"

namespace zproof::rasterizer {

// NOLINTNEXTLINE(readability-function-size): x and y of three corners
Triangle at_pixels(float x0, float y0, float x1, float y1, float x2, float y2) {
    return {glm::vec3{x0, -y0, -1}, glm::vec3{x1, -y1, -1}, glm::vec3{x2, -y2, -1}};
}

Scene scene_of(const std::vector<Triangle>& triangles) {
    Scene scene;
    for (const Triangle& triangle : triangles) {
        const auto first = std::uint32_t(scene.vertices.position_world.size());
        for (const glm::vec3& p : triangle) scene.vertices.position_world.push_back(p);
        scene.triangles.push_back({first, first + 1, first + 2});
    }
    return scene;
}

View raster_view(int width, int height) {
    View view{.name = "raster", .camera = {}, .width = width, .height = height};
    view.camera.projection = Projection::parallel;
    view.camera.window = {.left = 0, .right = double(width), .bottom = -double(height), .top = 0};
    view.camera.near_depth = 0.5;
    view.camera.far_depth = 100;
    return view;
}

std::string picture(const std::vector<Triangle>& triangles, int width, int height, const Rules& rules) {
    Plane<int> hits({width, height});
    for (const Triangle& triangle : triangles) {
        const Frame frame = render_by(rules, scene_of({triangle}), raster_view(width, height));
        for (std::size_t i = 0; i < hits.pixels().size(); ++i) {
            hits.pixels()[i] += frame.primitive.pixels()[i] != PrimitiveId::none;
        }
    }
    std::string text = "\n";
    for (int y = 0; y < height; ++y) {
        for (const int h : hits.row(y)) text += h ? char('0' + h) : '.';
        text += '\n';
    }
    return text;
}

std::string all_ones(int width, int height) {
    std::string text = "\n";
    for (int y = 0; y < height; ++y) text += std::string(std::size_t(width), '1') + '\n';
    return text;
}

std::string ids(const Frame& frame) {
    std::string text = "\n";
    for (int y = 0; y < frame.size().height; ++y) {
        for (const PrimitiveId id : frame.primitive.row(y)) {
            text += id == PrimitiveId::none ? '.' : char('0' + int(static_cast<std::uint32_t>(id)));
        }
        text += '\n';
    }
    return text;
}

double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * (double(random()) / 0x1p32);
}

std::vector<Triangle> random_triangles(std::mt19937& random, int count, glm::dvec3 low, glm::dvec3 high) {
    std::vector<Triangle> triangles(static_cast<std::size_t>(count));
    for (Triangle& triangle : triangles) {
        for (glm::vec3& p : triangle) {
            for (int k = 0; k < 3; ++k) p[k] = float(uniform(random, low[k], high[k]));
        }
    }
    return triangles;
}

bool same_bits(const Frame& a, const Frame& b) {
    const auto bits = [](float f) { return std::bit_cast<std::uint32_t>(f); };
    return a.size() == b.size() && std::ranges::equal(a.primitive.pixels(), b.primitive.pixels()) &&
           std::ranges::equal(a.camera_depth.pixels(), b.camera_depth.pixels(), {}, bits, bits);
}

}  // namespace zproof::rasterizer
