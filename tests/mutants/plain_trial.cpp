// Runs the plain renderer of tests/mutants/plain, for tests/mutants/score_plain.
//
//     plain_trial modes        their names, and what they promise, one a line
//     plain_trial MODE ...     the rest as try_suite says
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "frame/precision_text.h"
#include "tests/mutants/plain/render.h"
#include "tests/mutants/suite_trial.h"

namespace {

using namespace zproof;

template <class V>
plain::Vec3<typename V::value_type> array_of(const V& v) {
    return {v.x, v.y, v.z};
}

/// As the baked scene's file has it: each primitive with positions of its own.
plain::Primitive primitive_of(const Scene& scene, const Part& part) {
    const auto* first = scene.triangles.data() + part.first_triangle;
    plain::Primitive primitive;
    std::uint32_t low = 0xFFFF'FFFF, high = 0;
    for (const glm::uvec3* t = first; t < first + part.triangle_count; ++t) {
        low = std::min({low, t->x, t->y, t->z});
        high = std::max({high, t->x, t->y, t->z});
        primitive.indices.insert(primitive.indices.end(), {t->x, t->y, t->z});
    }
    for (std::uint32_t& index : primitive.indices) index -= low;
    for (std::uint32_t i = low; i <= high && part.triangle_count > 0; ++i)
        primitive.positions.push_back(array_of(scene.vertices.position_world[i]));
    return primitive;
}

plain::Mesh mesh_of(const Scene& scene) {
    plain::Mesh mesh;
    if (scene.parts.empty() && !scene.triangles.empty())
        mesh.push_back(primitive_of(
            scene, {.node = {}, .mesh = {}, .triangle_count = std::uint32_t(scene.triangles.size())}));
    for (const Part& part : scene.parts) mesh.push_back(primitive_of(scene, part));
    return mesh;
}

plain::Camera camera_of(const View& view) {
    const Camera& camera = view.camera;
    const Window& window = camera.window;
    return {.projection = camera.projection == Projection::parallel ? plain::Projection::parallel
                                                                    : plain::Projection::perspective,
            .eye = array_of(camera.eye_world),
            .right = array_of(camera.right),
            .up = array_of(camera.up),
            .back = array_of(camera.back),
            .window = {window.left, window.right, window.bottom, window.top},
            .near = camera.near_depth,
            .far = camera.far_depth,
            .shear_x = camera.shear.x,
            .shear_y = camera.shear.y,
            .width = view.width,
            .height = view.height};
}

Frame frame_of(const plain::Picture& picture) {
    Frame frame({picture.width, picture.height});
    std::ranges::transform(picture.ids, frame.primitive.pixels().begin(),
                           [](std::uint32_t id) { return PrimitiveId{id}; });
    std::ranges::copy(picture.depths, frame.camera_depth.pixels().begin());
    return frame;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    for (const plain::Mode& mode : plain::modes()) {
        if (words == std::vector<std::string>{"modes"})
            std::cout << mode.name << ' ' << mode.precision << '\n';
        if (words.empty() || words[0] != mode.name) continue;
        const auto render = [&](const Scene& scene, const View& view) {
            return frame_of(mode.render(mesh_of(scene), camera_of(view)));
        };
        if (try_suite({words.begin() + 1, words.end()},
                      {render, precision_from_word(std::string(mode.precision))}))
            return 0;
    }
    if (words == std::vector<std::string>{"modes"}) return 0;
    std::cerr << "usage: see the head of tests/mutants/plain_trial.cpp\n";
    return 2;
}
