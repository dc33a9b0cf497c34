// The plain renderer as a program of docs/renderer-contract.md, for what no frame shows: zproof measure finds
// it.
//
//     plain_program MODE SCENE.glb CAMERA.json OUT.exr
#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "examples/contract/zproof_contract.h"
#include "tests/mutants/plain/render.h"

namespace {

plain::Vec3<double> array_of_vector(const zproof_contract::Vec3& v) { return {v.x, v.y, v.z}; }

plain::Mesh mesh_of_triangles(const std::vector<zproof_contract::Triangle>& triangles) {
    plain::Primitive primitive;
    for (const zproof_contract::Triangle& triangle : triangles)
        for (const zproof_contract::Vec3& corner : triangle) {
            primitive.indices.push_back(std::uint32_t(primitive.positions.size()));
            primitive.positions.push_back(plain::rounded<float>(array_of_vector(corner)));
        }
    return {primitive};
}

plain::Camera plain_camera(const zproof_contract::Camera& camera) {
    return {.projection = camera.perspective ? plain::Projection::perspective : plain::Projection::parallel,
            .eye = plain::rounded<float>(array_of_vector(camera.eye)),
            .right = array_of_vector(camera.right),
            .up = array_of_vector(camera.up),
            .back = array_of_vector(camera.back),
            .window = {camera.left, camera.right_edge, camera.bottom, camera.top},
            .near = camera.near,
            .far = camera.far,
            .shear_x = camera.shear_x,
            .shear_y = camera.shear_y,
            .width = camera.width,
            .height = camera.height};
}

const plain::Mode& mode_of(std::string_view name) {
    const auto mode = std::ranges::find(plain::modes(), name, &plain::Mode::name);
    if (mode == plain::modes().end()) throw std::runtime_error("no such mode");
    return *mode;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    return zproof_contract::run(argc - 1, argv + 1, [&](const auto& triangles, const auto& camera) {
        const plain::Picture picture =
            mode_of(argv[1]).render(mesh_of_triangles(triangles), plain_camera(camera));
        zproof_contract::Frame frame(camera.width, camera.height);
        frame.id = picture.ids;
        frame.depth = picture.depths;
        return frame;
    });
}
