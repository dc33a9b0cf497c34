#include "measure/flat.h"

namespace zproof::measure {

View flat_view(Projection projection, double eye_depth, const Bracket& near_and_far) {
    View view{.name = "flat", .camera = {}, .width = 2, .height = 2 * lane_count};
    view.camera.eye_world = {0, 0, float(eye_depth)};
    view.camera.projection = projection;
    view.camera.window = {.left = -1, .right = 1, .bottom = -lane_count, .top = lane_count};
    view.camera.near_depth = near_and_far.low;
    view.camera.far_depth = near_and_far.high;
    return view;
}

void add_flat(Scene& scene, const View& view, int lane, Half half, float z) {
    const float side = half == Half::left ? -1.0f : 1.0f;
    const float unit = view.camera.projection == Projection::parallel ? 1.0f : view.camera.eye_world.z - z;
    const float y = float(lane_count - row_of(lane)) - 0.5f;  // of the row's centre, in the window
    const auto first = std::uint32_t(scene.vertices.position_world.size());
    for (const glm::vec2 corner : {glm::vec2{0, y - 1}, glm::vec2{0, y + 1}, glm::vec2{4 * side, y}})
        scene.vertices.position_world.push_back({unit * corner.x, unit * corner.y, z});
    scene.triangles.push_back({first, first + 1, first + 2});
}

}  // namespace zproof::measure
