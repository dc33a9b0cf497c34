/// Grows a baked scene, part by part. Every part owns its vertices: no vertex is used by two parts.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "scenes/loaded.h"

namespace zproof::suite {

class MeshBuilder {
  public:
    explicit MeshBuilder(std::string scene_name);

    /// Vertices and triangles from here on belong to a new part with a material of this linear colour.
    void begin_part(const std::string& node, const glm::vec3& base_color);

    /// Adds a vertex, rounded to float32 (never -0), and returns its index.
    std::uint32_t vertex(const glm::dvec3& p_world);

    /// The vertices must belong to the current part.
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    /// Triangles a b c and a c d: a corner of the quad after the other.
    void quad(const std::array<std::uint32_t, 4>& corners);

    /// The shapes have vertices of their own, shared with nobody.
    void lone_triangle(const std::array<glm::dvec3, 3>& p_world);
    void lone_quad(const std::array<glm::dvec3, 4>& p_world);

    /// Vertices and triangles of the current part that nobody has written yet.
    struct Room {
        std::uint32_t first_vertex;
        std::span<glm::vec3> p_world;  ///< to be rounded as vertex() does
        std::span<glm::uvec3> triangles;
    };
    /// Makes room for so many at once. To be filled before anything else is added.
    Room room_for(std::size_t vertices, std::size_t triangles);

    /// The scene, with the views to judge it from. The builder is empty afterwards.
    Loaded finish(std::vector<View> views);

  private:
    Scene scene_;
    std::uint32_t first_vertex_of_part_ = 0;
};

}  // namespace zproof::suite
