#include "scenes/suite/mesh_builder.h"

#include <cassert>
#include <utility>

namespace zproof::suite {

MeshBuilder::MeshBuilder(std::string scene_name) { scene_.name = std::move(scene_name); }

void MeshBuilder::begin_part(const std::string& node, const glm::vec3& base_color) {
    Part part;
    part.node = node;
    part.mesh = scene_.name;
    part.primitive = static_cast<int>(scene_.parts.size());
    part.first_triangle = static_cast<std::uint32_t>(scene_.triangles.size());
    part.material = static_cast<int>(scene_.materials.size());
    scene_.parts.push_back(std::move(part));
    Material material;
    material.name = node;
    material.base_color_factor = glm::vec4(base_color, 1.0f);
    scene_.materials.push_back(std::move(material));
    first_vertex_of_part_ = static_cast<std::uint32_t>(scene_.vertices.position_world.size());
}

std::uint32_t MeshBuilder::vertex(const glm::dvec3& p_world) {
    scene_.vertices.position_world.push_back(glm::vec3(p_world) + 0.0f);
    return static_cast<std::uint32_t>(scene_.vertices.position_world.size() - 1);
}

void MeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    assert(!scene_.parts.empty());
    for ([[maybe_unused]] const std::uint32_t v : {a, b, c})
        assert(v >= first_vertex_of_part_ && v < scene_.vertices.position_world.size());
    scene_.triangles.emplace_back(a, b, c);
    ++scene_.parts.back().triangle_count;
}

void MeshBuilder::quad(const std::array<std::uint32_t, 4>& corners) {
    triangle(corners[0], corners[1], corners[2]);
    triangle(corners[0], corners[2], corners[3]);
}

void MeshBuilder::lone_triangle(const std::array<glm::dvec3, 3>& p_world) {
    const std::uint32_t a = vertex(p_world[0]);
    vertex(p_world[1]);
    vertex(p_world[2]);
    triangle(a, a + 1, a + 2);
}

void MeshBuilder::lone_quad(const std::array<glm::dvec3, 4>& p_world) {
    const std::uint32_t a = vertex(p_world[0]);
    for (std::size_t i = 1; i < 4; ++i) vertex(p_world[i]);
    quad({a, a + 1, a + 2, a + 3});
}

MeshBuilder::Room MeshBuilder::room_for(std::size_t vertices, std::size_t triangles) {
    assert(!scene_.parts.empty());
    const auto grow = [](auto& values, std::size_t count) {
        const std::size_t first = values.size();
        values.reserve(first + count);
        values.resize(first + count);
        return std::span{values}.subspan(first);
    };
    Room room{static_cast<std::uint32_t>(scene_.vertices.position_world.size()),
              grow(scene_.vertices.position_world, vertices), grow(scene_.triangles, triangles)};
    scene_.parts.back().triangle_count += static_cast<std::uint32_t>(triangles);
    return room;
}

Loaded MeshBuilder::finish(std::vector<View> views) {
    return {std::exchange(scene_, Scene{}), std::move(views)};
}

}  // namespace zproof::suite
