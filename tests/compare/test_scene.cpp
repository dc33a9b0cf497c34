#include "test_scene.h"

#include <algorithm>

#include "compare/adjudicate/triangle_search.h"

namespace zproof {

namespace {

glm::vec3 position(const View& view, const Corner& c) {
    const double scale = view.camera.projection == Projection::perspective ? c.depth : 1;
    return glm::vec3(glm::dvec3(c.x * scale, -c.y * scale, -c.depth));
}

}  // namespace

View pixel_view(Projection projection, int width, int height) {
    View view{.name = "by_hand", .camera = {}, .width = width, .height = height};
    view.camera.projection = projection;
    view.camera.window = {.left = 0, .right = double(width), .bottom = -double(height), .top = 0};
    view.camera.near_depth = 0.25;
    view.camera.far_depth = projection == Projection::perspective ? 1024 : 64;
    return view;
}

Scene scene_of(const View& view, const std::vector<Triangle>& triangles) {
    Scene scene;
    scene.name = "by_hand";
    for (const Triangle& triangle : triangles) {
        const auto first = std::uint32_t(scene.vertices.position_world.size());
        for (const Corner& c : triangle) scene.vertices.position_world.push_back(position(view, c));
        scene.triangles.emplace_back(first, first + 1, first + 2);
    }
    return scene;
}

Triangle wall(double depth) { return {{{-64, -64, depth}, {192, -64, depth}, {-64, 192, depth}}}; }

Triangle wall_left_of(double x, double depth, double top, double bottom) {
    return {{{x, top, depth}, {x, bottom, depth}, {-512, 8, depth}}};
}

Triangle wall_right_of(double x, double depth, double top, double bottom) {
    return {{{x, top, depth}, {512, 8, depth}, {x, bottom, depth}}};
}

Triangle transposed(Triangle triangle) {
    for (Corner& corner : triangle) std::swap(corner.x, corner.y);
    return triangle;
}

Precision raster_precision() {
    return RasterPrecision{.transform = Arithmetic::float64,
                           .subpixel_bits = 8,
                           .snap = Snap::nearest,
                           .interpolation = Arithmetic::float64,
                           .depth_roundings = 1};
}

Precision ray_precision() { return RayPrecision{.arithmetic = Arithmetic::float32}; }

void answer(Frame& frame, int x, int y, std::uint32_t triangle, double depth) {
    frame.primitive.at(x, y) = PrimitiveId(triangle);
    frame.camera_depth.at(x, y) = float(depth);
}

void answer_background(Frame& frame, int x, int y) {
    frame.primitive.at(x, y) = PrimitiveId::none;
    frame.camera_depth.at(x, y) = background_depth;
}

void answer_everywhere(Frame& frame, std::uint32_t triangle, double depth) {
    std::ranges::fill(frame.primitive.pixels(), PrimitiveId(triangle));
    std::ranges::fill(frame.camera_depth.pixels(), float(depth));
}

TestScene::TestScene(Projection projection, int width, int height, const std::vector<Triangle>& triangles)
    : view(pixel_view(projection, width, height)),
      scene(scene_of(view, triangles)),
      candidate({width, height}),
      reference({width, height}) {}

double TestScene::candidate_eps_px(int x, int y, std::uint32_t triangle) const {
    const ViewBounds bounds(view, candidate_precision);
    const double own = own_eps_px(scene, view, bounds, {x, y}, PrimitiveId(triangle));
    SearchPixel search_pixel{x, y, own, {}};
    find_nearby_triangles(scene, view, {}, std::span(&search_pixel, 1));
    return neighbourhood_of(scene, view, bounds, search_pixel, own).eps_px;
}

}  // namespace zproof
